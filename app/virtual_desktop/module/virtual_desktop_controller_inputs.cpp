// SPDX-License-Identifier: Apache-2.0
// How the view lies to the hand, and what the mouse, a glove and a 3-D mouse do.
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/beside.h"
#include "app/style/library_text.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/devices/finger_contact.h"
#include "app/virtual_desktop/devices/gloved_hand.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "mannequin/motion/free_hand.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

constexpr double kGloveStep = 0.02;  // rad of a finger that count as a motion.
constexpr int kGloveRest = 400;      // Milliseconds without one: the hand's pose goes into the document.

}  // namespace

Pose VirtualDesktopController::cameraPose_W() const {
  const Camera& camera = host_.viewport().camera();
  return {camera.eye_W(), glm::normalize(glm::quat_cast(dmat3(camera.right_W(), camera.up_W(), -camera.forward_W())))};
}

dquat VirtualDesktopController::axes_W() const {
  const workcell::Entity* frame = host_.documentModel().document().findByName(settings_.axes_frame);
  const Pose X_WF = frame ? host_.viewport().scene().placement_W(*frame) : Pose::identity();
  return manipulation::deviceAxes(settings_.axes, cameraPose_W(), X_WF);
}

void VirtualDesktopController::postCamera() {
  if (!loop_) return;
  const ViewportWidget& viewport = host_.viewport();
  const Camera& camera = viewport.camera();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  manipulation::command::SetCamera seen;
  seen.X_WCamera = cameraPose_W();
  seen.visible_width = size.width * camera.metresPerPixel(camera.target_W, size);
  seen.p_WFocus = camera.target_W;
  loop_->post(seen);
  // Beside the first one's tip, that both pens can be taken.
  seen.p_WFocus += 0.12 * seen.visible_width * camera.right_W();
  loop_->postSecond(seen);
}

void VirtualDesktopController::takeInputs() {
  const double seconds = 1e-9 * static_cast<double>(input_clock_.nsecsElapsed());
  input_clock_.restart();
  for (const std::string& sentence : inputs_.takeNews()) {
    host_.messages().tell(Severity::kInformation, QString::fromStdString(sentence));
    emit connectionChanged();
  }
  driveByMouse(seconds);
  poseByGlove();
}

void VirtualDesktopController::driveByMouse(double seconds) {
  const auto state = inputs_.mouseState();
  if (!state) {  // Pulled out: nobody presses its button any more.
    if (MouseStylus* const pen = penOfMouse(); pen && (input_buttons_ & 1u)) pen->setButton(false);
    input_buttons_ = 0;
    return;
  }
  const std::uint32_t pressed = inputs_.takeMousePresses();
  const std::uint32_t released = (input_buttons_ | pressed) & ~state->buttons;
  input_buttons_ = state->buttons;
  if (pressed & 2u) {  // The second button changes between the view and what is held.
    const bool view = inputs_.mouseMoves() == InputDevices::MouseMoves::kView;
    inputs_.setMouseMoves(view ? InputDevices::MouseMoves::kEntity : InputDevices::MouseMoves::kView);
  }
  const bool moves_view = inputs_.mouseMoves() == InputDevices::MouseMoves::kView;
  MouseStylus* const pen = moves_view ? nullptr : penOfMouse();
  if (pen && (pressed & 1u)) pen->setButton(true);
  if (pen && (released & 1u)) pen->setButton(false);
  if (std::all_of(state->motion, state->motion + 6, [](double m) { return m == 0.0; })) return;
  ViewportWidget& viewport = host_.viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  if (moves_view) {
    viewport.setCamera(movedByMouse(viewport.camera(), state->motion, seconds, size), false);
  } else if (pen) {
    pen->drive(handMotion(state->motion, seconds));
  }
}

/// The simulated stylus that the 3-D mouse drives: the first of them. A real one is in a hand already.
MouseStylus* VirtualDesktopController::penOfMouse() {
  if (device_ && device_->simulated) return &mouse_;
  if (second_device_ && second_device_->simulated) return &second_mouse_;
  return nullptr;
}

