// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// How an item is marked; bits of RenderItem::state and of the id buffer.
enum ItemState : std::uint32_t {
  kPlain = 0,
  kSelected = 1,
  kHovered = 2,
  kNearMiss = 4,
  kContact = 8,
  kCap = 16,  ///< Not of an item: this pixel is of the part's cut face.
};

/// Above the marks stands which pair set's colours they have: 0 the theme's, else place 1 .. 7 of
/// FrameColors::set_colors.
constexpr std::uint32_t kSetColorShift = 5;
constexpr std::size_t kSetColors = 8;

/// A shape that stands in the scene only to show what would be: another configuration, another size.
enum class Ghost : std::uint8_t {
  kNone,
  kFree,     ///< Screen door in the selection colour, dashed lines.
  kTouches,  ///< The same in the contact colour: it could not stand there.
  kOwn,      ///< The same in the item's own colour: a zone, a volume.
};

/// How one link is drawn in place of its own colour: a score, with a pattern as its second cue.
struct LinkLook {
  std::array<float, 3> color{0.7f, 0.7f, 0.7f};
  std::uint8_t pattern = 0;  ///< As RenderItem::pattern.
  bool operator==(const LinkLook&) const = default;
};

/// One mesh to draw: a solid, or a shape of a robot's link.
struct RenderItem {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  geometry::Bounds bounds_M;  ///< Of the mesh.
  Pose X_WM;
  double scale = 1.0;                            ///< Only the drawn stylus is scaled.
  std::array<float, 3> color{0.7f, 0.7f, 0.7f};  ///< sRGB, already quietened.
  workcell::EntityId entity = 0;                 ///< 0: not of the document (the stylus), cannot be picked.
  int link = -1;                                 ///< Robots: index of the link.
  std::uint32_t state = kPlain;
  bool casts_shadow = true;
  Ghost ghost = Ghost::kNone;  ///< Ghosts are neither picked nor marked and cast no shadow.
  std::uint8_t pattern = 0;    ///< Over the colour: 0 plain, 1 hatched, 2 cross-hatched (scores).
  bool smooth = false;         ///< A skin: its mesh is a PosedMesh (posed_mesh.h); drawn without lines.
  bool borderless = false;     ///< No line where it borders on the item before it, of the same entity: lips on a face.
  bool keeps_shape = false;    ///< Held, or near what is: in motion it has the detail of the picture at rest.
  bool unseen = false;         ///< Only got onto the card, to be drawn later.
  bool over_scene = false;     ///< Drawn over all that would hide it: the stylus must always be found.
};

/// The colour with its saturation (HSV) at most `limit`, about as bright as it was: parts are quiet so that states are
/// loud.
std::array<float, 3> quietened(const std::array<float, 3>& color, float limit = 0.25f);

}  // namespace hapticell::app
