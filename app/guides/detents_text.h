// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>
#include <vector>

namespace hapticell::app {

/// The places where a guide snaps in as one text, in the units in force: "0 20.1 °", "0 120.0 mm"; empty for none.
/// `turns`: radians, else metres.
QString detentsText(std::span<const double> places, bool turns);

/// What somebody has typed there: numbers with spaces or semicolons between, a comma or a point in them, and a unit
/// behind (°, deg, rad, mm, cm, m, in) or none for the units in force. What is no number is left out. Where it reads as
/// `before` was shown, `before` itself: a rounded number is no edit.
std::vector<double> readDetents(const QString& text, bool turns, const std::vector<double>& before);

}  // namespace hapticell::app
