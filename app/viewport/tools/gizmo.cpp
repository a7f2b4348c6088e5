// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/tools/gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hapticell::app {
namespace {

// Pixels to a handle, and to the middle; as kEdgePixels of feature_picker.h. Half: hard to meet; twice: handles
// overlap.
constexpr double kNearPixels = 8.0;
// Pixels to the middle, more than to a handle, as all handles begin there. Half: hard to meet; twice: arrows near it
// cannot be taken.
constexpr double kMiddlePixels = 11.0;
constexpr double kMiddleBox = 0.085;  // Half a side, of the arrows.
constexpr double kRing = 0.75;        // Of the arrows.
constexpr double kInner = 0.18;       // Arrows begin so far out: the middle is the tool's own.
constexpr int kRingPoints = 49;
constexpr double kTwoPi = 2.0 * std::numbers::pi;
// Sine between ray and plane, or between ray and axis, below which nothing is said: a pixel is amplified twelvefold.
// Half: it leaps; twice: handles seen from the side are dead.
constexpr double kEdgeOn = 0.08;

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + s * along));
}

double distanceToLine(const glm::dvec2& pixel, const std::vector<dvec3>& points_W, const Camera& camera,
                      const ViewSize& view) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < points_W.size(); ++i) {
    const auto a = camera.project(points_W[i], view), b = camera.project(points_W[i + 1], view);
    if (a && b) nearest = std::min(nearest, distanceToSegment(pixel, *a, *b));
  }
  return nearest;
}

}  // namespace

dvec3 Gizmo::axis_W(int axis) const {
  dvec3 unit(0.0);
  unit[axis] = 1.0;
  return X_WG.rotate(unit);
}

dvec3 Gizmo::zero_W(int axis) const {
  return axis_W((axis + 1) % 3);
}

std::vector<dvec3> Gizmo::ring_W(int axis) const {
  const dvec3 x = zero_W(axis), y = axis_W((axis + 2) % 3);
  std::vector<dvec3> points;
  for (int i = 0; i < kRingPoints; ++i) {
    const double angle = kTwoPi * i / (kRingPoints - 1);
    points.push_back(X_WG.p + kRing * size * (std::cos(angle) * x + std::sin(angle) * y));
  }
  return points;
}

std::optional<Gizmo::Handle> Gizmo::hit(const glm::dvec2& pixel, const Camera& camera, const ViewSize& view) const {
  std::optional<Handle> found;
  double nearest = kNearPixels;
  const auto center = middle ? camera.project(X_WG.p, view) : std::nullopt;
  if (center && glm::length(pixel - *center) < kMiddlePixels) return Handle{kFree, false};
  for (int axis = 0; axis < 3 && arrows; ++axis) {
    // Arrows before rings where both are near.
    const double arrow =
        distanceToLine(pixel, {X_WG.p + kInner * size * axis_W(axis), X_WG.p + size * axis_W(axis)}, camera, view);
    if (arrow < nearest) nearest = arrow, found = Handle{axis, false};
  }
  if (found) return found;
  for (int axis = 0; axis < 3 && rings; ++axis)
    if (const double ring = distanceToLine(pixel, ring_W(axis), camera, view); ring < nearest)
      nearest = ring, found = Handle{axis, true};
  return found;
}

std::optional<double> Gizmo::valueOf(const Handle& handle, const Ray& ray_W) const {
  const dvec3 a = axis_W(handle.axis);
  const dvec3& d = ray_W.direction_W;
  const double along = glm::dot(a, d);
  if (handle.turns) {
    if (std::abs(along) < kEdgeOn) return std::nullopt;
    return valueAt(handle, ray_W.origin_W + glm::dot(X_WG.p - ray_W.origin_W, a) / along * d);
  }
  // The point of the axis that is nearest to the ray.
  const double sine2 = 1.0 - along * along;
  if (sine2 < kEdgeOn * kEdgeOn) return std::nullopt;
  const dvec3 between = X_WG.p - ray_W.origin_W;
  return (along * glm::dot(d, between) - glm::dot(a, between)) / sine2;
}

double Gizmo::valueAt(const Handle& handle, const dvec3& p_W) const {
  const dvec3 from_middle = p_W - X_WG.p;
  if (!handle.turns) return glm::dot(from_middle, axis_W(handle.axis));
  return std::atan2(glm::dot(from_middle, axis_W((handle.axis + 2) % 3)), glm::dot(from_middle, zero_W(handle.axis)));
}

dvec3 Gizmo::freePoint_W(const Ray& ray_W, const Camera& camera) const {
  const dvec3 f = camera.forward_W();
  return ray_W.origin_W + glm::dot(X_WG.p - ray_W.origin_W, f) / glm::dot(ray_W.direction_W, f) * ray_W.direction_W;
}

Pose Gizmo::dragged(const Handle& handle, double from, double to, const Pose& X_WT) const {
  const dvec3 a = axis_W(handle.axis);
  if (!handle.turns) return {X_WT.p + (to - from) * a, X_WT.q};
  const dquat turn = quaternionFromRotationVector(std::remainder(to - from, kTwoPi) * a);
  return {X_WG.p + turn * (X_WT.p - X_WG.p), glm::normalize(turn * X_WT.q)};
}

std::vector<SceneCurve> Gizmo::curves(const std::optional<Handle>& active) const {
  using Role = SceneCurve::Role;
  constexpr auto kSolid = SceneCurve::Style::kSolid;
  const Role roles[3]{Role::kAxisX, Role::kAxisY, Role::kAxisZ};
  const char* const names[3]{"X", "Y", "Z"};
  std::vector<SceneCurve> curves;
  for (int axis = 0; axis < 3; ++axis) {
    const auto width = [&](bool turns) { return active && *active == Handle{axis, turns} ? 4.0 : 2.0; };
    const dvec3 tip = X_WG.p + size * axis_W(axis);
    const dvec3 back = X_WG.p + 0.86 * size * axis_W(axis);
    const dvec3 side = 0.05 * size * zero_W(axis);
    if (rings) {
      curves.push_back({ring_W(axis), roles[axis], kSolid, width(true) - 0.5});
      // Without arrows the letter stands where the ring crosses its zero direction.
      if (!arrows)
        curves.push_back({{X_WG.p, X_WG.p + kRing * size * axis_W(axis)}, roles[axis], kSolid, 1.2, names[axis]});
    }
    if (!arrows) continue;
    curves.push_back({{X_WG.p + kInner * size * axis_W(axis), tip}, roles[axis], kSolid, width(false), names[axis]});
    curves.push_back({{back + side, tip, back - side}, roles[axis], kSolid, width(false)});
  }
  if (middle) {
    const dvec3 x = kMiddleBox * size * axis_W(0), y = kMiddleBox * size * axis_W(1), z = kMiddleBox * size * axis_W(2);
    const bool held = active && active->axis == kFree;
    for (const auto& [a, b] : {std::pair{x, y}, std::pair{y, z}, std::pair{z, x}})
      curves.push_back({{X_WG.p + a + b, X_WG.p - a + b, X_WG.p - a - b, X_WG.p + a - b, X_WG.p + a + b},
                        Role::kSelection,
                        kSolid,
                        held ? 2.5 : 1.5});
  }
  return curves;
}

}  // namespace hapticell::app