void VirtualDesktopController::updateMouse() {
  const ViewportWidget& viewport = host_.viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  MouseStylus::State state;
  state.usable = isConnected() && device_ && device_->simulated;
  state.holding_entity = snapshot_.held != 0;
  state.q_WD = axes_W();
  state.scale = snapshot_.motion_scale;
  state.p_WTip = snapshot_.X_WStylus.p;
  state.d_WPen = snapshot_.X_WStylus.rotate(stylusDirection_S());
  state.pen_length = penPixels(size) * viewport.camera().metresPerPixel(state.p_WTip, size);
  if (device_) state.workspace_min = device_->workspace_min, state.workspace_max = device_->workspace_max;
  mouse_.setState(state);
}

/// Where a real hand holds the first stylus the 3-D mouse that is to move entities is the second one, until it moves
/// the view again.
void VirtualDesktopController::settleMouse() {
  const bool moves_entity = inputs_.mouseMoves() == InputDevices::MouseMoves::kEntity && !inputs_.mouse().isEmpty();
  const bool is_second = mouse_is_second_ && second_profile_ == inputs_.mouse();
  if (!moves_entity) {
    mouse_is_second_ = false;
    if (is_second) chooseSecond({});
    return;
  }
  if (!device_ || device_->simulated || penOfMouse()) return;
  if (second_profile_.isEmpty()) {
    mouse_is_second_ = true;
    return chooseSecond(inputs_.mouse());
  }
  if (!second_device_ || second_profile_ == inputs_.mouse()) return;
  inputs_.setMouseMoves(InputDevices::MouseMoves::kView);
  host_.messages().tell(Severity::kInformation, tr("The 3-D mouse moves the view"),
                        tr("Both styluses are in somebody's hands. Choose the 3-D mouse as the second stylus to move "
                           "entities by it."));
}

/// The fingers that touch; while the stylus holds something else the whole hand feels how hard that is pressed.
void VirtualDesktopController::vibrate(const GlovedHand& hand) {
  const double peak = device_ ? device_->peak_force : 0.0;
  FingerVibration strength = fingerVibration(snapshot_, hand.entity, hand.side, peak);
  const bool touches = std::any_of(strength.begin(), strength.end(), [](double each) { return each > 0.0; });
  const bool other_held = snapshot_.held != 0 && snapshot_.held != hand.entity;
  if (!touches && other_held && snapshot_.forces_on && peak > 0.0) strength.fill(snapshot_.force_n / peak);
  inputs_.vibrateGlove(strength);
}

bool VirtualDesktopController::mayGrasp(workcell::EntityId entity, workcell::EntityId hand) const {
  const workcell::Entity* part = host_.documentModel().document().find(entity);
  return part && part->kind == workcell::EntityKind::kSolid && !part->locked && part->attachment.to.empty() &&
         entity != hand && entity != snapshot_.held;
}

/// What thumb and fingers close on goes with the hand; opened, they let it go where it is.
void VirtualDesktopController::grasp(const GlovedHand& hand) {
  const auto change = grasp_.look({snapshot_.pairs, hand.entity, hand.side, hand.bend},
                                  [&](workcell::EntityId entity) { return mayGrasp(entity, hand.entity); });
  const std::string link = hand.side == mannequin::Side::kLeft ? "l_hand" : "r_hand";
  if (change.taken != 0) {
    // As it closed, so it stays: what hangs on the hand is not in its way any more.
    gloved_ = hand.entity;
    gloved_joints_ = posedJoints(hand.entity);
    keepGloved(gloved_joints_);
    loop_->post(manipulation::command::PoseJoints{hand.entity, gloved_joints_, hand.fingers});
    if (!host_.documentModel().execute(workcell::Attach{change.taken, hand.entity, link})) grasp_.forget();
  }
  if (change.let_go != 0) host_.documentModel().execute(workcell::Detach{change.let_go});
}

/// Where the loop has brought an entity's joints: as the document has them where it tells of no others.
std::vector<double> VirtualDesktopController::posedJoints(workcell::EntityId id) const {
  for (const manipulation::EntityState& state : snapshot_.entities) {
    if (state.id == id) return state.joints;
  }
  const workcell::Entity* entity = host_.documentModel().document().find(id);
  return entity ? entity->joints : std::vector<double>{};
}

/// One step of undo for a grasp, not one for each twitch.
void VirtualDesktopController::keepGloved(std::vector<double> joints) {
  const workcell::Entity* entity = host_.documentModel().document().find(gloved_);
  if (!entity || joints.size() != entity->joints.size() || joints == entity->joints) return;
  host_.documentModel().execute(workcell::SetConfiguration{gloved_, entity->X_WE, std::move(joints)});
}

