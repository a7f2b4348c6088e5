// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_taking.h"

#include <algorithm>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/triangle_mesh.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {

namespace {

using mannequin::Segment;
using mannequin::Side;

/// m under either foot in which nothing may be for it to hang (Mannequin, Balance). Half: one set down a little high
/// must balance on nothing; twice: lifted ones balance in the air.
constexpr double kOffTheFloor = 0.02;

bool isOfFoot(const std::string& link, Side side) {
  return link == mannequin::segmentInfo(legSegment(side, Segment::kLeftFoot)).name ||
         link == mannequin::segmentInfo(legSegment(side, Segment::kLeftToes)).name;
}

/// A finger counts to its hand.
bool isOfHand(const std::string& link, Side side) {
  const std::string hand = mannequin::segmentInfo(armSegment(side, Segment::kLeftHand)).name;
  const std::string prefix = side == Side::kLeft ? "l_" : "r_";
  constexpr const char* kDigits[] = {"thumb", "index", "middle", "ring", "pinky"};
  return link == hand || std::any_of(std::begin(kDigits), std::end(kDigits),
                                     [&](const char* digit) { return link.starts_with(prefix + digit); });
}

mannequin::FigurePose poseOf(const Taking& taking) {
  const mannequin::Figure& figure = *taking.entity.figure();
  return mannequin::forwardKinematics(figure, mannequin::toPosture(figure, {taking.stands.X_WE, taking.stands.joints}));
}

/// What stands still and may bear a foot.
bool bears(const Taking& taking, const ScenePart& foot, const Pose& X_WFoot) {
  for (const ScenePart& part : taking.scene.parts()) {
    const workcell::Entity& owner = *taking.scene.find(part.entity);
    if (owner.id == taking.entity.id || owner.attachment.to == taking.entity.name) continue;
    const Pose X_WP = PreparedScene::partPose(owner, owner.X_WE, owner.joints(), part.link);
    const auto found = collision::distance(foot.mesh.collider, X_WFoot, part.mesh.collider, X_WP, kOffTheFloor);
    if (found.colliding || !found.beyond_limit) return true;
  }
  return false;
}

}  // namespace

bool hangsInTheAir(const Taking& taking) {
  const mannequin::FigurePose pose = poseOf(taking);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Pose sole = mannequin::footPose(pose, side) * Pose::translation({0.0, 0.0, taking.entity.figure()->sole.z});
    if (sole.p.z < kOffTheFloor) return false;
  }
  for (const ScenePart& part : taking.scene.parts()) {
    if (part.entity != taking.entity.id) continue;
    if (!isOfFoot(part.name, Side::kLeft) && !isOfFoot(part.name, Side::kRight)) continue;
    const Pose X_WFoot = PreparedScene::partPose(taking.entity, taking.stands.X_WE, taking.stands.joints, part.link);
    if (bears(taking, part, X_WFoot)) return false;
  }
  return true;
}

std::array<mannequin::HandLoad, 2> loadsInHands(const Taking& taking) {
  std::array<mannequin::HandLoad, 2> loads{};
  const mannequin::FigurePose pose = poseOf(taking);
  for (const workcell::Entity& held : taking.scene.entities()) {
    if (held.attachment.to != taking.entity.name || !held.mesh() || !(held.contact.mass > 0.0)) continue;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      if (!isOfHand(held.attachment.link, side)) continue;
      const int link = taking.entity.robot()->findLink(held.attachment.link);
      const Pose X_WL = PreparedScene::partPose(taking.entity, taking.stands.X_WE, taking.stands.joints, link);
      const dvec3 p_WC = X_WL * held.attachment.X_LE * held.mesh()->bounds().center();
      mannequin::HandLoad& load = loads[static_cast<std::size_t>(side)];
      const double mass = load.mass + held.contact.mass;
      const dvec3 p_HC = mannequin::handPose(pose, side).inverse() * p_WC;
      load = {mass, (load.mass * load.p_HC + held.contact.mass * p_HC) / mass};
    }
  }
  return loads;
}

}  // namespace hapticell::manipulation
