// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/simulated_hand.h"

namespace hapticell::haptic {

namespace {

// rad/s that the intended orientation turns at most: three turns a second, as no wrist does. Half: still free; twice: a
// mouse that jumps throws the stylus round.
constexpr double kMaxTurn = 20.0;

}  // namespace

void SimulatedHand::hold(const Pose& X_DH, std::uint32_t buttons) {
  if (!X_DH.isValid()) return;
  goal_ = X_DH;
  buttons_ = buttons;
  holding_ = true;
}

void SimulatedHand::release() {
  holding_ = false;
  gripping_ = false;
  buttons_ = 0;
  velocity_ = dvec3(0.0);
  angular_velocity_ = dvec3(0.0);
}

void SimulatedHand::beginTick(const Pose& X_DS, double dt) {
  if (!holding_ || dt <= 0.0) return;
  // A hand closes on the stylus where the stylus is, then goes where it wants to be.
  start_ = gripping_ ? displaced(start_, {velocity_ * last_dt_, angular_velocity_ * last_dt_}) : X_DS;
  gripping_ = true;
  last_dt_ = dt;
  const Twist wanted = difference(goal_, start_);
  velocity_ = shortenedTo(wanted.linear / dt, options_.max_speed);
  angular_velocity_ = shortenedTo(wanted.angular / dt, kMaxTurn);
}

HandIntent SimulatedHand::intentAt(double s) const {
  return {displaced(start_, {velocity_ * s, angular_velocity_ * s}), velocity_, angular_velocity_};
}

}  // namespace hapticell::haptic
