// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/meshes/raw_mesh.h"

namespace hapticell::workcell {

/// Collects colours from files, as red, green, blue in 0 to 1 or in 0 to 255. If the format does not define which, the
/// largest number of the file decides.
class ColorChannels {
 public:
  /// Sets the colour of element `index`; earlier elements without a colour stay without. Numbers that are negative or
  /// not finite are invalid colours and are counted.
  void set(std::size_t index, const std::array<double, 3>& channels);

  /// One colour for each of `count` elements, or an empty list if no element has one. `full` is the number for full
  /// intensity (1); without it, 1 if no channel exceeds 1, else 255. Larger values are limited to 1.
  std::vector<Color> take(std::size_t count, std::optional<double> full) &&;

  /// What has these colours, for the report.
  enum class Of { kVertices, kFaces };
  void report(Of of, Diagnostics& diagnostics) const;

 private:
  std::vector<Color> channels_;
  float greatest_ = 0.0f;
  std::size_t refused_ = 0;
};

/// The colour of a triangle whose corners have these colours: their mean; no colour if a corner has none.
Color meanColor(std::span<const Color> colors);

}  // namespace hapticell::workcell
