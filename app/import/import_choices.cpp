// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_choices.h"

#include <QLocale>
#include <QObject>
#include <array>
#include <cmath>
#include <utility>

namespace hapticell::app {

QualityMeasure measureOf(MeshQuality quality) {
  switch (quality) {
    case MeshQuality::kCoarse:
      return {1e-3, 0.5};
    case MeshQuality::kFine:
      return {6e-5, 0.15};
    case MeshQuality::kMedium:
      break;
  }
  return {2.5e-4, 0.3};
}

workcell::ImportOptions optionsOf(const ImportChoices& choices) {
  const QualityMeasure measure = measureOf(choices.quality);
  workcell::ImportOptions options;
  options.metres_per_unit = choices.metres_per_unit;
  options.up_axis = choices.up_axis;
  options.relative_chord = measure.relative_chord;
  options.tessellation.angle = measure.angle;
  options.merge = choices.merge;
  options.arguments = choices.arguments;
  options.warn_about_unit = false;  // The panel says it.
  return options;
}

namespace {

/// Triangles against those of medium quality: geometric means over as1-oc-214, NIST_MBE_PMI_2, linkrods and a toothed
/// pulley, which lie within a factor of 1.6 about them.
double growthOf(MeshQuality quality) {
  switch (quality) {
    case MeshQuality::kCoarse:
      return 0.47;
    case MeshQuality::kFine:
      return 2.66;
    case MeshQuality::kMedium:
      break;
  }
  return 1.0;
}

}  // namespace

ImportEstimate estimate(const ImportEstimate& known, MeshQuality known_quality, MeshQuality wanted) {
  const double from = growthOf(known_quality), to = growthOf(wanted);
  // The share of medium quality's time that grows with its triangles: the same parts. By trial. Half, twice: the shown
  // time of other qualities is off by as much.
  constexpr double kMeshing = 0.3;
  ImportEstimate result;
  result.chord = known.chord * measureOf(wanted).relative_chord / measureOf(known_quality).relative_chord;
  result.triangles = known.triangles * to / from;
  result.seconds = known.seconds * (1.0 - kMeshing + kMeshing * to) / (1.0 - kMeshing + kMeshing * from);
  return result;
}

QString countText(double count) {
  QString digits = QString::number(std::llround(count));
  for (qsizetype place = digits.size() - 3; place > 0; place -= 3) digits.insert(place, QChar(0x202F));
  return digits;
}

QString durationText(double seconds) {
  if (seconds < 1.0) return QObject::tr("under 1 s");
  if (seconds < 90.0) return QObject::tr("%1 s").arg(std::lround(seconds));
  return QObject::tr("%1 min").arg(std::lround(seconds / 60.0));
}

QString unitText(double metres_per_unit) {
  const std::array<std::pair<double, QString>, 5> known{{{1.0, QObject::tr("metre")},
                                                         {0.01, QObject::tr("centimetre")},
                                                         {0.001, QObject::tr("millimetre")},
                                                         {0.0254, QObject::tr("inch")},
                                                         {0.3048, QObject::tr("foot")}}};
  for (const auto& [metres, name] : known)
    if (std::abs(metres_per_unit / metres - 1.0) < 1e-6) return name;
  return QObject::tr("%1 m").arg(metres_per_unit, 0, 'g', 4);
}

QString sizeText(qint64 bytes) {
  return QLocale::c().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
}

}  // namespace hapticell::app
