// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/viewport/meshes/display_mesh.h"

namespace hapticell::app {

/// Triangles of a display mesh, for distance queries. Boxes over ranges of a Morton order: quick to build, in single
/// precision. Any thread.
class SurfaceTree {
 public:
  /// `vertices` must outlive it.
  SurfaceTree(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> indices);
  /// Distance from p to the nearest triangle, metres. Once it is known to be `enough` or less, the distance of any such
  /// triangle may be returned. Infinite without triangles. `near` speeds up queries for neighbouring points: set it to
  /// 0 at first, then pass what the last call left in it.
  double distance(const fvec3& p, double enough, std::size_t& near) const;
  /// Its triangles, ordered so that neighbours in space are adjacent; three indices each.
  const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  struct Box {
    fvec3 low{1e30f}, high{-1e30f};
  };
  float squaredToLeaf(const fvec3& p, std::size_t leaf) const;
  const std::vector<DisplayVertex>& vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<Box> boxes_;  ///< A heap: 1 is the root; the leaves begin at first_leaf_.
  std::size_t first_leaf_ = 1;
};

/// Largest distance of the triangles of `from` from the surface, metres, at least `least`. Samples their corners,
/// middles and, for large ones, points between; of very many small ones, only some.
double deviation(const std::vector<DisplayVertex>& vertices, std::span<const std::uint32_t> from,
                 const SurfaceTree& surface, double least);

}  // namespace hapticell::app
