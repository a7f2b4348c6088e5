// SPDX-License-Identifier: Apache-2.0
#include "access/grasp_places.h"

#include <algorithm>
#include <array>

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

void add(std::vector<GraspPlace>& places, const RemovalUnit::Part& part, const dvec3& into_W, const Tool& tool) {
  const auto& mesh = *part.part->mesh.collider;
  const geometry::Bounds& box = mesh.bounds();
  const dvec3 into_P = part.X_WP.inverse().rotate(into_W);
  const double far = glm::length(box.size()) + 0.01;
  const dvec3 from = box.center() - far * into_P;
  const collision::RayHit hit = collision::castRay(mesh, from, into_P);
  dvec3 p_P = hit.found ? hit.p_MQ : collision::nearestPoint(mesh, from).p_MQ;
  const dvec3 p_W = part.X_WP * p_P;
  const bool known = std::any_of(places.begin(), places.end(), [&](const GraspPlace& one) {
    return glm::length(one.p_WPart - p_W) < kSameGrasp && glm::dot(one.target.into_W, into_W) > 0.9;
  });
  if (!known) places.push_back({{p_W - tool.length * into_W, into_W}, p_W});
}

}  // namespace

std::vector<GraspPlace> graspPlaces(const RemovalUnit& unit, const Tool& tool) {
  std::vector<GraspPlace> places;
  const auto largest = std::max_element(unit.parts.begin(), unit.parts.end(), [](const auto& a, const auto& b) {
    return a.bounds_W.radius() < b.bounds_W.radius();
  });
  if (largest == unit.parts.end()) return places;
  add(places, *largest, {0.0, 0.0, -1.0}, tool);
  const dmat3 R = largest->X_WP.R();
  for (int i = 0; i < 3; ++i) {
    add(places, *largest, -R[i], tool);
    add(places, *largest, R[i], tool);
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
