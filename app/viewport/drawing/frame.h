// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "app/viewport/scene/camera.h"
#include "app/viewport/drawing/detail_level.h"
#include "app/viewport/scene/render_item.h"
#include "app/viewport/scene/section_plane.h"

namespace hapticell::app {

/// Colours of the picture, sRGB, 0 to 1.
struct FrameColors {
  fvec3 background_top{0.2f}, background_bottom{0.1f};
  glm::vec4 grid{0.5f}, crease{0.0f};
  fvec3 selected{0.2f, 0.6f, 1.0f}, hovered{0.7f}, near_miss{1.0f, 0.87f, 0.4f}, contact{1.0f, 0.42f, 0.27f};
  float floor_shadow = 0.4f;
  /// Colours of pair sets with their own colours (RenderItem::state says which set); the first entry is the theme's.
  struct SetColors {
    fvec3 contact{1.0f, 0.42f, 0.27f}, near_miss{1.0f, 0.87f, 0.4f};
  };
  std::array<SetColors, kSetColors> set_colors{};
};

/// All data that one picture of the scene depends on.
struct Frame {
  Camera camera;
  int width = 1, height = 1;  ///< Device pixels.
  double pixel_ratio = 1.0;
  FrameColors colors;
  std::vector<RenderItem> items;
  geometry::Bounds bounds_W;  ///< Of the whole scene.
  std::optional<SectionPlane> section;
  DetailLevel detail = DetailLevel::kFull;
  /// If the parts have more triangles, they are drawn coarser, up to kMostPixels, and those under kBoxPixels as boxes,
  /// except parts that keep their shape. Not for pictures at rest.
  std::size_t most_triangles = static_cast<std::size_t>(-1);
  bool edges = true;
  bool floor = true;        ///< The grid and the shadows on it.
  bool shaded = true;       ///< False: faces hidden, edges only.
  bool refine = false;      ///< The picture is at rest: its samples are averaged.
  int band = 0, bands = 1;  ///< A refined sample may be drawn in horizontal bands, one per call.
  int sample = 0;           ///< 0: a new picture; n: one more sample of the same one, averaged into it.
};

/// Edge of the picture's large floor cells, metres: 0.5, times powers of ten for a far or near eye.
double floorCell(const Camera& camera);

/// A unit direction in W towards the key light: above, from the front and the left.
dvec3 keyLightDirection_W();

/// X_WM with the item's scale and the mesh's centre as a matrix: transforms display vertices to W.
glm::dmat4 worldFromDisplay(const RenderItem& item, const dvec3& center_M);

/// The frame's section plane in the coordinates of `world_from_model` as (n, d): points with dot(n, p) <= d are drawn.
/// Without a section plane, and for what is drawn over the scene, nothing is cut.
glm::vec4 sectionInModel(const Frame& frame, const RenderItem& item, const glm::dmat4& world_from_model);

/// Position of the i-th sample within a pixel, -0.5 to 0.5 (Halton, bases 2 and 3); the first is the middle.
glm::dvec2 samplePlace(int sample);

}  // namespace hapticell::app
