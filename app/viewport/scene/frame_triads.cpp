// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/frame_triads.h"

#include <algorithm>
#include <array>

namespace hapticell::app {
namespace {

constexpr double kTriadLength = 0.1;                                 // m
constexpr double kTriadLeastPixels = 28.0, kTriadMostPixels = 64.0;  // Of an axis that is seen from the side.
// Nearer than this a frame is meant, as kEdgePixels of feature_picker.h. Half: hard to meet; twice: parts behind it
// cannot be clicked.
constexpr double kTriadPixels = 7.0;
constexpr double kPlainWidth = 2.0, kBoldWidth = 3.5;

dvec3 tipOf(const Pose& X_WF, int axis, double length) {
  dvec3 p_F(0.0);
  p_F[axis] = length;
  return X_WF * p_F;
}

double distanceToAxis(const glm::dvec2& p, const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dvec2 along = to - from;
  const double length2 = glm::dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(p - from, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (from + s * along));
}

template <typename Do>
void forVisibleFrames(const SceneModel& scene, Do act) {
  for (const workcell::Entity& entity : scene.entities())
    if (entity.kind() == workcell::EntityKind::kFrame && entity.visible) act(entity, scene.placement_W(entity));
}

}  // namespace

std::vector<SceneCurve> triadCurves(const Pose& X_WF, double length, const std::string& name, bool selected,
                                    double width) {
  using Role = SceneCurve::Role;
  constexpr std::array<Role, 3> kRoles{Role::kAxisX, Role::kAxisY, Role::kAxisZ};
  std::vector<SceneCurve> curves;
  for (int axis = 0; axis < 3; ++axis)
    curves.push_back({{X_WF.p, tipOf(X_WF, axis, length)},
                      kRoles[static_cast<std::size_t>(axis)],
                      SceneCurve::Style::kSolid,
                      width});
  curves.push_back(
      {{X_WF.p}, selected ? Role::kSelection : Role::kGuideOff, SceneCurve::Style::kSolid, kPlainWidth, name});
  return curves;
}

double triadLength(const dvec3& p_WF, const Camera& camera, const ViewSize& view) {
  const double metres_per_pixel = camera.metresPerPixel(p_WF, view);
  return std::clamp(kTriadLength, kTriadLeastPixels * metres_per_pixel, kTriadMostPixels * metres_per_pixel);
}

std::vector<SceneCurve> frameTriads(const SceneModel& scene, const Camera& camera, const ViewSize& view) {
  std::vector<SceneCurve> all;
  forVisibleFrames(scene, [&](const workcell::Entity& frame, const Pose& X_WF) {
    if (!camera.project(X_WF.p, view)) return;
    const bool selected = scene.isSelected(frame.id);
    const bool bold = selected || scene.hovered() == frame.id;
    const auto triad =
        triadCurves(X_WF, triadLength(X_WF.p, camera, view), frame.name, selected, bold ? kBoldWidth : kPlainWidth);
    all.insert(all.end(), triad.begin(), triad.end());
  });
  return all;
}

workcell::EntityId frameAt(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                           const glm::dvec2& pixel) {
  workcell::EntityId found = 0;
  double nearest = kTriadPixels;
  forVisibleFrames(scene, [&](const workcell::Entity& frame, const Pose& X_WF) {
    const auto origin = camera.project(X_WF.p, view);
    if (!origin) return;
    const double length = triadLength(X_WF.p, camera, view);
    for (int axis = 0; axis < 3; ++axis) {
      const auto tip = camera.project(tipOf(X_WF, axis, length), view);
      const double away = tip ? distanceToAxis(pixel, *origin, *tip) : glm::length(pixel - *origin);
      if (away < nearest) nearest = away, found = frame.id;
    }
  });
  return found;
}

std::vector<workcell::EntityId> framesIn(const SceneModel& scene, const Camera& camera, const ViewSize& view,
                                         const glm::dvec2& least, const glm::dvec2& most) {
  std::vector<workcell::EntityId> found;
  forVisibleFrames(scene, [&](const workcell::Entity& frame, const Pose& X_WF) {
    const auto p = camera.project(X_WF.p, view);
    if (p && p->x >= least.x && p->x <= most.x && p->y >= least.y && p->y <= most.y) found.push_back(frame.id);
  });
  return found;
}

}  // namespace hapticell::app
