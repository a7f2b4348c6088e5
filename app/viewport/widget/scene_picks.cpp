// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/scene_picks.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/view_picture.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// Picks a side of the box: finds large faces that have no corner in it. Half: narrow ones are missed; twice: four times
// the time.
constexpr int kProbes = 9;
// Corners of a mesh looked at. Half: a part that reaches in by few is missed; twice: time.
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

// Pixels by which parts are tried for a corner beside their shape; over kVertexPixels. Half: corners seen from outside
// are missed; twice: time.
constexpr double kSnapPixels = 12.0;

glm::dvec2 pixelOf(const QPointF& p) {
  return {p.x(), p.y()};
}

/// The ray comes so near to the sphere about the item's box.
bool passesNear(const RenderItem& item, const Ray& ray_W, double room) {
  const dvec3 to_center = item.X_WM * item.bounds_M.center() - ray_W.origin_W;
  const dvec3 beside = to_center - glm::dot(to_center, ray_W.direction_W) * ray_W.direction_W;
  return glm::length(beside) <= item.bounds_M.radius() + room;
}

}  // namespace

std::optional<PickedPoint> ScenePicks::pickAt(const QPointF& position) {
  const double ratio = view_.devicePixelRatioF();
  return picture_.pick(static_cast<int>(position.x() * ratio), static_cast<int>(position.y() * ratio));
}

workcell::EntityId ScenePicks::entityAt(const QPointF& position) {
  if (const auto frame = frameAt(view_.scene(), view_.camera(), view_.viewSize(), pixelOf(position))) return frame;
  const auto picked = pickAt(position);
  return picked ? picked->entity : 0;
}

dvec3 ScenePicks::pointUnder(const QPointF& position) {
  if (const auto picked = pickAt(position)) return picked->p_WQ;
  // Over the background: the point of the ray at the depth of the target.
  const Ray ray = view_.camera().rayThrough(pixelOf(position), view_.viewSize());
  const double depth = glm::dot(view_.camera().target_W - ray.origin_W, view_.camera().forward_W());
  return ray.origin_W + depth / glm::dot(ray.direction_W, view_.camera().forward_W()) * ray.direction_W;
}

std::optional<PickedFeature> ScenePicks::featureNear(const QPointF& position,
                                                     const std::vector<workcell::EntityId>& without,
                                                     const FeatureFilter& filter) {
  const Frame frame = view_.makeFrame();
  const Ray ray_W = view_.camera().rayThrough(pixelOf(position), view_.viewSize());
  std::optional<PickedFeature> nearest;
  double nearest_along = std::numeric_limits<double>::infinity();
  for (const RenderItem& item : frame.items) {
    if (item.entity == 0 || item.ghost != Ghost::kNone || item.over_scene) continue;
    if (std::find(without.begin(), without.end(), item.entity) != without.end()) continue;
    if (!passesNear(item, ray_W,
                    kSnapPixels * view_.camera().metresPerPixel(item.X_WM * item.bounds_M.center(), view_.viewSize())))
      continue;
    const auto found = picker_.pick({&frame.items, item.entity, item.link, view_.camera(), view_.viewSize(),
                                     pixelOf(position), filter, view_.section()});
    const double along = found ? glm::dot(found->p_WHit - ray_W.origin_W, ray_W.direction_W) : nearest_along;
    if (along < nearest_along) nearest_along = along, nearest = found;
  }
  return nearest;
}

std::optional<PickedFeature> ScenePicks::featureAt(const QPointF& position, const FeatureFilter& filter) {
  const auto seen = pickAt(position);
  if (!seen || seen->entity == 0) return std::nullopt;
  const Frame frame = view_.makeFrame();
  return picker_.pick({&frame.items, seen->entity, seen->link, view_.camera(), view_.viewSize(), pixelOf(position),
                       filter, view_.section()});
}

void ScenePicks::hover(const std::optional<PickedFeature>& feature) {
  hovered_ = feature;
  view_.update();
}

void ScenePicks::start(PickRequest request) {
  cancel();
  open_ = std::move(request);
  view_.setCursor(Qt::CrossCursor);
  view_.setFocus(Qt::OtherFocusReason);
  view_.update();
}

void ScenePicks::cancel() {
  answer(std::nullopt);
}

void ScenePicks::answer(const std::optional<PickedFeature>& feature) {
  if (!open_) return;
  const PickRequest request = std::move(*open_);
  open_.reset();
  hovered_.reset();
  view_.unsetCursor();
  view_.update();
  if (request.done) request.done(feature);
}

std::vector<workcell::EntityId> ScenePicks::entitiesIn(const QRectF& box, bool touching) {
  std::vector<workcell::EntityId> known, left_out, reached;
  const auto has = [](const auto& ids, auto id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (const RenderItem& item : view_.makeFrame().items) {
    if (item.entity == 0 || item.ghost != Ghost::kNone || item.over_scene) continue;
    const Seen seen = look(item, view_.camera(), view_.viewSize(), box, touching);
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
      framesIn(view_.scene(), view_.camera(), view_.viewSize(), {box.left(), box.top()}, {box.right(), box.bottom()});
  for (const auto id : known)
    if (!has(left_out, id) || has(reached, id)) result.push_back(id);
  return result;
}

}  // namespace hapticell::app
