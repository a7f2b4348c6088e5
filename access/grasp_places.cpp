// SPDX-License-Identifier: Apache-2.0
#include "access/grasp_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "collision/queries/mesh_search.h"

namespace hapticell::access {

namespace {

/// m: places nearer than this are one. Half: twice as many to try; twice: sides of small parts are not told apart.
constexpr double kSameGrasp = 5e-3;
/// m: a part of this size is taken between two fingers. Half: caps are taken by the whole hand; twice: blocks between
/// two fingers.
constexpr double kPinched = 0.06;
/// m: what a hand goes round. ANSUR II's grip of a small woman is about 45 mm inside diameter, hands close over
/// twice that. Half: bottles are held flat; twice: buckets are gripped.
constexpr double kGripped = 0.09;

/// Where the unit is met from outside towards its middle; beside a hole the nearest point.
dvec3 metAt(const RemovalUnit& unit, const dvec3& into_W) {
  const double far = glm::length(unit.bounds_W.size()) + 0.01;
  const dvec3 from_W = unit.bounds_W.center() - far * into_W;
  double along = std::numeric_limits<double>::infinity(), near = along;
  dvec3 nearest_W = from_W;
  for (const RemovalUnit::Part& part : unit.parts) {
    const auto& mesh = *part.part->mesh.collider;
    const Pose X_PW = part.X_WP.inverse();
    const collision::RayHit hit = collision::castRay(mesh, X_PW * from_W, X_PW.rotate(into_W));
    if (hit.found) along = std::min(along, hit.along);
    const auto point = collision::nearestPoint(mesh, X_PW * from_W);
    if (point.distance >= near) continue;
    near = point.distance;
    nearest_W = part.X_WP * point.p_MQ;
  }
  return std::isfinite(along) ? from_W + along * into_W : nearest_W;
}

void add(std::vector<GraspPlace>& places, const RemovalUnit& unit, const dvec3& into_W, const Tool& tool) {
  const dvec3 p_W = metAt(unit, into_W);
  const bool known = std::any_of(places.begin(), places.end(), [&](const GraspPlace& one) {
    return glm::length(one.p_WPart - p_W) < kSameGrasp && glm::dot(one.target.into_W, into_W) > 0.9;
  });
  if (!known) places.push_back({{p_W - tool.length * into_W, into_W}, p_W});
}

}  // namespace

std::vector<GraspPlace> graspPlaces(const RemovalUnit& unit, const Tool& tool) {
  std::vector<GraspPlace> places;
  if (unit.parts.empty()) return places;
  add(places, unit, {0.0, 0.0, -1.0}, tool);
  const dmat3 R = unit.parts[0].X_WP.R();
  for (int i = 0; i < 3; ++i) {
    add(places, unit, -R[i], tool);
    add(places, unit, R[i], tool);
  }
  return places;
}

std::string_view graspFor(const RemovalUnit& unit, const Tool& tool) {
  if (tool.length > 0.0) return "power";
  const dvec3 size = unit.bounds_W.size();
  std::array<double, 3> sides{size.x, size.y, size.z};
  std::sort(sides.begin(), sides.end());
  if (sides[2] <= kPinched) return "pinch";
  return sides[1] <= kGripped ? "power" : "flat";
}

}  // namespace hapticell::access
