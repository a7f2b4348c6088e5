// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "mannequin/shape/skin_weights.h"

namespace hapticell::mannequin {

/// The skin of a figure, clothes and face included, that follows every posture: one mesh, shaped once in the bind
/// posture, whose vertices each move with a few bodies (dual quaternions: L. Kavan and others, "Geometric skinning with
/// approximate dual quaternion blending", 2008). The mesh stays the same while it moves, so details do not crawl.
///
/// It is for drawing only: collisions use the bodies' own meshes (body_shape.h).
/// tests/mannequin/shape/figure_skin_test.cpp keeps both within the distance that docs/dev/mannequin.md states.
class FigureSkin {
 public:
  /// Takes about 2 s.
  explicit FigureSkin(const Figure& figure);

  /// The part of one body and one layer: vertices from `first` on. Neighbours have the same vertices with the same
  /// normals along their border.
  struct Patch {
    std::size_t body = 0;  ///< Index as in fleshOf().
    std::array<float, 3> color{};
    bool face = false;  ///< Hair, brows, lips, eyes: on the head, with a colour of their own.
    std::size_t first = 0, count = 0;
    /// Triangles over the patch's own vertices (0 is `first`): full detail, then coarser levels with the same border.
    std::vector<std::vector<std::array<std::uint32_t, 3>>> steps;
  };
  const std::vector<Patch>& patches() const { return patches_; }
  std::size_t vertexCount() const { return vertices_.size(); }
  /// Approximate distance (m) of each level from full detail.
  const std::vector<double>& stepErrors() const { return step_errors_; }

  /// Positions of all vertices and their unit normals in a posture, in the frame in which the posture's root is given.
  /// Takes some milliseconds.
  void pose(const Posture& posture, std::vector<fvec3>& places, std::vector<fvec3>& normals) const;

 private:
  friend class SkinTailor;
  struct Vertex {
    fvec3 place, normal;
    SkinWeights weights;
    float straight = 0.0f;  ///< Share of linear blending.
  };
  std::shared_ptr<const Figure> figure_;
  std::vector<Vertex> vertices_;
  std::vector<Patch> patches_;
  std::vector<double> step_errors_;
  std::vector<SegmentPlace> bind_;
};

}  // namespace hapticell::mannequin
