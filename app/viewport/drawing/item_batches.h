// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gpu_mesh.h"

namespace hapticell::app {

/// Items with the same mesh and look, drawn by one call.
struct ItemBatch {
  GpuMesh* mesh = nullptr;
  std::size_t step = 0;                          ///< Of the mesh's detail steps.
  unsigned set_color = 0;                        ///< For hatched items: which pair set's colour.
  unsigned pattern = 0;                          ///< Over the colour, as in RenderItem::pattern.
  std::optional<std::array<float, 3>> own = {};  ///< The colour of ghosts with an own colour.
  bool over_scene = false;
  bool box = false;                  ///< `mesh` is the unit box: each item is drawn as the box around it.
  std::vector<std::uint32_t> items;  ///< Indices into the frame's items, the nearest first.
};

/// Which items a pass draws.
enum class ItemKind { kPlain, kHatched, kGhost, kTouchingGhost, kOwnGhost };

/// The items of a kind that may be visible, grouped by mesh, detail and look; the nearest batch first, so that hidden
/// ones behind it need no shading. Leaves out meshes that are not ready yet.
std::vector<ItemBatch> batchesOf(const Frame& frame, const glm::dmat4& clip_from_world, ItemKind kind,
                                 GpuMeshCache& meshes);

/// The matrix that transforms an item's drawn vertices, in this batch, to W.
glm::dmat4 worldFromDrawn(const ItemBatch& batch, const RenderItem& item);

/// The items that cast shadows, in as few batches as possible; `metres_per_texel` gives the necessary resolution.
std::vector<ItemBatch> shadowBatches(const Frame& frame, double metres_per_texel, GpuMeshCache& meshes);

/// True when no point of the sphere (p_WC, radius in metres) is between the sides of the view.
bool isOutside(const glm::dmat4& clip_from_world, const dvec3& p_WC, double radius);

/// One instance of a mesh, in the graphics card's format.
struct ItemInstance {
  glm::vec4 rows[3];     ///< The affine map from the mesh's own coordinates to those of the eye (or the light).
  fvec3 albedo{0.0f};    ///< Linear (gamma 2).
  std::uint32_t id = 0;  ///< As in the id buffer.
};
static_assert(sizeof(ItemInstance) == 64);

/// The frame's section plane in another space as (n, d): draws points with dot(n, p) <= d. Without one, cuts nothing.
glm::vec4 sectionIn(const Frame& frame, const glm::dmat4& space_from_world);

/// Sets the first three rows of an affine matrix.
void setRows(ItemInstance& instance, const glm::dmat4& matrix);

}  // namespace hapticell::app
