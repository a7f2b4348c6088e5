// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/item_batches.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <tuple>

#include "app/viewport/meshes/detail_steps.h"

namespace hapticell::app {
namespace {

ItemKind kindOf(const RenderItem& item) {
  if (item.ghost == Ghost::kOwn) return ItemKind::kOwnGhost;
  if (item.ghost != Ghost::kNone) return item.ghost == Ghost::kTouches ? ItemKind::kTouchingGhost : ItemKind::kGhost;
  return (item.state & kContact) != 0 ? ItemKind::kHatched : ItemKind::kPlain;
}

/// Pixels are finest where the item is nearest to the eye.
double metresPerPixel(const Frame& frame, const dvec3& p_WC, double radius) {
  const ViewSize size{static_cast<double>(frame.width), static_cast<double>(frame.height)};
  const dvec3 eye = frame.camera.eye_W(), forward = frame.camera.forward_W();
  if (!frame.camera.perspective) return frame.camera.metresPerPixel(p_WC, size);
  const double depth = glm::dot(p_WC - eye, forward) - radius;
  return depth > 0.0 ? frame.camera.metresPerPixel(eye + depth * forward, size) : 0.0;
}

/// Gathers items by what they share.
class Gathering {
 public:
  using Key = std::tuple<GpuMesh*, std::size_t, unsigned, unsigned, std::optional<std::array<float, 3>>, bool, bool>;

  void add(const Key& key, double nearness, std::uint32_t item) {
    const auto [place, fresh] = places_.try_emplace(key, batches_.size());
    if (fresh) {
      batches_.push_back({});
      auto& [mesh, step, set_color, pattern, own, over, box] = key;
      batches_.back().batch = {mesh, step, set_color, pattern, own, over, box, {}};
    }
    batches_[place->second].items.emplace_back(nearness, item);
  }

  std::vector<ItemBatch> take() {
    for (Entry& entry : batches_) {
      std::sort(entry.items.begin(), entry.items.end());
      for (const auto& [nearness, item] : entry.items) entry.batch.items.push_back(item);
    }
    std::sort(batches_.begin(), batches_.end(), [](const Entry& a, const Entry& b) { return a.items[0] < b.items[0]; });
    std::vector<ItemBatch> result;
    for (Entry& entry : batches_) result.push_back(std::move(entry.batch));
    return result;
  }

 private:
  struct Entry {
    ItemBatch batch;
    std::vector<std::pair<double, std::uint32_t>> items;
  };
  std::map<Key, std::size_t> places_;
  std::vector<Entry> batches_;
};

/// An item that is drawn, with the step of its mesh that suits its distance.
struct Seen {
  std::uint32_t item = 0;
  GpuMesh* mesh = nullptr;
  std::size_t step = 0;
  double nearness = 0.0, pixels = 0.0;  ///< `pixels`: its diameter, of the window.
  double metres_per_pixel = 0.0;        ///< In the mesh's own metres, a pixel of the window.
  bool box = false, kept = false;       ///< `kept`: stays as it is.
  std::size_t triangles() const { return box ? 12 : mesh->trianglesOf(step); }
};

/// Coarsens all until they have at most so many triangles, or as far as is allowed; then makes boxes of the small.
/// Gives how many pixels they may be off now.
double keepWithin(std::size_t most, double pixels, std::vector<Seen>& seen) {
  // Growth of the allowed error until the triangles fit: some four rounds to kMostPixels. Nearer to 1: more rounds;
  // twice: coarser than needed.
  constexpr double kStep = 1.4;
  std::size_t total = 0;
  for (const Seen& one : seen) total += one.triangles();
  const auto change = [&](Seen& one, const auto& coarsen) {
    if (one.kept || total <= most) return;
    total -= one.triangles();
    coarsen();
    total += one.triangles();
  };
  while (total > most && pixels < kMostPixels) {
    pixels = std::min(kStep * pixels, kMostPixels);
    for (Seen& one : seen)
      change(one, [&] { one.step = detailStepFor(one.mesh->steps(), one.metres_per_pixel, pixels); });
  }
  for (Seen& one : seen)
    if (one.pixels < kBoxPixels && one.triangles() > 12) change(one, [&] { one.box = true; });
  return pixels;
}

}  // namespace

bool isOutside(const glm::dmat4& clip_from_world, const dvec3& p_WC, double radius) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  for (int axis = 0; axis < 2; ++axis) {
    for (const double side : {1.0, -1.0}) {
      const glm::dvec4 plane = rows[3] + side * rows[axis];
      const double length = glm::length(dvec3(plane));
      if (glm::dot(plane, glm::dvec4(p_WC, 1.0)) < -radius * length) return true;
    }
  }
  return false;
}

