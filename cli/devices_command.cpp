// SPDX-License-Identifier: Apache-2.0
#include <sys/utsname.h>

#include <memory>

#include "cli/commands.h"
#include "config/configuration.h"
#include "config/device_profile.h"
#include "haptic/devices/device_choice.h"
#include "haptic/devices/driver_library.h"
#include "haptic/devices/system_access.h"
#include "haptic/protocol/messages.h"

namespace hapticell::cli {

namespace {

using haptic::LoadedDriver;
using nlohmann::ordered_json;

struct DeviceWords {
  std::string configuration;
};

ordered_json textOrNull(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

void addProblem(ordered_json& entry, const driver::Problem& problem) {
  const bool usable = problem.status == driver::Status::kOk;
  entry["usable"] = usable;
  entry["reason"] = usable ? ordered_json(nullptr) : ordered_json(haptic::toString(problem.status));
  entry["problem"] = textOrNull(usable ? "" : problem.found);
  entry["fix"] = textOrNull(usable ? "" : problem.fix);
}

/// The simulated styluses, as one driver that is built in.
void addSimulated(ordered_json& drivers, ordered_json& devices) {
  ordered_json entry{{"name", "simulated"}, {"title", "Simulated stylus"}, {"version", HAPTICELL_VERSION},
                     {"file", nullptr},     {"library", nullptr},          {"note", nullptr}};
  addProblem(entry, {});
  drivers.push_back(std::move(entry));
  for (const std::string& name : haptic::simulatedProfiles()) {
    const auto file = config::findShippedFile("devices/" + name + ".toml");
    const auto profile =
        file ? config::readDeviceProfile(*file) : Expected<config::DeviceProfile>(makeError(file.error()));
    ordered_json device{{"device", name},
                        {"driver", "simulated"},
                        {"id", name},
                        {"name", profile ? profile->name : name},
                        {"kind", "stylus"},
                        {"simulated", true},
                        {"place", textOrNull(file ? *file : "")},
                        {"firmware", nullptr}};
    driver::Problem problem;
    addProblem(device, problem);
    if (!profile) {
      device["usable"] = false;
      device["reason"] = "fault";
      device["problem"] = profile.error().message();
    }
    devices.push_back(std::move(device));
  }
}

ordered_json deviceJson(const std::string& driver, const driver::Found& found) {
  ordered_json device{{"device", driver + (found.id[0] != '\0' ? std::string(":") + found.id : "")},
                      {"driver", driver},
                      {"id", found.id},
                      {"name", found.name},
                      {"kind", haptic::toString(found.kind)},
                      {"simulated", false},
                      {"place", textOrNull(found.place)},
                      {"firmware", textOrNull(found.firmware)}};
  addProblem(device, found.problem);
  return device;
}

void addDriver(const LoadedDriver& loaded, ordered_json& drivers, ordered_json& devices) {
  ordered_json entry{{"name", loaded.file.stem().string()}, {"title", nullptr},   {"version", nullptr},
                     {"file", loaded.file.string()},        {"library", nullptr}, {"note", nullptr}};
  if (loaded.driver == nullptr) {
    entry["usable"] = false;
    entry["reason"] = "missing_library";
    entry["problem"] = loaded.problem.found;
    entry["fix"] = textOrNull(loaded.problem.fix);
    drivers.push_back(std::move(entry));
    return;
  }
  const driver::Information& about = loaded.driver->information();
  const haptic::DriverView view = haptic::look(*loaded.driver);
  entry["name"] = about.name;
  entry["title"] = about.title;
  entry["version"] = about.version;
  entry["library"] = textOrNull(about.library);
  entry["note"] = textOrNull(about.note);
  addProblem(entry, view.problem);
  drivers.push_back(std::move(entry));
  for (const driver::Found& found : view.found) devices.push_back(deviceJson(about.name, found));
}

ordered_json grantsJson() {
  ordered_json grants = ordered_json::array();
  for (const haptic::SystemGrant& grant : haptic::systemGrants()) {
    grants.push_back(
        {{"what", grant.what}, {"granted", grant.granted}, {"found", grant.found}, {"fix", textOrNull(grant.fix)}});
  }
  return grants;
}

ordered_json versionsJson() {
  utsname system{};
  uname(&system);
  return {{"hapticell", HAPTICELL_VERSION},
          {"driver_interface", driver::kInterfaceVersion},
          {"protocol", haptic::kProtocolVersion},
          {"kernel", system.release}};
}

ExitStatus run(const DeviceWords& words, const ResultWriter& writer) {
  const auto configuration = config::loadConfiguration(words.configuration);
  if (!configuration) {
    report(configuration.error());
    return ExitStatus::kBadInput;
  }
  ordered_json drivers = ordered_json::array(), devices = ordered_json::array(), folders = ordered_json::array();
  addSimulated(drivers, devices);
  const auto searched = haptic::driverFolders();
  for (const auto& folder : searched) folders.push_back(folder.string());
  for (const LoadedDriver& loaded : haptic::loadDrivers(searched, configuration->drivers)) {
    addDriver(loaded, drivers, devices);
  }
  const auto written = writer.write({{"drivers", std::move(drivers)},
                                     {"devices", std::move(devices)},
                                     {"permissions", grantsJson()},
                                     {"versions", versionsJson()},
                                     {"driver_folders", std::move(folders)}});
  if (written) return ExitStatus::kDone;
  report(written.error());
  return ExitStatus::kBadInput;
}

}  // namespace

void addDevicesCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "devices", "Styluses, gloves and 3-D mice: drivers, what is plugged in, permissions and what mends them");
  const auto words = std::make_shared<DeviceWords>();
  command->add_option("--config", words->configuration, "A hapticell.toml to read besides the shipped one");
  command->callback([words, &chosen] { chosen = [words](ResultWriter& writer) { return run(*words, writer); }; });
}

}  // namespace hapticell::cli
