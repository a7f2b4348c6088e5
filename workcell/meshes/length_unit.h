// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/shapes/bounds.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

/// The meaning of one unit in a file.
enum class LengthUnit { kMetre, kMillimetre, kInch };

/// 1, 0.001 or 0.0254.
double metresPer(LengthUnit unit);

/// "m", "mm" or "in".
const char* unitName(LengthUnit unit);

/// The unit of "m", "mm" or "in"; an error for any other word.
Expected<LengthUnit> parseLengthUnit(std::string_view text);

/// The most likely unit of a file that states none, from the size of its box in the file's own units: metres up to a
/// largest edge of 3, millimetres above. A guess to show to the user, never to apply silently (it is wrong for a 27 m
/// conveyor in metres).
LengthUnit guessUnit(const geometry::Bounds& bounds);

/// True if such a box is plausible both in metres and in millimetres (a largest edge of 2 to 30 units: a conveyor of 3
/// m or a pin of 3 mm): then only the user knows.
bool unitIsOpen(const geometry::Bounds& bounds);

}  // namespace hapticell::workcell
