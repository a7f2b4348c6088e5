// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_facts.h"

#include <QFile>
#include <QFileInfo>

#include "app/import/preview_picture.h"
#include "workcell/meshes/length_unit.h"

namespace hapticell::app {

QString formatText(const std::string& format, const QString& path) {
  const QString name = QString::fromStdString(format).toUpper();
  if (format == "gltf") return QStringLiteral("glTF");
  if (format == "dae") return QStringLiteral("Collada");
  if (format != "step") return name;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return name;
  const QByteArray head = file.read(20000);
  const QByteArray schema = head.mid(head.indexOf("FILE_SCHEMA"), 200).toUpper();
  if (schema.contains("AP242")) return name + QStringLiteral(" AP242");
  if (schema.contains("AUTOMOTIVE_DESIGN")) return name + QStringLiteral(" AP214");
  if (schema.contains("CONFIG_CONTROL_DESIGN")) return name + QStringLiteral(" AP203");
  return name;
}

ImportFacts factsOf(const workcell::ImportResult& result, const QString& path, QSize picture_size) {
  ImportFacts facts;
  const workcell::ImportReport& report = result.report;
  facts.format = formatText(report.format, path);
  facts.bytes = QFileInfo(path).size();
  facts.metres_per_unit = facts.likely_metres_per_unit = report.metres_per_unit;
  facts.unit_is_stated = report.unit_is_stated;
  facts.up_axis = report.up_axis;
  facts.parts = report.parts;
  facts.triangles = report.triangles;
  facts.chord = report.chord;
  facts.can_be_cut_finer = report.chord > 0.0;
  facts.robot = result.entities.size() == 1 && result.entities[0].robot() != nullptr;
  facts.arguments = report.arguments;
  const geometry::Bounds bounds = exactBounds_W(result.entities);
  if (!bounds.isEmpty()) facts.size = bounds.size();
  if (!report.unit_is_stated && !bounds.isEmpty()) {
    const geometry::Bounds in_units{bounds.min / report.metres_per_unit, bounds.max / report.metres_per_unit};
    facts.likely_metres_per_unit = workcell::metresPer(workcell::guessUnit(in_units));
    facts.unit_is_open = workcell::unitIsOpen(in_units);
  }
  facts.picture = previewPicture(result.entities, picture_size);
  return facts;
}

}  // namespace hapticell::app
