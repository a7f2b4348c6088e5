// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/body_contacts.h"

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/bounds.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {

namespace {

/// m: nearer boxes are looked at; contact is far below. Half and twice: a little less or more to query.
constexpr double kNear = 1e-3;

/// A hand, its fingers and what they hold touch the work on purpose.
bool touchesWork(const kinematics::RobotModel& model, int link) {
  const int body = mannequin::bodyOfLink(model, link);
  if (body < 0 || body >= static_cast<int>(mannequin::kSegmentCount)) return true;
  const auto segment = static_cast<mannequin::Segment>(body);
  return segment == mannequin::Segment::kLeftHand || segment == mannequin::Segment::kRightHand;
}

bool areApart(const geometry::Bounds& a, const geometry::Bounds& b) {
  const dvec3 gap = glm::max(a.min - b.max, b.min - a.max);
  return gap.x > kNear || gap.y > kNear || gap.z > kNear;
}

}  // namespace

std::string enteredByBody(const PreparedScene& scene, const workcell::Entity& body, const mannequin::Posture& posture,
                          BodyPairs pairs) {
  const auto stands = mannequin::toModel(*body.figure(), posture);
  for (const ScenePart& part : scene.parts()) {
    if (part.entity != body.id || touchesWork(*body.robot(), part.link)) continue;
    const Pose X_WP = PreparedScene::partPose(body, stands.X_WE, stands.joints, part.link);
    const geometry::Bounds bounds_W = geometry::transformed(X_WP, part.mesh.collider->bounds());
    for (const ScenePart& other : scene.parts()) {
      const workcell::Entity& owner = *scene.find(other.entity);
      if (owner.id == body.id || !owner.checked || owner.attachment.to == body.name) continue;
      const Pose X_WO = PreparedScene::partPose(owner, owner.X_WE, owner.joints(), other.link);
      if (areApart(bounds_W, geometry::transformed(X_WO, other.mesh.collider->bounds()))) continue;
      const bool counts = pairs == BodyPairs::kAll ? !(part.body == other.body) : scene.isChecked(part, other);
      if (!counts) continue;
      if (collision::distance(part.mesh.collider, X_WP, other.mesh.collider, X_WO, kNear).colliding) return owner.name;
    }
  }
  return {};
}

}  // namespace hapticell::manipulation
