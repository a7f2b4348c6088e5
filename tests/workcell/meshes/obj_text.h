// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "workcell/meshes/mesh_parts.h"

namespace hapticell::workcell {

/// The warnings in English.
inline std::vector<std::string> sentences(const Diagnostics& diagnostics) {
  std::vector<std::string> all;
  for (const Text& warning : diagnostics.warnings) all.push_back(english(warning));
  return all;
}

/// Whether a colour is this one.
inline testing::AssertionResult isNear(const std::optional<Color>& color, float red, float green, float blue) {
  if (!color) return testing::AssertionFailure() << "no colour";
  const Color want{red, green, blue};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs((*color)[k] - want[k]) > 1e-5f) {
      return testing::AssertionFailure() << (*color)[0] << ", " << (*color)[1] << ", " << (*color)[2];
    }
  }
  return testing::AssertionSuccess();
}

/// A tetrahedron as OBJ lines: "v" lines with `tail` behind the coordinates, then faces of the corners counted from
/// `first`.
inline std::string tetrahedron(int first, double x, const std::string& tail = "",
                               const std::string& before_faces = "") {
  std::string text;
  const double corners[4][3] = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  for (const auto& c : corners) {
    text += "v " + std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]) + tail + "\n";
  }
  text += before_faces;
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const auto& f : faces) {
    text += "f " + std::to_string(first + f[0]) + " " + std::to_string(first + f[1]) + " " +
            std::to_string(first + f[2]) + "\n";
  }
  return text;
}

}  // namespace hapticell::workcell
