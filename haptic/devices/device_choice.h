// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "config/configuration.h"
#include "haptic/devices/device.h"
#include "haptic/devices/driver_library.h"

namespace hapticell::haptic {

/// What a device's name on the command line or in hapticell.toml means.
struct DeviceName {
  std::string driver;  ///< A driver's name; empty: a profile of config/devices/, simulated.
  std::string id;      ///< Behind the first colon: which of the driver's devices; empty: the first that can be used.
};

/// "falcon", "openhaptics:Left Device", "replay:FILE.hdev" (a recorded session); a name with a shipped profile (and no
/// colon) is a simulated device.
DeviceName parseDeviceName(const std::string& name);

/// The simulated device, or the driver's device, that `name` means, not opened yet. `report` is told sentences about a
/// driver's device by a thread of its own, as long as the process lives. Errors: there is neither such a profile nor
/// such a driver (all names are listed), the driver's file cannot be loaded.
Expected<std::unique_ptr<Device>> makeDevice(const std::string& name, const config::Configuration& configuration,
                                             std::function<void(const std::string&)> report = {});

/// The driver of that name among those of driverFolders().
Expected<driver::Driver*> findDriver(const std::string& name, const DriverSettings& settings);

/// Names of the shipped profiles of simulated devices.
std::vector<std::string> simulatedProfiles();

}  // namespace hapticell::haptic
