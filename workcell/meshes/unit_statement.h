// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace hapticell::workcell {

/// Metres per unit, if a comment of a mesh file states it. Mesh formats have no field for it, so programs write text:
/// "units: m", "UNITS=mm", "File units = inches" (SketchUp), "This file uses centimeters as units for non-parametric
/// coordinates." (Maya), "units millimetres; ...", "1 unit = 1 mm", "dimensions are in mm". Empty for any other text;
/// units of other quantities ("units: m/s") do not count. Only the first 256 bytes are read.
std::optional<double> statedUnit(std::string_view comment);

}  // namespace hapticell::workcell
