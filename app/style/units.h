// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// Units and numbers of decimals in which the window shows numbers. A value; internally, everything is SI.
struct Units {
  enum class Length { kMillimetre, kCentimetre, kMetre, kInch };
  enum class Angle { kDegree, kRadian };
  Length length = Length::kMillimetre;
  Angle angle = Angle::kDegree;
  int length_decimals = 1;
  int angle_decimals = 1;
  int force_decimals = 1;
  bool operator==(const Units&) const = default;

  double perMetre() const;   ///< Number of the chosen length units in a metre.
  double perRadian() const;  ///< Number of the chosen angle units in a radian.
  QString lengthUnit() const;
  QString angleUnit() const;
};

/// The units that the user chose; the application owns them, like its palette. GUI thread.
Units unitsNow();
/// Changes them; every ValueField and every new text shows them from then on.
void setUnitsNow(const Units& units);

/// "6.4 mm", "22.8°", "1.1 N", in the units that the user chose, never with a minus zero.
QString lengthText(double metres);
/// The same with the precision of `millimetre_decimals` decimals in millimetres, whatever the user's decimals: "1510
/// mm", "1.51 m", "59.4 in" for 0.
QString lengthText(double metres, int millimetre_decimals);
QString angleText(double radians);
QString forceText(double newtons);
/// The number alone with its fixed decimals.
QString numberText(double value, int decimals);

}  // namespace hapticell::app
