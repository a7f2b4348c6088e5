// SPDX-License-Identifier: Apache-2.0
#include "workcell/meshes/length_unit.h"

#include <algorithm>

namespace hapticell::workcell {

double metresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMillimetre:
      return 0.001;
    case LengthUnit::kInch:
      return 0.0254;
    case LengthUnit::kMetre:
      break;
  }
  return 1.0;
}

const char* unitName(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::kMillimetre:
      return "mm";
    case LengthUnit::kInch:
      return "in";
    case LengthUnit::kMetre:
      break;
  }
  return "m";
}

Expected<LengthUnit> parseLengthUnit(std::string_view text) {
  for (LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kMillimetre, LengthUnit::kInch}) {
    if (text == unitName(unit)) return unit;
  }
  return makeError({.found = Text("the unit '%1'", text.substr(0, 20)), .expected = "m, mm or in"});
}

LengthUnit guessUnit(const geometry::Bounds& bounds) {
  // m or mm: parts over 3 mm are more frequent than machines over 3 m. Our choice; unitIsOpen() asks. Half: robots of 2
  // m become 2 mm; twice: parts of 5 mm become 5 m.
  constexpr double kLargestInMetres = 3.0;
  const dvec3 size = bounds.size();
  return std::max({size.x, size.y, size.z}) > kLargestInMetres ? LengthUnit::kMillimetre : LengthUnit::kMetre;
}

bool unitIsOpen(const geometry::Bounds& bounds) {
  // mm and m: between them both units make sense, and the user is asked. Half, twice: asked too often, or guessed wrong
  // in silence.
  constexpr double kSmallestPart = 2.0, kLargestMachine = 30.0;
  const dvec3 size = bounds.size();
  const double largest = std::max({size.x, size.y, size.z});
  return largest >= kSmallestPart && largest <= kLargestMachine;
}

}  // namespace hapticell::workcell
