// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// Limits the step between two commands sent to a device. If commands were skipped, the newest one may be far from the
/// last one sent. A zero command is sent at once.
class CommandSteps {
 public:
  /// N and N m between two commands: the slew limit of the safety chain in a millisecond, which no hand takes for a
  /// blow. Half: a skipped command lags behind the chain; twice: 2 N at once (TwoCommandsAreNeverMoreThanAStepApart).
  static constexpr double kForce = 1.0, kTorque = 0.05;

  /// Returns `command`, limited to a step from the last one, and stores it as sent.
  Command next(Command command) noexcept {
    walk(last_.force, command.force, kForce);
    walk(last_.torque, command.torque, kTorque);
    last_ = command;
    return command;
  }
  /// The last command sent.
  const Command& last() const noexcept { return last_; }

 private:
  static void walk(const double (&from)[3], double (&to)[3], double step) noexcept {
    if (to[0] == 0.0 && to[1] == 0.0 && to[2] == 0.0) return;
    double way[3], length = 0.0;
    for (int i = 0; i < 3; ++i) way[i] = to[i] - from[i], length += way[i] * way[i];
    length = std::sqrt(length);
    if (length <= step) return;
    for (int i = 0; i < 3; ++i) to[i] = from[i] + way[i] * (step / length);
  }
  Command last_;
};

}  // namespace hapticell::driver