namespace {

std::vector<Seen> seenItems(const Frame& frame, const glm::dmat4& clip_from_world, ItemKind kind,
                            GpuMeshCache& meshes) {
  std::vector<Seen> seen;
  const double share = drawnShare(frame.detail);
  const double allowed = allowedPixels(frame.detail), as_at_rest = allowedPixels(DetailLevel::kFull) / share;
  for (std::uint32_t i = 0; i < frame.items.size(); ++i) {
    const RenderItem& item = frame.items[i];
    if (!item.mesh || kindOf(item) != kind) continue;
    GpuMesh* mesh = meshes.of(item);
    if (!mesh || item.unseen) continue;
    const dvec3 p_WC = item.X_WM * (item.scale * mesh->bounds().center());
    const double radius = item.scale * mesh->bounds().radius();
    if (isOutside(clip_from_world, p_WC, radius)) continue;
    const double metres_per_pixel = share * metresPerPixel(frame, p_WC, radius);
    const double of_mesh = metres_per_pixel / std::max(item.scale, 1e-12);
    const double nearness =
        item.over_scene ? -1e30 : glm::dot(p_WC - frame.camera.eye_W(), frame.camera.forward_W()) - radius;
    Seen& one = seen.emplace_back();
    one.item = i;
    one.mesh = mesh;
    one.kept = item.keeps_shape || item.entity == 0;
    one.step = detailStepFor(mesh->steps(), of_mesh, one.kept ? std::min(allowed, as_at_rest) : allowed);
    one.nearness = nearness;
    one.pixels = 2.0 * radius / std::max(metres_per_pixel, 1e-12);
    one.metres_per_pixel = of_mesh;
  }
  return seen;
}

}  // namespace

std::vector<ItemBatch> batchesOf(const Frame& frame, const glm::dmat4& clip_from_world, ItemKind kind,
                                 GpuMeshCache& meshes) {
  std::vector<Seen> seen = seenItems(frame, clip_from_world, kind, meshes);
  const double off = keepWithin(frame.most_triangles, allowedPixels(frame.detail), seen);
  meshes.counted().pixels_off = std::max(meshes.counted().pixels_off, off);
  Gathering gathering;
  for (const Seen& one : seen) {
    const RenderItem& item = frame.items[one.item];
    const unsigned set_color = kind == ItemKind::kHatched ? (item.state >> kSetColorShift) % kSetColors : 0u;
    const auto own = kind == ItemKind::kOwnGhost ? std::optional(item.color) : std::nullopt;
    gathering.add({one.box ? &meshes.unitBox() : one.mesh, one.box ? 0 : one.step, set_color, item.pattern, own,
                   item.over_scene, one.box},
                  one.nearness, one.item);
  }
  return gathering.take();
}

glm::dmat4 worldFromDrawn(const ItemBatch& batch, const RenderItem& item) {
  if (!batch.box) return worldFromDisplay(item, batch.mesh->center());
  const geometry::Bounds& box = item.mesh->bounds();
  return glm::scale(worldFromDisplay(item, box.center()), glm::max(box.size(), dvec3(1e-6)));
}

std::vector<ItemBatch> shadowBatches(const Frame& frame, double metres_per_texel, GpuMeshCache& meshes) {
  Gathering gathering;
  for (std::uint32_t i = 0; i < frame.items.size(); ++i) {
    const RenderItem& item = frame.items[i];
    if (!item.casts_shadow || !item.mesh || item.unseen) continue;
    GpuMesh* mesh = meshes.of(item);
    if (!mesh) continue;
    const std::size_t step = detailStepFor(mesh->steps(), metres_per_texel / std::max(item.scale, 1e-12), 1.0);
    gathering.add({mesh, step, 0u, 0u, std::nullopt, item.over_scene, false}, 0.0, i);
  }
  return gathering.take();
}

glm::vec4 sectionIn(const Frame& frame, const glm::dmat4& space_from_world) {
  if (!frame.section) return {0.0f, 0.0f, 0.0f, 1.0f};
  const glm::dvec4 plane = glm::dvec4(frame.section->nhat_W, -frame.section->offset) * glm::inverse(space_from_world);
  return glm::vec4(dvec3(plane), -plane.w);
}

void setRows(ItemInstance& instance, const glm::dmat4& matrix) {
  const glm::dmat4 rows = glm::transpose(matrix);
  for (int i = 0; i < 3; ++i) instance.rows[i] = glm::vec4(rows[i]);
}

}  // namespace hapticell::app
