// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// All edges of a mesh's triangles, the uses of one edge side by side. 26 bytes a triangle.
///
/// A corner is 3 times the triangle's number plus the corner's; its edge leads to the triangle's next corner. An edge
/// from a vertex to itself is left out.
class EdgeUses {
 public:
  /// Of one edge, by one triangle. At most 700 million triangles.
  struct Use {
    std::uint32_t high = 0;  ///< The larger of the edge's vertices.
    std::uint32_t code = 0;  ///< Twice the corner, and 1 if the triangle runs from the smaller vertex to the larger.

    std::uint32_t corner() const { return code >> 1; }
    std::uint32_t triangle() const { return corner() / 3; }
    bool up() const { return (code & 1u) != 0; }
  };

  /// Indices must be below `vertices`.
  EdgeUses(std::span<const Triangle> triangles, std::size_t vertices);

  std::size_t vertices() const { return begin_.size() - 1; }
  /// Edges whose smaller vertex is `low`, by their larger vertex, then by triangle.
  std::span<const Use> at(std::size_t low) const {
    return std::span(uses_).subspan(begin_[low], begin_[low + 1] - begin_[low]);
  }

  /// Calls see(uses) for each edge whose smaller vertex is one of [first, last).
  template <typename See>
  void each(std::size_t first, std::size_t last, const See& see) const {
    for (std::size_t low = first; low < last; ++low) {
      const std::span<const Use> all = at(low);
      for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].high == all[begin].high) ++end;
        see(all.subspan(begin, end - begin));
      }
    }
  }

 private:
  std::vector<std::uint32_t> begin_;  // Of each vertex; one more at the end.
  std::vector<Use> uses_;
};

}  // namespace hapticell::geometry
