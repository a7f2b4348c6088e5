// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/import_options.h"

namespace hapticell::workcell {

const char* axisName(UpAxis axis) {
  if (axis == UpAxis::kX) return "x";
  return axis == UpAxis::kY ? "y" : "z";
}

Expected<UpAxis> parseAxis(std::string_view text) {
  for (UpAxis axis : {UpAxis::kX, UpAxis::kY, UpAxis::kZ}) {
    if (text == axisName(axis)) return axis;
  }
  return makeError({.found = Text("the axis '%1'", text.substr(0, 20)), .expected = "x, y or z"});
}

}  // namespace hapticell::workcell
