// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "haptic/devices/driver_library.h"

namespace hapticell::cli {

/// What `devices` tells of one driver: itself, and what it sees.
struct DriverEntries {
  nlohmann::ordered_json driver;
  nlohmann::ordered_json devices = nlohmann::ordered_json::array();
};

/// The simulated styluses, as one driver that is built in.
DriverEntries simulatedEntries();

/// Asks it in a process of its own, which ends with the answer: a vendor's library keeps nothing open, and where it
/// crashes that is reported as the driver's problem. Only while this process has one thread.
DriverEntries entriesAskedApart(const haptic::LoadedDriver& loaded);

/// All that the command prints, with what the system grants now.
nlohmann::ordered_json listingOf(const std::vector<DriverEntries>& drivers,
                                 const std::vector<std::filesystem::path>& folders);

}  // namespace hapticell::cli
