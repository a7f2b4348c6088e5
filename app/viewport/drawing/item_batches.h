// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gpu_mesh.h"

namespace hapticell::app {

/// Items of one mesh and one look, drawn by one call.
struct ItemBatch {
  GpuMesh* mesh = nullptr;
  std::size_t step = 0;                          ///< Of the mesh's detail.
  unsigned set_color = 0;                        ///< Hatched items: whose colour.
  unsigned pattern = 0;                          ///< Over the colour, as RenderItem::pattern.
  std::optional<std::array<float, 3>> own = {};  ///< The colour of ghosts that have their own.
  bool over_scene = false;
  bool box = false;                  ///< `mesh` is the unit box: each item is drawn as the box around it.
  std::vector<std::uint32_t> items;  ///< Indices into the frame's, the nearest first.
};

/// Which items a pass draws.
enum class ItemKind { kPlain, kHatched, kGhost, kTouchingGhost, kOwnGhost };

/// The items of a kind that the eye may see, those that share mesh, detail and look together; the nearest batch first:
/// what lies behind is not shaded then. Meshes that are not ready yet are left out.
std::vector<ItemBatch> batchesOf(const Frame& frame, const glm::dmat4& clip_from_world, ItemKind kind,
                                 GpuMeshCache& meshes);

/// What turns the vertices that are drawn for an item of the batch into W.
glm::dmat4 worldFromDrawn(const ItemBatch& batch, const RenderItem& item);

/// The items that cast shadows, in as few batches; `metres_per_texel` says how fine they must be.
std::vector<ItemBatch> shadowBatches(const Frame& frame, double metres_per_texel, GpuMeshCache& meshes);

/// True when no point of the sphere (p_WC, radius in metres) is between the sides of the view.
bool isOutside(const glm::dmat4& clip_from_world, const dvec3& p_WC, double radius);

/// One use of a mesh, as the graphics card gets it.
struct ItemInstance {
  glm::vec4 rows[3];     ///< The affine map from the mesh's own coordinates to the eye's (or the light's).
  fvec3 albedo{0.0f};    ///< Linear (gamma 2).
  std::uint32_t id = 0;  ///< As the id buffer holds it.
};
static_assert(sizeof(ItemInstance) == 64);

/// The frame's section in another space as (n, d): drawn is where dot(n, p) <= d. Without a section nothing is cut.
glm::vec4 sectionIn(const Frame& frame, const glm::dmat4& space_from_world);

/// The first three rows of an affine matrix.
void setRows(ItemInstance& instance, const glm::dmat4& matrix);

}  // namespace hapticell::app
