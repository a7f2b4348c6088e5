// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/shapes/bounds.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// What one unit of a file means.
enum class LengthUnit { kMetre, kMillimetre, kInch };

/// 1, 0.001 or 0.0254.
double metresPer(LengthUnit unit);

/// "m", "mm" or "in".
const char* unitName(LengthUnit unit);

/// The unit of "m", "mm" or "in"; an error for any other word.
Expected<LengthUnit> parseLengthUnit(std::string_view text);

/// What the numbers of a file that names no unit most likely mean, from the size of its box in the file's own units:
/// metres up to a largest edge of 3, millimetres above. A guess to show to the user, never to act upon in silence (a 27
/// m conveyor in metres is guessed wrongly).
LengthUnit guessUnit(const geometry::Bounds& bounds);

/// True where such a box makes sense in metres and in millimetres (a largest edge of 2 to 30 units: a conveyor of 3 m
/// or a pin of 3 mm): then only the user knows.
bool unitIsOpen(const geometry::Bounds& bounds);

}  // namespace hapticell::workcell
