// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/mouse_hand.h"

#include <QTimer>

#include "app/host/host.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

// ms that a press of the stylus's button lasts at least: a slow window's picture (55 ms) and more. Half: clicks are
// lost there; twice: quick double clicks are one.
constexpr int kLeastPress = 90;

}  // namespace

MouseHand::MouseHand(VirtualDesktopController& owner)
    : owner_(owner), mouse_([this](const haptic::HandTarget& target) { post(target); }) {}

void MouseHand::post(const haptic::HandTarget& target) {
  if (!owner_.loop()) return;
  const bool pressed = (target.buttons & 1u) != 0;
  if (pressed && !pressed_.isValid()) pressed_.start();
  haptic::HandTarget sent = target;
  // Newest wins on the way: a press must last, or its release overtakes it where the window is slow.
  if (!pressed && pressed_.isValid() && pressed_.elapsed() < kLeastPress) {
    sent.buttons |= 1u;
    QTimer::singleShot(kLeastPress, this, [this] { post(mouse_.target()); });
  } else if (!pressed) {
    pressed_.invalidate();
  }
  owner_.loop()->post(manipulation::command::SetHandTarget{sent});
}

void MouseHand::update() {
  const ViewportWidget& viewport = owner_.host().viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  MouseStylus::State state;
  state.usable = owner_.isConnected() && owner_.link().isSimulated();
  state.holding_entity = owner_.snapshot().stylus.held != 0;
  state.q_WD = owner_.axes_W();
  state.scale = owner_.snapshot().stylus.motion_scale;
  state.p_WTip = owner_.snapshot().stylus.X_WStylus.p;
  state.d_WPen = owner_.snapshot().stylus.X_WStylus.rotate(stylusDirection_S());
  state.pen_length = penPixels(size) * viewport.camera().metresPerPixel(state.p_WTip, size);
  if (const auto& device = owner_.device())
    state.workspace_min = device->workspace_min, state.workspace_max = device->workspace_max;
  mouse_.setState(state);
}

}  // namespace hapticell::app
