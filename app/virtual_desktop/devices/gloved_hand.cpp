// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/gloved_hand.h"

#include <cmath>

#include "mannequin/shape/figure_model.h"
#include "mannequin/motion/free_hand.h"

namespace hapticell::app {
namespace {

using workcell::Entity;

bool isFree(const Entity& entity) {
  return entity.robot() && !entity.figure() && mannequin::isFreeHand(*entity.robot());
}

const Entity* posed(const workcell::Document& document, workcell::EntityId chosen, mannequin::Side side) {
  const Entity* own = document.find(chosen);
  if (own && !own->locked && (own->figure() || isFree(*own))) return own;
  const Entity* found = nullptr;
  for (const auto& entity : document.state().entities) {
    if (entity->locked) continue;
    if (isFree(*entity) && mannequin::sideOf(*entity->robot()) == side) return entity.get();
    if (entity->figure() && !found) found = entity.get();
  }
  return found;
}

manipulation::GraspKeeper::Bend bendOf(const mannequin::GloveReadings& angles) {
  manipulation::GraspKeeper::Bend bend{0.5 * (angles[1] + angles[2])};
  constexpr std::size_t kKnuckles[]{4, 7, 11, 15};
  for (std::size_t i = 0; i < 4; ++i) bend[i + 1] = 0.5 * (angles[kKnuckles[i]] + angles[kKnuckles[i] + 1]);
  for (double& angle : bend) angle = std::isfinite(angle) ? angle : 0.0;
  return bend;
}

}  // namespace

GlovedHand glovedHand(const workcell::Document& document, workcell::EntityId chosen, mannequin::Side side,
                      const mannequin::GloveReadings& angles) {
  GlovedHand hand;
  const Entity* entity = posed(document, chosen, side);
  if (!entity) return hand;
  hand.entity = entity->id;
  hand.bend = bendOf(angles);
  hand.joints = entity->joints();
  if (entity->figure()) {
    using mannequin::Dof;
    hand.side = side;
    mannequin::Posture posture = mannequin::toPosture(*entity->figure(), {entity->X_WE, entity->joints()});
    mannequin::setHandFromGlove(angles, side, posture);
    for (const Dof left : {Dof::kLeftFingersCurl, Dof::kLeftThumbAbduction, Dof::kLeftThumbFlexion}) {
      const Dof dof = mannequin::armDof(side, left);
      hand.joints[mannequin::indexOf(dof)] = posture[dof];
      hand.fingers.push_back({mannequin::indexOf(dof)});
    }
  } else {
    // A free hand is one hand whatever glove there is: a left glove moves a right one as its mirror.
    hand.side = mannequin::sideOf(*entity->robot());
    hand.joints = mannequin::freeHandFromGlove(angles, *entity->robot());
    for (std::size_t i = 0; i < hand.joints.size(); ++i) hand.fingers.push_back({i});
  }
  return hand;
}

}  // namespace hapticell::app
