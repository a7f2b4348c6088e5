// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/device_choice.h"

#include <algorithm>
#include <filesystem>

#include "config/device_profile.h"
#include "haptic/devices/device_recording.h"
#include "haptic/devices/driver_device.h"
#include "haptic/devices/simulated_device.h"

namespace hapticell::haptic {

namespace {

std::string namesOf(const std::vector<LoadedDriver>& drivers) {
  std::string names = "replay:FILE";
  for (const std::string& profile : simulatedProfiles()) names += ", " + profile;
  for (const LoadedDriver& driver : drivers) {
    if (driver.driver != nullptr) names += std::string(", ") + driver.driver->information().name;
  }
  return names;
}

}  // namespace

std::vector<std::string> simulatedProfiles() {
  std::vector<std::string> names;
  const auto folder = config::findShippedFile("devices");
  std::error_code missing;
  if (!folder) return names;
  for (const auto& entry : std::filesystem::directory_iterator(*folder, missing)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

DeviceName parseDeviceName(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string first = name.substr(0, colon);
  if (colon == std::string::npos && config::findShippedFile("devices/" + first + ".toml")) return {"", first};
  return {first, colon == std::string::npos ? "" : name.substr(colon + 1)};
}

Expected<driver::Driver*> findDriver(const std::string& name, const DriverSettings& settings) {
  // The file of that name alone, where there is one: others may hold a vendor's library.
  for (const std::filesystem::path& folder : driverFolders()) {
    const std::filesystem::path file = folder / (name + ".so");
    std::error_code ignored;
    if (name.empty() || name.find('/') != std::string::npos || !std::filesystem::exists(file, ignored)) continue;
    auto driver = loadDriver(file);
    if (driver) configureDriver(**driver, settings);
    return driver;
  }
  const std::vector<LoadedDriver> drivers = loadDrivers(driverFolders(), settings);
  for (const LoadedDriver& loaded : drivers) {
    if (loaded.driver != nullptr && name == loaded.driver->information().name) return loaded.driver;
  }
  for (const LoadedDriver& loaded : drivers) {
    if (loaded.driver == nullptr && loaded.file.stem() == name) return tl::unexpected(loaded.problem);
  }
  return makeError({.place = "device",
                    .found = "'" + name + "'",
                    .expected = Text("one of %1", namesOf(drivers)),
                    .fix = "hapticell-cli devices shows what is plugged in."});
}

Expected<std::unique_ptr<Device>> makeDevice(const std::string& name, const config::Configuration& configuration,
                                             std::function<void(const std::string&)> report) {
  const DeviceName wanted = parseDeviceName(name);
  if (wanted.driver.empty()) {
    const auto file = config::findShippedFile("devices/" + wanted.id + ".toml");
    HAPTICELL_TRY(file);
    const auto profile = config::readDeviceProfile(*file);
    HAPTICELL_TRY(profile);
    return std::make_unique<SimulatedDevice>(*profile);
  }
  if (wanted.driver == "replay") {
    auto recording = readDeviceRecording(wanted.id);
    HAPTICELL_TRY(recording);
    return std::make_unique<ReplayDevice>(std::move(*recording));
  }
  const auto driver = findDriver(wanted.driver, configuration.drivers);
  HAPTICELL_TRY(driver);
  DriverDeviceOptions options;
  options.session.report = std::move(report);
  return std::make_unique<DriverDevice>(**driver, wanted.id, std::move(options));
}

}  // namespace hapticell::haptic
