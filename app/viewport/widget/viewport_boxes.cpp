// SPDX-License-Identifier: Apache-2.0
// What a box drawn over the scene holds.
#include <algorithm>
#include <cmath>

#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kProbes = 9;  // Picks a side of the box: finds large faces that have no corner in it.
constexpr std::size_t kMostVertices = 20000;

struct Seen {
  bool inside = true, reaches = false;
};

/// Whether all corners of the item's box, and whether any vertex of it, lie in the box of the view.
Seen look(const RenderItem& item, const Camera& camera, const ViewSize& size, const QRectF& box, bool touching) {
  Seen seen;
  const auto holds = [&](const dvec3& p_M) {
    const auto pixel = camera.project(item.X_WM * p_M, size);
    return pixel && box.contains(QPointF(pixel->x, pixel->y));
  };
  for (int i = 0; i < 8; ++i) {
    const auto& b = item.bounds_M;
    const bool in = holds({(i & 1) ? b.max.x : b.min.x, (i & 2) ? b.max.y : b.min.y, (i & 4) ? b.max.z : b.min.z});
    seen.inside = seen.inside && in;
  }
  if (!touching || !item.mesh) return seen;
  const auto& vertices = item.mesh->vertices;
  const std::size_t step = vertices.size() / kMostVertices + 1;
  for (std::size_t i = 0; i < vertices.size() && !seen.reaches; i += step) seen.reaches = holds(vertices[i]);
  return seen;
}

}  // namespace

std::vector<workcell::EntityId> ViewportWidget::entitiesIn(const QRectF& box, bool touching) {
  std::vector<workcell::EntityId> known, left_out, reached;
  const auto has = [](const auto& ids, auto id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (const RenderItem& item : makeFrame().items) {
    if (item.entity == 0 || item.ghost != Ghost::kNone || item.over_scene) continue;
    const Seen seen = look(item, camera_, viewSize(), box, touching);
    if (!has(known, item.entity)) known.push_back(item.entity);
    if (!seen.inside && !has(left_out, item.entity)) left_out.push_back(item.entity);
    if (seen.reaches && !has(reached, item.entity)) reached.push_back(item.entity);
  }
  for (int i = 0; touching && i < kProbes * kProbes; ++i) {
    const int row = i / kProbes, column = i % kProbes;
    const double right = (0.5 + column) / kProbes, down = (0.5 + row) / kProbes;
    const auto id = entityAt(box.topLeft() + QPointF(right * box.width(), down * box.height()));
    if (id != 0 && !has(reached, id)) reached.push_back(id);
  }
  std::vector<workcell::EntityId> result =
      framesIn(scene_, camera_, viewSize(), {box.left(), box.top()}, {box.right(), box.bottom()});
  for (const auto id : known)
    if (!has(left_out, id) || has(reached, id)) result.push_back(id);
  return result;
}

}  // namespace hapticell::app
