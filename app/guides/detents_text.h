// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>
#include <vector>

namespace hapticell::app {

/// The detents of a guide as one text, in the units that the user chose: "0 20.1 °", "0 120.0 mm"; empty for none.
/// `turns`: `places` are in radians, else in metres.
QString detentsText(std::span<const double> places, bool turns);

/// Reads what the user typed there: numbers separated by spaces or semicolons, with a decimal comma or point, and a
/// unit at the end (°, deg, rad, mm, cm, m, in) or none for the units that the user chose. What is not a number is left
/// out. Text that equals what `before` was shown as gives `before` itself: rounding for display is not an edit.
std::vector<double> readDetents(const QString& text, bool turns, const std::vector<double>& before);

}  // namespace hapticell::app
