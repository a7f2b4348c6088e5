// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "haptic/devices/driver_library.h"

namespace hapticell::cli {

/// Output of `devices` for one driver: the driver, and the devices that it finds.
struct DriverEntries {
  nlohmann::ordered_json driver;
  nlohmann::ordered_json devices = nlohmann::ordered_json::array();
};

/// The simulated styluses, as one built-in driver.
DriverEntries simulatedEntries();

/// Queries a driver in a separate process, which ends with the answer, so that a vendor's library keeps nothing open;
/// if it crashes, that is reported as the driver's problem. Call it only while this process has one thread.
DriverEntries entriesAskedApart(const haptic::LoadedDriver& loaded);

/// The complete output of the command, with the present permissions of the system.
nlohmann::ordered_json listingOf(const std::vector<DriverEntries>& drivers,
                                 const std::vector<std::filesystem::path>& folders);

}  // namespace hapticell::cli
