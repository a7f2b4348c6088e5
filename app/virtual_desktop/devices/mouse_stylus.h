// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "app/viewport/tools/pointer_tool.h"
#include "haptic/protocol/messages.h"

namespace hapticell::app {

/// The mouse as the hand that holds a simulated stylus.
///
/// The user presses the left button on the drawn pen (or anywhere while follow() is on) and drags: the tip moves in the
/// plane of the screen. The wheel moves it away from the viewer or towards him; with Ctrl, the drag turns it; the right
/// button, or the key B, presses the stylus's button. While the mouse moves the stylus, that key and button have no
/// other function. When the mouse releases the stylus, the hand stays where it is. GUI thread; no widgets.
class MouseStylus final : public PointerTool {
 public:
  /// The data of the cell that the class needs, passed each frame.
  struct State {
    bool usable = false;          ///< A simulated stylus is connected.
    bool holding_entity = false;  ///< The stylus holds an entity.
    dquat q_WD{1, 0, 0, 0};       ///< Rotates motions of the hand into the cell.
    double scale = 1.0;           ///< Metres in the cell per metre of the hand.
    dvec3 p_WTip{0.0};            ///< Where the tip is drawn.
    dvec3 d_WPen{0.0, 0.0, 1.0};  ///< Direction of the pen from its tip, unit.
    double pen_length = 0.2;      ///< Of the drawn pen, in metres of the cell.
    dvec3 workspace_min{-0.08}, workspace_max{0.08};
  };
  using Listener = std::function<void(const haptic::HandTarget&)>;

  explicit MouseStylus(Listener listener) : listener_(std::move(listener)) {}
  void setState(const State& state) { state_ = state; }
  const haptic::HandTarget& target() const { return target_; }

  /// The hand takes the stylus at the middle of its workspace, or releases it.
  void hold(bool holding);
  /// While on, the stylus follows the mouse without a button, and the left button is the stylus's button.
  void setFollow(bool on) { follow_ = on; }
  bool follow() const { return follow_; }
  /// Moves and turns the hand, along and about its own axes D (m, rad), for a 3D mouse.
  void drive(const Twist& motion_D);
  /// Presses or releases the stylus's button, from the keyboard.
  void setButton(bool pressed);

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent& event) override;
  QString hint() const override;

  /// True if a press would take the pen.
  bool hitsPen(const PointerEvent& event) const;
  /// Distance from the pointer to the drawn pen in pixels; infinite if it cannot be taken.
  double pixelsToPen(const PointerEvent& event) const;

 private:
  void shift(const dvec3& motion_W);
  void turn(const dvec3& rotation_W);
  void tell();
  Listener listener_;
  State state_;
  haptic::HandTarget target_;
  glm::dvec2 last_{0.0};
  bool dragging_ = false, follow_ = false, over_pen_ = false, has_last_ = false;
};

}  // namespace hapticell::app
