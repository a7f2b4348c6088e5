// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// Why the device file `path` cannot be opened for reading and writing, and the command that fixes it: the user is not
/// in a group, or udev rules are not installed. kOk if it can be opened. `error` is the errno of a failed attempt; 0:
/// only the access rights are checked.
Problem nodeProblem(const std::string& path, int error = 0);

/// Who runs the program, for commands that let him do more.
std::string userName();

/// The command that installs HaptiCell's udev rules.
std::string udevFix();

/// True if a file of HaptiCell's udev rules is installed.
bool udevRulesInstalled();

/// The folder for a driver's data of this user: $XDG_CONFIG_HOME/hapticell/devices, else ~/.config/hapticell/devices.
std::string userDeviceFolder();

}  // namespace hapticell::driver
