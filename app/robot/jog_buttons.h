// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "app/robot/hold_button.h"
#include "app/robot/joint_mover.h"

namespace hapticell::app {

/// Size of one step of a jog button.
struct JogStepSize {
  double degrees = 1.0;
  double millimetres = 1.0;
};

/// Connects a button to jogging: everything between press and release is one undo step, named `text()`.
inline void connectJog(HoldButton* button, JointMover& mover, const std::function<QString()>& text,
                       const std::function<void()>& step) {
  QObject::connect(button, &HoldButton::began, &mover, [&mover, text] { mover.begin(text()); });
  QObject::connect(button, &HoldButton::stepped, &mover, step);
  QObject::connect(button, &HoldButton::ended, &mover, [&mover] { mover.end(); });
}

}  // namespace hapticell::app
