// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/input_control.h"

#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/thread_pool_task.h"
#include "app/style/library_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "mannequin/motion/free_hand.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

// ms between two looks at glove and 3D mouse, 60 Hz. Half: twice the work; twice: jerks.
constexpr int kInputPeriod = 16;

}  // namespace

InputControl::InputControl(VirtualDesktopController& owner, SecondStylusControl& second)
    : owner_(owner), second_(second), devices_(owner.host().configuration()), glove_(owner, devices_) {
  clock_.start();
  timer_.setInterval(kInputPeriod);
  connect(&timer_, &QTimer::timeout, this, &InputControl::take);
  connect(&devices_, &InputDevices::changed, this, [this] {
    const bool any = !devices_.glove().isEmpty() || !devices_.mouse().isEmpty();
    any ? timer_.start() : timer_.stop();
    if (devices_.glove().isEmpty()) glove_.end();
    settleMouse();
    take();
    emit owner_.connectionChanged();
  });
}

void InputControl::take() {
  const double seconds = 1e-9 * static_cast<double>(clock_.nsecsElapsed());
  clock_.restart();
  for (const Text& sentence : devices_.takeNews()) {
    owner_.host().messages().tell(Severity::kInformation, shownText(sentence));
    emit owner_.connectionChanged();
  }
  driveByMouse(seconds);
  glove_.pose();
}

void InputControl::driveByMouse(double seconds) {
  const auto state = devices_.mouseState();
  if (!state) {  // Pulled out: nobody presses its button any more.
    if (MouseStylus* const pen = penOfMouse(); pen && (buttons_ & 1u)) pen->setButton(false);
    buttons_ = 0;
    return;
  }
  const std::uint32_t pressed = devices_.takeMousePresses();
  const std::uint32_t released = (buttons_ | pressed) & ~state->buttons;
  buttons_ = state->buttons;
  if (pressed & 2u) {  // The second button changes between the view and what is held.
    const bool view = devices_.mouseMoves() == InputDevices::MouseMoves::kView;
    devices_.setMouseMoves(view ? InputDevices::MouseMoves::kEntity : InputDevices::MouseMoves::kView);
  }
  const bool moves_view = devices_.mouseMoves() == InputDevices::MouseMoves::kView;
  MouseStylus* const pen = moves_view ? nullptr : penOfMouse();
  if (pen && (pressed & 1u)) pen->setButton(true);
  if (pen && (released & 1u)) pen->setButton(false);
  if (std::all_of(state->motion, state->motion + 6, [](double m) { return m == 0.0; })) return;
  ViewportWidget& viewport = owner_.host().viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  if (moves_view) {
    viewport.setCamera(movedByMouse(viewport.camera(), state->motion, seconds, size), false);
  } else if (pen) {
    pen->drive(handMotion(state->motion, seconds));
  }
}

/// The simulated stylus that the 3-D mouse drives: the first of them. A real one is in a hand already.
MouseStylus* InputControl::penOfMouse() {
  if (owner_.device() && owner_.device()->simulated) return &owner_.mouse();
  if (second_.isSimulated()) return &second_.mouse();
  return nullptr;
}

/// Where a real hand holds the first stylus the 3-D mouse that is to move entities is the second one, until it moves
/// the view again.
void InputControl::settleMouse() {
  const bool moves_entity = devices_.mouseMoves() == InputDevices::MouseMoves::kEntity && !devices_.mouse().isEmpty();
  const bool is_second = mouse_is_second_ && second_.profile() == devices_.mouse();
  if (!moves_entity) {
    mouse_is_second_ = false;
    if (is_second) second_.choose({});
    return;
  }
  if (!owner_.device() || owner_.device()->simulated || penOfMouse()) return;
  if (second_.profile().isEmpty()) {
    mouse_is_second_ = true;
    return second_.choose(devices_.mouse());
  }
  if (!second_.isConnected() || second_.profile() == devices_.mouse()) return;
  devices_.setMouseMoves(InputDevices::MouseMoves::kView);
  owner_.host().messages().tell(
      Severity::kInformation, QObject::tr("The 3D mouse moves the view"),
      QObject::tr("Both styluses are in use. To move entities with the 3D mouse, choose it as the second stylus."));
}

bool InputControl::hasFreeHand() const {
  const auto& entities = owner_.host().documentModel().document().state().entities;
  return std::any_of(entities.begin(), entities.end(), [](const auto& entity) {
    return entity->robot() && !entity->figure() && mannequin::isFreeHand(*entity->robot());
  });
}

void InputControl::addFreeHand() {
  const std::string what = devices_.isRightGlove() ? "hand:right" : "hand:left";
  runInThreadPool(
      &owner_,
      [what] {
        Diagnostics diagnostics;
        return workcell::EntityLoader(".").load(what, 1.0, diagnostics);
      },
      [this](Expected<workcell::Entity> made) {
        if (!made)
          return owner_.host().messages().reportCause(Severity::kProblem, QObject::tr("No hand was added"),
                                                      made.error());
        const workcell::Document& document = owner_.host().documentModel().document();
        made->name = document.uniqueName(made->name);
        made->X_WE.p = owner_.host().viewport().camera().target_W;
        const std::string name = made->name;
        if (!owner_.host().documentModel().execute(workcell::AddEntity{std::move(*made)})) return;
        if (const auto* entity = document.findByName(name)) owner_.host().selection().set(entity->id);
      });
}

}  // namespace hapticell::app
