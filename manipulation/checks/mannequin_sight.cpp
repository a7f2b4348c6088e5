// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/mannequin_sight.h"

#include <algorithm>
#include <map>

#include "collision/queries/mesh_search.h"

namespace hapticell::manipulation {
namespace {

struct Placed {
  const ScenePart* part = nullptr;
  Pose X_WP;
};

geometry::Bounds boundsOf(const std::vector<Placed>& parts) {
  geometry::Bounds bounds;
  for (const Placed& placed : parts)
    bounds.add(geometry::transformed(placed.X_WP, placed.part->mesh.collider->bounds()));
  return bounds;
}

/// How far along the ray (in its own length) a part is met; above 1: not before its end.
double meets(const Placed& placed, const dvec3& p_WFrom, const dvec3& way_W) {
  const Pose X_PW = placed.X_WP.inverse();
  const collision::RayHit hit = collision::castRay(*placed.part->mesh.collider, X_PW * p_WFrom, X_PW.rotate(way_W));
  return hit.found ? hit.along : 2.0;
}

/// How near anything comes to the line of sight, looked at every thirtieth of its length and up to 0.3 m.
double clearanceOf(const std::vector<Placed>& others, const dvec3& p_WFrom, const dvec3& way_W) {
  // Places along the line of sight: 3 cm apart at 1 m. Half: the clearance may be 15 mm too large at small parts;
  // twice: twice the time. What crosses the line is found by a ray in any case.
  constexpr int kPlaces = 30;
  double least = 0.3;
  for (const Placed& placed : others) {
    const Pose X_PW = placed.X_WP.inverse();
    if (meets(placed, p_WFrom, way_W) < 1.0) return 0.0;
    for (int i = 1; i < kPlaces; ++i) {
      const dvec3 p_W = p_WFrom + (static_cast<double>(i) / kPlaces) * way_W;
      least = std::min(least, collision::nearestPoint(*placed.part->mesh.collider, X_PW * p_W, least).distance);
    }
  }
  return least;
}

}  // namespace

TargetSight sightOfTarget(const PreparedScene& scene, const workcell::Entity& mannequin,
                          const mannequin::Posture& posture, workcell::EntityId target) {
  std::vector<Placed> targets, others;
  for (const ScenePart& part : scene.parts()) {
    if (part.entity == mannequin.id) continue;
    const workcell::Entity& owner = *scene.find(part.entity);
    const Placed placed{&part, PreparedScene::partPose(owner, owner.X_WE, owner.joints(), part.link)};
    (part.entity == target ? targets : others).push_back(placed);
  }
  TargetSight sight;
  if (targets.empty()) return sight;
  const geometry::Bounds box = boundsOf(targets);
  const auto pose = mannequin::forwardKinematics(*mannequin.figure(), posture);
  const mannequin::Sight middle = mannequin::sightOf(*mannequin.figure(), pose, box.center());
  sight.zone = middle.zone;
  sight.distance = middle.distance;
  std::map<workcell::EntityId, int> hides;
  int seen = 0;
  for (int i = 0; i < 27; ++i) {
    // A little inside the box, so that a corner that is only the box's counts like the part beside it.
    const int x = i % 3, y = i / 3 % 3, z = i / 9;
    const dvec3 share(0.1 + 0.4 * x, 0.1 + 0.4 * y, 0.1 + 0.4 * z);
    const dvec3 way = box.min + share * (box.max - box.min) - middle.p_WEyes;
    double own = 1.0;
    for (const Placed& placed : targets) own = std::min(own, meets(placed, middle.p_WEyes, way));
    const Placed* first = nullptr;
    double nearest = own - 1e-6;
    for (const Placed& placed : others) {
      const double met = meets(placed, middle.p_WEyes, way);
      if (met < nearest) {
        nearest = met;
        first = &placed;
      }
    }
    if (first) {
      ++hides[first->part->entity];
    } else {
      ++seen;
    }
  }
  sight.seen = seen / 27.0;
  sight.clearance = clearanceOf(others, middle.p_WEyes, box.center() - middle.p_WEyes);
  const auto most =
      std::max_element(hides.begin(), hides.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != hides.end()) sight.hidden_by = scene.find(most->first)->name;
  return sight;
}

}  // namespace hapticell::manipulation