/// Fingers that have rested for a while go into the document, as far as the loop has let them come.
void VirtualDesktopController::keepRested() {
  if (gloved_ == 0 || glove_rests_.elapsed() <= kGloveRest) return;
  glove_rests_.start();  // The loop may still be on its way there.
  keepGloved(posedJoints(gloved_));
}

/// The hand stays as it is until the glove moves it anew.
void VirtualDesktopController::restGlove() {
  if (gloved_ == 0) return;
  keepGloved(posedJoints(gloved_));
  gloved_ = 0;
  if (loop_) loop_->post(manipulation::command::PoseJoints{});
}

/// No glove any more: what its hand held stays where it is.
void VirtualDesktopController::endGlove() {
  restGlove();
  if (grasp_.held() != 0) host_.documentModel().execute(workcell::Detach{grasp_.held()});
  grasp_.forget();
}

/// Without the loop nobody would see to it that no finger goes through what it meets: then the hand rests.
void VirtualDesktopController::poseByGlove() {
  const auto angles = inputs_.gloveAngles();
  if (!loop_ || !angles || inputs_.isCalibrating()) return keepRested();
  const workcell::Document& document = host_.documentModel().document();
  const mannequin::Side side = inputs_.isRightGlove() ? mannequin::Side::kRight : mannequin::Side::kLeft;
  GlovedHand hand = glovedHand(document, settings_.entity, side, *angles);
  const workcell::Entity* held = document.find(grasp_.held());
  if (grasp_.held() != 0 && (!held || held->attachment.to.empty())) grasp_.forget();
  vibrate(hand);
  if (hand.entity == 0) return;
  grasp(hand);
  if (grasp_.held() != 0) return;  // The hand holds on as it closed.
  const std::vector<double>& before = gloved_ == hand.entity ? gloved_joints_ : document.find(hand.entity)->joints;
  double moved = 0.0;
  for (std::size_t i = 0; i < hand.joints.size() && i < before.size(); ++i)
    moved = std::max(moved, std::abs(hand.joints[i] - before[i]));
  if (moved <= kGloveStep) return keepRested();
  gloved_ = hand.entity;
  gloved_joints_ = hand.joints;
  glove_rests_.start();
  loop_->post(manipulation::command::PoseJoints{hand.entity, hand.joints, hand.fingers});
}

bool VirtualDesktopController::hasFreeHand() const {
  const auto& entities = host_.documentModel().document().state().entities;
  return std::any_of(entities.begin(), entities.end(), [](const auto& entity) {
    return entity->robot && !entity->figure && mannequin::isFreeHand(*entity->robot);
  });
}

void VirtualDesktopController::addFreeHand() {
  const std::string what = inputs_.isRightGlove() ? "hand:right" : "hand:left";
  runBeside(
      this,
      [what] {
        Diagnostics diagnostics;
        return workcell::EntityLoader(".").load(what, 1.0, diagnostics);
      },
      [this](Expected<workcell::Entity> made) {
        if (!made)
          return host_.messages().tell(Severity::kProblem, tr("No hand was added"),
                                       QString::fromStdString(made.error().message()));
        const workcell::Document& document = host_.documentModel().document();
        made->name = document.uniqueName(made->name);
        made->X_WE.p = host_.viewport().camera().target_W;
        const std::string name = made->name;
        if (!host_.documentModel().execute(workcell::AddEntity{std::move(*made)})) return;
        if (const auto* entity = document.findByName(name)) host_.selection().set(entity->id);
      });
}

void VirtualDesktopController::tellOfPlugged(const ListedDevice& device) {
  const QString mends =
      shownText(device.problem.toStdString()) + QLatin1Char(' ') + shownText(device.fix.toStdString());
  host_.messages().tell(Severity::kInformation, tr("%1 has been plugged in").arg(device.name),
                        device.usable ? tr("Choose it in the panel Virtual Desktop.") : mends);
}

/// What the server says of the device; where it is our own its warnings come by another way.
void VirtualDesktopController::tellOfDevice() {
  const auto condition = link_ ? link_->condition() : std::nullopt;
  if (!condition || condition->sentence == told_sentence_) return;
  told_sentence_ = condition->sentence;
  if (!told_sentence_.empty() && !server_.isRunning())
    host_.messages().tell(Severity::kWarning, shownText(told_sentence_));
}

}  // namespace hapticell::app
