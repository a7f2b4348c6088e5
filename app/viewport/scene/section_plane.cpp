// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/section_plane.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/style/units.h"

namespace hapticell::app {
namespace {

constexpr double kHandlePixels = 54.0;
// Pixels to the handle, as kNearPixels of gizmo.cpp. Half: hard to meet; twice: parts beside it cannot be clicked.
constexpr double kNearPixels = 9.0;

dvec3 middleOn(const SectionPlane& plane, const geometry::Bounds& bounds_W) {
  const dvec3 middle = bounds_W.center();
  return middle + (plane.offset - glm::dot(plane.nhat_W, middle)) * plane.nhat_W;
}

dvec3 handleEnd(const SectionPlane& plane, const dvec3& start, const Camera& camera, const ViewSize& size) {
  return start + kHandlePixels * camera.metresPerPixel(start, size) * plane.nhat_W;
}

/// How far along the line start + s * nhat the point nearest to the ray is; nothing where they are almost parallel.
std::optional<double> alongLine(const dvec3& start, const dvec3& nhat, const Ray& ray) {
  const double cosine = glm::dot(nhat, ray.direction_W);
  const double sine2 = 1.0 - cosine * cosine;
  if (sine2 < 0.02) return std::nullopt;
  const dvec3 between = ray.origin_W - start;
  return (glm::dot(between, nhat) - cosine * glm::dot(between, ray.direction_W)) / sine2;
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 d = b - a;
  const double length2 = glm::dot(d, d);
  const double s = length2 > 0.0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + s * d));
}

}  // namespace

SectionPlane sectionAcross(int axis, const Camera& camera, const geometry::Bounds& bounds_W) {
  SectionPlane plane;
  plane.nhat_W = dvec3(0.0);
  plane.nhat_W[axis] = camera.forward_W()[axis] > 0.0 ? -1.0 : 1.0;
  plane.offset = bounds_W.isEmpty() ? 0.0 : glm::dot(plane.nhat_W, bounds_W.center());
  return plane;
}

SectionPlane sectionFacing(const Camera& camera, const geometry::Bounds& bounds_W) {
  const dvec3 look = glm::abs(camera.forward_W());
  // Cells stand on the floor: a level cut is only taken when looked at from nearly above.
  const int upright = look.x > look.y ? 0 : 1;
  return sectionAcross(look.z > 0.9 ? 2 : upright, camera, bounds_W);
}

SectionPlane flipped(const SectionPlane& plane) {
  return {-plane.nhat_W, -plane.offset};
}

int axisOf(const SectionPlane& plane) {
  const dvec3 n = glm::abs(plane.nhat_W);
  if (n.x >= n.y && n.x >= n.z) return 0;
  return n.y >= n.z ? 1 : 2;
}

std::vector<SceneCurve> sectionCurves(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                                      const ViewSize& size) {
  if (bounds_W.isEmpty()) return {};
  const int axis = axisOf(plane), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const dvec3 start = middleOn(plane, bounds_W);
  SceneCurve border;
  border.role = SceneCurve::Role::kGuideOff;
  border.style = SceneCurve::Style::kDashDot;
  for (const auto& [a, b] : {std::pair{false, false}, {true, false}, {true, true}, {false, true}, {false, false}}) {
    dvec3 corner = start;
    corner[u] = a ? bounds_W.max[u] : bounds_W.min[u];
    corner[v] = b ? bounds_W.max[v] : bounds_W.min[v];
    border.points_W.push_back(corner);
  }
  constexpr std::array kRoles{SceneCurve::Role::kAxisX, SceneCurve::Role::kAxisY, SceneCurve::Role::kAxisZ};
  SceneCurve handle;
  handle.role = kRoles[static_cast<std::size_t>(axis)];
  handle.style = SceneCurve::Style::kSolid;
  handle.width = 2.5;
  const dvec3 end = handleEnd(plane, start, camera, size);
  const auto start_seen = camera.project(start, size), end_seen = camera.project(end, size);
  // The text stands to the right of the last point: not on the handle.
  const bool leftwards = start_seen && end_seen && end_seen->x < start_seen->x;
  handle.points_W = leftwards ? std::vector{end, start} : std::vector{start, end};
  handle.text = QObject::tr("Section %1 %2").arg(QChar('X' + axis)).arg(lengthText(start[axis])).toStdString();
  SceneCurve knob = handle;
  knob.points_W = {end};
  knob.text.clear();
  return {border, handle, knob};
}

Ray fromSection(const SectionPlane& plane, Ray ray) {
  const double above = glm::dot(plane.nhat_W, ray.origin_W) - plane.offset;
  const double falling = -glm::dot(plane.nhat_W, ray.direction_W);
  if (above > 0.0 && falling > 1e-9) ray.origin_W += above / falling * ray.direction_W;
  return ray;
}

bool onSectionHandle(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                     const ViewSize& size, const glm::dvec2& pixel) {
  if (bounds_W.isEmpty()) return false;
  const dvec3 start = middleOn(plane, bounds_W);
  const auto a = camera.project(start, size), b = camera.project(handleEnd(plane, start, camera, size), size);
  return a && b && distanceToSegment(pixel, *a, *b) < kNearPixels;
}

SectionPlane draggedSection(const SectionPlane& plane, const geometry::Bounds& bounds_W, const Camera& camera,
                            const ViewSize& size, const glm::dvec2& from, const glm::dvec2& to) {
  if (bounds_W.isEmpty()) return plane;
  const dvec3 start = middleOn(plane, bounds_W);
  const auto before = alongLine(start, plane.nhat_W, camera.rayThrough(from, size));
  const auto after = alongLine(start, plane.nhat_W, camera.rayThrough(to, size));
  if (!before || !after) return plane;
  const double a = glm::dot(plane.nhat_W, bounds_W.min), b = glm::dot(plane.nhat_W, bounds_W.max);
  SectionPlane moved = plane;
  moved.offset = std::clamp(plane.offset + *after - *before, std::min(a, b), std::max(a, b));
  return moved;
}

}  // namespace hapticell::app
