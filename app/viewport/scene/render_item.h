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
  kCap = 16,  ///< Not for items: this pixel is on a part's cut face.
};

/// The bits above the marks say which pair set's colours the marks have: 0 the theme's, else index 1 to 7 of
/// FrameColors::set_colors.
constexpr std::uint32_t kSetColorShift = 5;
constexpr std::size_t kSetColors = 8;

/// A shape that the scene shows only as a possibility: another configuration, another size.
enum class Ghost : std::uint8_t {
  kNone,
  kFree,     ///< Stippled in the selection colour, dashed lines.
  kTouches,  ///< The same in the contact colour: it would collide there.
  kOwn,      ///< The same in the item's own colour: a zone, a volume.
};

/// How one link is drawn in place of its own colour: a score, with a pattern to show it without colour too.
struct LinkLook {
  std::array<float, 3> color{0.7f, 0.7f, 0.7f};
  std::uint8_t pattern = 0;  ///< As in RenderItem::pattern.
  bool operator==(const LinkLook&) const = default;
};

/// One mesh to draw: a solid, or a shape of a robot's link.
struct RenderItem {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  geometry::Bounds bounds_M;  ///< Of the mesh.
  Pose X_WM;
  double scale = 1.0;                            ///< Only the drawn stylus is scaled.
  std::array<float, 3> color{0.7f, 0.7f, 0.7f};  ///< sRGB, saturation already reduced.
  workcell::EntityId entity = 0;                 ///< 0: not in the document (the stylus), cannot be picked.
  int link = -1;                                 ///< For robots: index of the link.
  std::uint32_t state = kPlain;
  bool casts_shadow = true;
  Ghost ghost = Ghost::kNone;  ///< Ghosts cannot be picked or marked, and cast no shadow.
  std::uint8_t pattern = 0;    ///< Over the colour: 0 plain, 1 hatched, 2 cross-hatched (scores).
  bool smooth = false;         ///< A skin: its mesh is a PosedMesh (posed_mesh.h); drawn without lines.
  bool borderless = false;     ///< No line at the border to the item before it, of the same entity: lips on a face.
  bool keeps_shape = false;    ///< Held, or near what is held: drawn in motion with the detail of the picture at rest.
  bool unseen = false;         ///< Only uploaded, to be drawn later.
  bool over_scene = false;     ///< Drawn over everything that would hide it: the stylus must always be visible.
};

/// The colour with its saturation (HSV) reduced to at most `limit`, about as bright as before: parts are quiet so that
/// states stand out.
std::array<float, 3> quietened(const std::array<float, 3>& color, float limit = 0.25f);

}  // namespace hapticell::app
