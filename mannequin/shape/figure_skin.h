// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "mannequin/shape/skin_weights.h"

namespace hapticell::mannequin {

/// The skin of a figure, clothes and face included, that follows every posture: one mesh, shaped once in the bind
/// posture, whose vertices go along with a few bodies each (dual quaternions: L. Kavan and others, "Geometric skinning
/// with approximate dual quaternion blending", 2008). Nothing is made anew while it moves, so nothing crawls.
///
/// It is only looked at: collisions know the bodies' own meshes (body_shape.h); tests/mannequin/shape/figure_skin_test.cpp
/// keeps both within the distance that docs/dev/mannequin.md states.
class FigureSkin {
 public:
  /// Takes about 2 s.
  explicit FigureSkin(const Figure& figure);

  /// What belongs to one body and one layer: vertices from `first` on. Neighbours have the same vertices along their
  /// border, with the same normals.
  struct Patch {
    std::size_t body = 0;  ///< As fleshOf() counts them.
    std::array<float, 3> color{};
    bool face = false;  ///< Hair, brows, lips, eyes: on the head, in a colour of their own whatever the head's is.
    std::size_t first = 0, count = 0;
    /// Triangles over the patch's own vertices (0 is `first`): the whole, then coarser ones with the same border.
    std::vector<std::vector<std::array<std::uint32_t, 3>>> steps;
  };
  const std::vector<Patch>& patches() const { return patches_; }
  std::size_t vertexCount() const { return vertices_.size(); }
  /// How far (m) the steps' triangles are from the whole's, about.
  const std::vector<double>& stepErrors() const { return step_errors_; }

  /// Places of all vertices and their unit normals in a posture, in the frame that the posture's root is given in.
  /// Some milliseconds.
  void pose(const Posture& posture, std::vector<fvec3>& places, std::vector<fvec3>& normals) const;

 private:
  friend class SkinTailor;
  struct Vertex {
    fvec3 place, normal;
    SkinWeights weights;
    float straight = 0.0f;  ///< How much it is blended in straight lines.
  };
  std::shared_ptr<const Figure> figure_;
  std::vector<Vertex> vertices_;
  std::vector<Patch> patches_;
  std::vector<double> step_errors_;
  std::vector<SegmentPlace> bind_;
};

}  // namespace hapticell::mannequin
