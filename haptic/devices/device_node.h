// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptic/devices/driver_interface.h"

namespace hapticell::driver {

/// Why the device file `path` cannot be opened for reading and writing, and the command that mends it: a group that the
/// user lacks, or udev rules that are not installed. kOk where it can. `error` is the errno that an attempt met; 0: the
/// access is only looked at.
Problem nodeProblem(const std::string& path, int error = 0);

/// Who runs the program, for commands that let him do more.
std::string userName();

/// The command that installs HaptiCell's udev rules.
std::string udevFix();

/// True where a file of HaptiCell's udev rules is installed.
bool udevRulesInstalled();

/// The folder for what a driver keeps of a user: $XDG_CONFIG_HOME/hapticell/devices, else ~/.config/hapticell/devices.
std::string userDeviceFolder();

}  // namespace hapticell::driver
