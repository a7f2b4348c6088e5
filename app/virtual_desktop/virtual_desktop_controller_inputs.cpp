// SPDX-License-Identifier: Apache-2.0
// What glove and 3-D mouse do.
#include <algorithm>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/viewport/viewport_widget.h"
#include "app/virtual_desktop/finger_contact.h"
#include "app/virtual_desktop/virtual_desktop_controller.h"
#include "mannequin/figure_model.h"

namespace hapticell::app {
namespace {

constexpr double kGloveStep = 0.02;  // rad of a finger that count as a motion.
constexpr int kGloveRest = 400;      // Milliseconds without one: the hand's pose goes into the document.

}  // namespace

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
  if (!state) return;
  const std::uint32_t pressed = state->buttons & ~input_buttons_, released = input_buttons_ & ~state->buttons;
  input_buttons_ = state->buttons;
  if (pressed & 2u) {  // The second button changes between the view and what is held.
    const bool view = inputs_.mouseMoves() == InputDevices::MouseMoves::kView;
    inputs_.setMouseMoves(view ? InputDevices::MouseMoves::kEntity : InputDevices::MouseMoves::kView);
    emit connectionChanged();
  }
  const bool moves_view = inputs_.mouseMoves() == InputDevices::MouseMoves::kView;
  if (!moves_view && ((pressed | released) & 1u)) mouse_.setButton((pressed & 1u) != 0);
  if (std::all_of(state->motion, state->motion + 6, [](double m) { return m == 0.0; })) return;
  ViewportWidget& viewport = host_.viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  if (moves_view) {
    viewport.setCamera(movedByMouse(viewport.camera(), state->motion, seconds, size), false);
  } else {
    mouse_.drive(handMotion(state->motion, seconds));
  }
}

/// The fingers that touch; while the stylus holds something else the whole hand feels how hard that is pressed.
void VirtualDesktopController::vibrate(const workcell::Entity* figure, mannequin::Side side) {
  const double peak = device_ ? device_->peak_force : 0.0;
  FingerVibration strength{};
  if (figure && (snapshot_.held == 0 || snapshot_.held == figure->id)) {
    strength = fingerVibration(snapshot_, figure->id, side, peak);
  } else if (snapshot_.forces_on && peak > 0.0) {
    strength.fill(snapshot_.force_n / peak);
  }
  inputs_.vibrateGlove(strength);
}

void VirtualDesktopController::poseByGlove() {
  const auto angles = inputs_.gloveAngles();
  if (!angles) return;
  const workcell::Document& document = host_.documentModel().document();
  const workcell::Entity* entity = document.find(settings_.entity);
  if (!entity || !entity->figure) {
    entity = nullptr;
    for (const auto& other : document.state().entities) {
      if (other->figure && !entity) entity = other.get();
    }
  }
  const mannequin::Side side = inputs_.isRightGlove() ? mannequin::Side::kRight : mannequin::Side::kLeft;
  vibrate(entity, side);
  if (!entity || entity->locked) return;
  const mannequin::ModelConfiguration stands{entity->X_WE, entity->joints};
  mannequin::Posture posture = mannequin::toPosture(*entity->figure, stands);
  mannequin::setHandFromGlove(*angles, side, posture);
  std::vector<double> joints = mannequin::toModel(*entity->figure, posture).joints;
  const std::vector<double>& before = gloved_ == entity->id ? gloved_joints_ : entity->joints;
  double moved = 0.0;
  for (std::size_t i = 0; i < joints.size() && i < before.size(); ++i)
    moved = std::max(moved, std::abs(joints[i] - before[i]));
  if (moved > kGloveStep) {
    gloved_ = entity->id;
    gloved_joints_ = std::move(joints);
    glove_rests_.start();
  } else if (gloved_ == entity->id && glove_rests_.elapsed() > kGloveRest) {
    // One step of undo for a grasp, not one for each twitch.
    host_.documentModel().execute(workcell::SetConfiguration{gloved_, entity->X_WE, gloved_joints_});
    gloved_ = 0;
  }
}

manipulation::EntityState VirtualDesktopController::glovedState() const {
  manipulation::EntityState state;
  state.id = gloved_;
  if (const workcell::Entity* entity = host_.documentModel().document().find(gloved_)) state.X_WE = entity->X_WE;
  state.joints = gloved_joints_;
  return state;
}

}  // namespace hapticell::app
