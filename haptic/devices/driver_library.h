// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "haptic/devices/driver_interface.h"

namespace hapticell::haptic {

/// Settings of drivers: name of the driver, then key and value.
using DriverSettings = std::map<std::string, std::map<std::string, std::string>>;

/// A driver plug-in, or why its file could not be loaded.
struct LoadedDriver {
  std::filesystem::path file;
  driver::Driver* driver = nullptr;  ///< Null if it could not be loaded; lives as long as the process.
  Error problem;                     ///< Why not.
};

/// Loads the shared library `file` and gets its driver. Errors: it is not a shared library, needs a library that is not
/// installed, does not export `hapticell_driver`, or was built for another version of driver_interface.h. Libraries are
/// never unloaded, because vendors' libraries do not support it.
Expected<driver::Driver*> loadDriver(const std::filesystem::path& file);

/// The folders that are searched for drivers: those of HAPTICELL_DRIVERS (separated by `:`), `drivers` next to the
/// program, `hapticell/drivers` in the lib folder of its installation, `~/.local/lib/hapticell/drivers`.
std::vector<std::filesystem::path> driverFolders();

/// Passes a driver its own settings.
void configureDriver(driver::Driver& driver, const DriverSettings& settings);

/// All drivers of the folders, by file name; if two files have the same name, the one of the first folder counts. Each
/// driver gets its settings. Every call loads again; a file that cannot be loaded is listed with its problem.
std::vector<LoadedDriver> loadDrivers(const std::vector<std::filesystem::path>& folders,
                                      const DriverSettings& settings = {});

/// A device that a driver sees.
struct SeenDevice {
  std::string driver;  ///< The driver's name.
  driver::Found found;
};

/// What one driver sees now. If a driver does not answer within `patience_s`, the view has a problem and the call is
/// abandoned.
struct DriverView {
  std::vector<driver::Found> found;
  driver::Problem problem;
};
DriverView look(driver::Driver& driver, double patience_s = 5.0);

/// The driver's problem as an Error; `file` names driver and device.
Error toError(const driver::Problem& problem, const std::string& file);

/// "in_use", "no_permission" ...: the status in one word.
const char* toString(driver::Status status);
/// "stylus", "glove", "space_mouse".
const char* toString(driver::Kind kind);

}  // namespace hapticell::haptic
