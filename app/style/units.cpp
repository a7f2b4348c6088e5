// SPDX-License-Identifier: Apache-2.0
#include "app/style/units.h"

#include <QApplication>
#include <QLocale>
#include <QVariant>
#include <QWidget>
#include <cmath>
#include <numbers>

#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr const char* kProperty = "hapticellUnits";

/// How many decimals more than in millimetres say the same.
int decimalsBeyondMillimetres(Units::Length length) {
  if (length == Units::Length::kMillimetre) return 0;
  return length == Units::Length::kMetre ? 3 : 1;
}

}  // namespace

double Units::perMetre() const {
  switch (length) {
    case Length::kMillimetre:
      return 1000.0;
    case Length::kCentimetre:
      return 100.0;
    case Length::kMetre:
      return 1.0;
    case Length::kInch:
      return 1.0 / 0.0254;
  }
  return 1000.0;
}

double Units::perRadian() const {
  return angle == Angle::kDegree ? 180.0 / std::numbers::pi : 1.0;
}

QString Units::lengthUnit() const {
  switch (length) {
    case Length::kMillimetre:
      return QStringLiteral("mm");
    case Length::kCentimetre:
      return QStringLiteral("cm");
    case Length::kMetre:
      return QStringLiteral("m");
    case Length::kInch:
      return QStringLiteral("in");
  }
  return {};
}

QString Units::angleUnit() const {
  return angle == Angle::kDegree ? QStringLiteral("°") : QStringLiteral("rad");
}

Units unitsNow() {
  const QCoreApplication* application = QCoreApplication::instance();
  const QVariantList list = application ? application->property(kProperty).toList() : QVariantList();
  if (list.size() != 5) return {};
  return {static_cast<Units::Length>(list[0].toInt()), static_cast<Units::Angle>(list[1].toInt()), list[2].toInt(),
          list[3].toInt(), list[4].toInt()};
}

void setUnitsNow(const Units& units) {
  QCoreApplication* application = QCoreApplication::instance();
  if (!application || units == unitsNow()) return;
  application->setProperty(kProperty, QVariantList{static_cast<int>(units.length), static_cast<int>(units.angle),
                                                   units.length_decimals, units.angle_decimals, units.force_decimals});
  for (QWidget* widget : QApplication::allWidgets()) {
    if (auto* field = qobject_cast<ValueField*>(widget)) field->unitsChanged();
    widget->update();
  }
}

QString numberText(double value, int decimals) {
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
  return QString::number(value, 'f', decimals);
}

QString lengthText(double metres) {
  const Units units = unitsNow();
  return numberText(units.perMetre() * metres, units.length_decimals) + QLatin1Char(' ') + units.lengthUnit();
}

QString lengthText(double metres, int millimetre_decimals) {
  const Units units = unitsNow();
  const int decimals = millimetre_decimals + decimalsBeyondMillimetres(units.length);
  return numberText(units.perMetre() * metres, decimals) + QLatin1Char(' ') + units.lengthUnit();
}

QString angleText(double radians) {
  const Units units = unitsNow();
  const QString number = numberText(units.perRadian() * radians, units.angle_decimals);
  return units.angle == Units::Angle::kDegree ? number + units.angleUnit()
                                              : number + QLatin1Char(' ') + units.angleUnit();
}

QString forceText(double newtons) {
  return numberText(newtons, unitsNow().force_decimals) + QStringLiteral(" N");
}

}  // namespace hapticell::app
