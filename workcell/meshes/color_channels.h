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

/// Collects colours as files write them, red, green, blue: of 0 to 1 or of 0 to 255. Where the format does not say
/// which, the greatest number of the file does.
class ColorChannels {
 public:
  /// The colour of element `index`; the elements before it that got none have none. Numbers that are negative or not
  /// finite are invalid colours and are counted.
  void set(std::size_t index, const std::array<double, 3>& channels);

  /// A colour each for `count` elements, or nothing where no element has one. `full` is the number for full intensity
  /// (1); without it 1 where no channel is above 1, else 255. What is above it is cut to 1.
  std::vector<Color> take(std::size_t count, std::optional<double> full) &&;

  /// Whose colours they are, for the report.
  enum class Of { kVertices, kFaces };
  void report(Of of, Diagnostics& diagnostics) const;

 private:
  std::vector<Color> channels_;
  float greatest_ = 0.0f;
  std::size_t refused_ = 0;
};

/// The colour of a triangle between corners of these colours: their mean; none where a corner has none.
Color meanColor(std::span<const Color> colors);

}  // namespace hapticell::workcell
