// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// Triangles of a display mesh, to ask how far a point is from them. Boxes over runs of a Morton order: quickly made,
/// in single precision. Any thread.
class SurfaceTree {
 public:
  /// `vertices` must outlive it.
  SurfaceTree(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> indices);
  /// Metres from p to the nearest triangle, as far as it matters: a distance of `enough` or less may be returned for any
  /// triangle that is so near. Infinite without triangles. `near` makes it quick for points beside each other: 0 at
  /// first, then what the last call left there.
  double distance(const fvec3& p, double enough, std::size_t& near) const;
  /// Its triangles in an order in which neighbours in space follow each other, three indices each.
  const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  struct Box {
    fvec3 low{1e30f}, high{-1e30f};
  };
  float squaredToLeaf(const fvec3& p, std::size_t leaf) const;
  const std::vector<DisplayVertex>& vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<Box> boxes_;  ///< A heap: 1 is all; the leaves begin at first_leaf_.
  std::size_t first_leaf_ = 1;
};

/// How far the triangles of `from` are from the surface, metres, and `least` where it is less: their corners, middles
/// and, where they are large, points between are looked at; of very many small ones some.
double deviation(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> from,
                 const SurfaceTree& surface, double least);

}  // namespace hapticell::app
