// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace hapticell::haptic {

/// A permission that the system may or may not grant this user.
struct SystemGrant {
  std::string what;  ///< "real-time priority": one or two words.
  bool granted = false;
  std::string found;  ///< The system's answer, one line.
  std::string fix;    ///< The exact command that fixes it; empty if granted.
};

/// The commands that allow this user real-time priority and locked memory: they add the user to the group of the
/// server's package, or a line to the file of limits if the package is not installed. Any thread.
std::string priorityFix();
std::string lockedMemoryFix();

/// The permissions that devices and the force loop need: real-time priority, locked memory, udev rules, the group of
/// serial ports. Only checks; changes nothing.
std::vector<SystemGrant> systemGrants();

}  // namespace hapticell::haptic
