// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace hapticell::haptic {

/// One thing that the system may or may not grant this user.
struct SystemGrant {
  std::string what;  ///< "real-time priority": in a word or two.
  bool granted = false;
  std::string found;  ///< What the system says, one line.
  std::string fix;    ///< The exact command that mends it; empty where granted.
};

/// What devices and the force loop need of the system: real-time priority, locked memory, udev rules, the group of
/// serial ports. Asks only; changes nothing.
std::vector<SystemGrant> systemGrants();

}  // namespace hapticell::haptic
