// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace hapticell::haptic {

/// The state of a device and what its user must do.
struct DeviceCondition {
  bool answers = true;                     ///< The device can be read.
  bool calibrated = true;                  ///< If false, the device exerts no force.
  bool docked = false;                     ///< The stylus is in its inkwell.
  std::vector<std::string> calibration{};  ///< The user's calibration steps; empty: no calibration needed.
  std::string sentence{};  ///< The last event: why it stopped and how to fix it, or that it is calibrated. May be
                           ///< empty.

  bool operator==(const DeviceCondition&) const = default;
};

}  // namespace hapticell::haptic
