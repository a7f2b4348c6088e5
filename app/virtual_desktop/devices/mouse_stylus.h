// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "app/viewport/tools/pointer_tool.h"
#include "haptic/protocol/messages.h"

namespace hapticell::app {

/// The mouse as the hand that holds a simulated stylus.
///
/// Press the left button on the drawn pen (or anywhere while follow() is on) and drag: the tip moves in the plane of
/// the screen. The wheel moves it into the picture and out of it; with Ctrl the drag turns it; the right button, or the
/// key B, presses the stylus's button: while the mouse moves the stylus, that key and button have no other function.
/// When the mouse releases the stylus, the hand stays where it is. GUI thread; no widgets.
class MouseStylus final : public PointerTool {
 public:
  /// The data of the cell that it needs, passed each frame.
  struct State {
    bool usable = false;          ///< A simulated device is connected.
    bool holding_entity = false;  ///< Something is held by the stylus.
    dquat q_WD{1, 0, 0, 0};       ///< Turns motions of the hand into the cell.
    double scale = 1.0;           ///< Metres of the cell a metre of hand.
    dvec3 p_WTip{0.0};            ///< Where the tip is drawn.
    dvec3 d_WPen{0.0, 0.0, 1.0};  ///< Direction of the pen from its tip, unit.
    double pen_length = 0.2;      ///< Of the drawn pen, metres of the cell.
    dvec3 workspace_min{-0.08}, workspace_max{0.08};
  };
  using Listener = std::function<void(const haptic::HandTarget&)>;

  explicit MouseStylus(Listener listener) : listener_(std::move(listener)) {}
  void setState(const State& state) { state_ = state; }
  const haptic::HandTarget& target() const { return target_; }

  /// The hand takes the stylus in the middle of its workspace, or lets it go.
  void hold(bool holding);
  /// While on, the stylus follows the mouse without a button, and the left button is the stylus's.
  void setFollow(bool on) { follow_ = on; }
  bool follow() const { return follow_; }
  /// Moves and turns the hand by so much, in its own axes D (m, rad): a 3-D mouse.
  void drive(const Twist& motion_D);
  /// The stylus's button, from the keyboard.
  void setButton(bool pressed);

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent& event) override;
  QString hint() const override;

  /// True where a press would take the pen.
  bool hitsPen(const PointerEvent& event) const;
  /// Pixels from the pointer to the drawn pen; infinite where it cannot be taken.
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
