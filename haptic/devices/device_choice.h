// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "config/configuration.h"
#include "haptic/devices/device.h"
#include "haptic/devices/driver_library.h"

namespace hapticell::haptic {

/// A parsed device name from the command line or hapticell.toml.
struct DeviceName {
  std::string driver;  ///< A driver's name; empty: a profile of config/devices/, simulated.
  std::string id;      ///< After the first colon: which of the driver's devices; empty: the first that can be used.
};

/// "falcon", "openhaptics:Left Device", "replay:FILE.hdev" (a recorded session); the name of a shipped profile, without
/// a colon, is a simulated device.
DeviceName parseDeviceName(const std::string& name);

/// Makes the simulated device or the driver's device of that name, not opened yet. `report` gets sentences about a
/// driver's device from a separate thread, as long as the process lives. Errors: no profile or driver has that name
/// (the error lists all names); the driver's file cannot be loaded.
Expected<std::unique_ptr<Device>> makeDevice(const std::string& name, const config::Configuration& configuration,
                                             std::function<void(const std::string&)> report = {});

/// The driver of that name in driverFolders().
Expected<driver::Driver*> findDriver(const std::string& name, const DriverSettings& settings);

/// Names of the shipped profiles of simulated devices.
std::vector<std::string> simulatedProfiles();

}  // namespace hapticell::haptic
