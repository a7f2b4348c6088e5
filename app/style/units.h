// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// In which units, and with how many decimals, the window shows numbers. A value; inside everything is SI.
struct Units {
  enum class Length { kMillimetre, kCentimetre, kMetre, kInch };
  enum class Angle { kDegree, kRadian };
  Length length = Length::kMillimetre;
  Angle angle = Angle::kDegree;
  int length_decimals = 1;
  int angle_decimals = 1;
  int force_decimals = 1;
  bool operator==(const Units&) const = default;

  double perMetre() const;   ///< How many of its units of length a metre has.
  double perRadian() const;  ///< The same of angle.
  QString lengthUnit() const;
  QString angleUnit() const;
};

/// Those in force, which belong to the application as its palette does; GUI thread.
Units unitsNow();
/// Changes them; every ValueField and whoever asks for texts shows them from then on.
void setUnitsNow(const Units& units);

/// "6.4 mm", "22.8°", "1.1 N", in the units in force, never a minus zero.
QString lengthText(double metres);
/// The same as finely as `millimetre_decimals` says of millimetres, whatever the user's decimals: "1510 mm", "1.51 m",
/// "59.4 in" for 0.
QString lengthText(double metres, int millimetre_decimals);
QString angleText(double radians);
QString forceText(double newtons);
/// The number alone with its fixed decimals.
QString numberText(double value, int decimals);

}  // namespace hapticell::app
