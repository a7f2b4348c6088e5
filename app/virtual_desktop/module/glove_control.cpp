// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/glove_control.h"

#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/virtual_desktop/devices/finger_contact.h"
#include "app/virtual_desktop/devices/gloved_hand.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

// rad of a finger that count as a motion: 1.6 steps of 255 over 180 degrees. Half: noise keeps it moving; twice: slow
// fingers rest.
constexpr double kGloveStep = 0.02;
// ms without one: the hand's pose goes into the document. Half: undo steps for each pause; twice: a saved cell lacks
// the last pose for longer.
constexpr int kGloveRest = 400;

}  // namespace

/// The fingers that touch; while the stylus holds something else the whole hand feels how hard that is pressed.
void GloveControl::vibrate(const GlovedHand& hand) {
  const double peak = owner_.device() ? owner_.device()->peak_force : 0.0;
  FingerVibration strength = fingerVibration(owner_.snapshot(), hand.entity, hand.side, peak);
  const bool touches = std::any_of(strength.begin(), strength.end(), [](double each) { return each > 0.0; });
  const bool other_held = owner_.snapshot().stylus.held != 0 && owner_.snapshot().stylus.held != hand.entity;
  if (!touches && other_held && owner_.snapshot().stylus.forces_on && peak > 0.0)
    strength.fill(owner_.snapshot().stylus.force_n / peak);
  inputs_.vibrateGlove(strength);
}

bool GloveControl::mayGrasp(workcell::EntityId entity, workcell::EntityId hand) const {
  const workcell::Entity* part = owner_.host().documentModel().document().find(entity);
  return part && part->kind() == workcell::EntityKind::kSolid && !part->locked && part->attachment.to.empty() &&
         entity != hand && entity != owner_.snapshot().stylus.held;
}

/// What thumb and fingers close on goes with the hand; opened, they let it go where it is.
void GloveControl::grasp(const GlovedHand& hand) {
  const auto change = grasp_.look({owner_.snapshot().pairs, hand.entity, hand.side, hand.bend},
                                  [&](workcell::EntityId entity) { return mayGrasp(entity, hand.entity); });
  const std::string link = hand.side == mannequin::Side::kLeft ? "l_hand" : "r_hand";
  if (change.taken != 0) {
    // As it closed, so it stays: what hangs on the hand is not in its way any more.
    hand_ = hand.entity;
    joints_ = posedJoints(hand.entity);
    keep(joints_);
    owner_.loop()->post(manipulation::command::PoseJoints{hand.entity, joints_, hand.fingers});
    if (!owner_.host().documentModel().execute(workcell::Attach{change.taken, hand.entity, link})) grasp_.forget();
  }
  if (change.let_go != 0) owner_.host().documentModel().execute(workcell::Detach{change.let_go});
}

/// Where the loop has brought an entity's joints: as the document has them where it tells of no others.
std::vector<double> GloveControl::posedJoints(workcell::EntityId id) const {
  for (const manipulation::EntityState& state : owner_.snapshot().entities) {
    if (state.id == id) return state.joints;
  }
  const workcell::Entity* entity = owner_.host().documentModel().document().find(id);
  return entity ? entity->joints() : std::vector<double>{};
}

/// One step of undo for a grasp, not one for each twitch.
void GloveControl::keep(std::vector<double> joints) {
  const workcell::Entity* entity = owner_.host().documentModel().document().find(hand_);
  if (!entity || joints.size() != entity->joints().size() || joints == entity->joints()) return;
  owner_.host().documentModel().execute(workcell::SetConfiguration{hand_, entity->X_WE, std::move(joints)});
}

/// Fingers that have rested for a while go into the document, as far as the loop has let them come.
void GloveControl::keepRested() {
  if (hand_ == 0 || rests_.elapsed() <= kGloveRest) return;
  rests_.start();  // The loop may still be on its way there.
  keep(posedJoints(hand_));
}

/// The hand stays as it is until the glove moves it again.
void GloveControl::rest() {
  if (hand_ == 0) return;
  keep(posedJoints(hand_));
  hand_ = 0;
  if (owner_.loop()) owner_.loop()->post(manipulation::command::PoseJoints{});
}

/// No glove any more: what its hand held stays where it is.
void GloveControl::end() {
  rest();
  if (grasp_.held() != 0) owner_.host().documentModel().execute(workcell::Detach{grasp_.held()});
  grasp_.forget();
}

/// Without the loop nobody would see to it that no finger goes through what it meets: then the hand rests.
void GloveControl::pose() {
  const auto angles = inputs_.gloveAngles();
  if (!owner_.loop() || !angles || inputs_.isCalibrating()) return keepRested();
  const workcell::Document& document = owner_.host().documentModel().document();
  const mannequin::Side side = inputs_.isRightGlove() ? mannequin::Side::kRight : mannequin::Side::kLeft;
  GlovedHand hand = glovedHand(document, owner_.settings().entity, side, *angles);
  const workcell::Entity* held = document.find(grasp_.held());
  if (grasp_.held() != 0 && (!held || held->attachment.to.empty())) grasp_.forget();
  vibrate(hand);
  if (hand.entity == 0) return;
  grasp(hand);
  if (grasp_.held() != 0) return;  // The hand holds on as it closed.
  const std::vector<double>& before = hand_ == hand.entity ? joints_ : document.find(hand.entity)->joints();
  double moved = 0.0;
  for (std::size_t i = 0; i < hand.joints.size() && i < before.size(); ++i)
    moved = std::max(moved, std::abs(hand.joints[i] - before[i]));
  if (moved <= kGloveStep) return keepRested();
  hand_ = hand.entity;
  joints_ = hand.joints;
  rests_.start();
  owner_.loop()->post(manipulation::command::PoseJoints{hand.entity, hand.joints, hand.fingers});
}

}  // namespace hapticell::app
