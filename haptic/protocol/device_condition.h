// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace hapticell::haptic {

/// How a device is and what it wants of its user.
struct DeviceCondition {
  bool answers = true;                     ///< It can be read.
  bool calibrated = true;                  ///< Where it is not, it exerts no force.
  bool docked = false;                     ///< The stylus is in its inkwell.
  std::vector<std::string> calibration{};  ///< What the user does to calibrate it, step by step; empty: nothing.
  std::string sentence{};  ///< What happened last: why it stopped, what mends it, that it is calibrated. May be empty.

  bool operator==(const DeviceCondition&) const = default;
};

}  // namespace hapticell::haptic
