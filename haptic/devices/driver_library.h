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

/// One driver plug-in, or why a file that looks like one is none.
struct LoadedDriver {
  std::filesystem::path file;
  driver::Driver* driver = nullptr;  ///< Null where it could not be loaded; lives as long as the process.
  Error problem;                     ///< Why not.
};

/// Loads the shared library `file` and asks it for its driver. Errors: it is no shared library, needs one that is not
/// installed, exports no `hapticell_driver`, or was built for another version of driver_interface.h. A library is never
/// unloaded: vendors' libraries do not bear it.
Expected<driver::Driver*> loadDriver(const std::filesystem::path& file);

/// The folders that drivers are looked for in: those of HAPTICELL_DRIVERS (with `:` between), `drivers` beside the
/// program, `lib/hapticell/drivers` of its installation, `~/.local/lib/hapticell/drivers`.
std::vector<std::filesystem::path> driverFolders();

/// Tells a driver its own settings among all.
void tellSettings(driver::Driver& driver, const DriverSettings& settings);

/// All drivers of the folders, by file name; of two files with the same name the first folder's counts. Each is told
/// its settings. Loading happens once for each call; a file that cannot be loaded is listed with its problem.
std::vector<LoadedDriver> loadDrivers(const std::vector<std::filesystem::path>& folders,
                                      const DriverSettings& settings = {});

/// A device among those that a driver sees.
struct SeenDevice {
  std::string driver;  ///< Its name.
  driver::Found found;
};

/// What one driver sees now. A driver that does not answer within `patience_s` is told as a problem; its call is left
/// to itself.
struct DriverView {
  std::vector<driver::Found> found;
  driver::Problem problem;
};
DriverView look(driver::Driver& driver, double patience_s = 5.0);

/// The driver's problem as an error of the house; `file` names driver and device.
Error toError(const driver::Problem& problem, const std::string& file);

/// "in_use", "no_permission" ...: the status in one word.
const char* toString(driver::Status status);
/// "stylus", "glove", "space_mouse".
const char* toString(driver::Kind kind);

}  // namespace hapticell::haptic
