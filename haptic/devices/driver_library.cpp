// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <future>
#include <memory>
#include <set>
#include <thread>

#include "config/program_folders.h"
#include "config/user_folders.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::haptic {

namespace {

namespace fs = std::filesystem;

// Devices of one driver that are listed: more than a computer has ports. Half still lists all; twice only costs memory.
constexpr std::uint32_t kMostDevices = 32;

tl::unexpected<Error> notADriver(const fs::path& file, Text found, Text fix) {
  return makeError(
      {.file = file.string(), .found = std::move(found), .expected = "a driver of HaptiCell", .fix = std::move(fix)});
}

}  // namespace

Expected<driver::Driver*> loadDriver(const fs::path& file) {
  if (!file.is_absolute()) return notADriver(file, Text("not an absolute path"), Text("Use its absolute path."));
  HAPTICELL_TRY(config::checkPlugIn(file));
  // RTLD_NOW: a function that is missing is told now, not in the middle of a force.
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const why = dlerror();
    return notADriver(file, why != nullptr ? Text(std::string(why)) : Text("it cannot be loaded"),
                      Text("Install the library that this message names, or remove the file."));
  }
  void* const symbol = dlsym(library, "hapticell_driver");
  if (symbol == nullptr) {
    return notADriver(file, Text("it exports no function hapticell_driver"),
                      Text("See docs/library/drivers.md, or remove the file."));
  }
  driver::Driver* const driver = reinterpret_cast<HapticellDriverEntry>(symbol)(driver::kInterfaceVersion);
  if (driver == nullptr) {
    return notADriver(file, Text("it was built for another version of HaptiCell's driver interface"),
                      Text("Rebuild it for version %1.", driver::kInterfaceVersion));
  }
  return driver;
}

void configureDriver(driver::Driver& driver, const DriverSettings& settings) {
  const auto own = settings.find(driver.information().name);
  if (own == settings.end()) return;
  for (const auto& [key, value] : own->second) driver.configure(key.c_str(), value.c_str());
}

std::vector<fs::path> driverFolders() {
  std::vector<fs::path> folders;
  for (const fs::path& folder : config::absoluteEntries(std::getenv("HAPTICELL_DRIVERS"))) folders.push_back(folder);
  for (const fs::path& programs : config::programFolders()) {
    folders.push_back(programs / "drivers");
    folders.push_back(programs.parent_path() / HAPTICELL_LIBRARY_FOLDER / "hapticell" / "drivers");
  }
  if (const auto own = config::userLibraryFolder()) folders.push_back(*own / "drivers");
  return folders;
}

std::vector<LoadedDriver> loadDrivers(const std::vector<fs::path>& folders, const DriverSettings& settings) {
  std::vector<LoadedDriver> drivers;
  std::set<std::string> names;
  for (const fs::path& folder : folders) {
    std::error_code missing;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
      if (entry.path().extension() == ".so") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      if (!names.insert(file.filename().string()).second) continue;
      LoadedDriver loaded{file, nullptr, {}};
      if (const auto driver = loadDriver(file)) {
        loaded.driver = *driver;
        configureDriver(*loaded.driver, settings);
      } else {
        loaded.problem = driver.error();
      }
      drivers.push_back(std::move(loaded));
    }
  }
  return drivers;
}

DriverView look(driver::Driver& driver, double patience_s) {
  auto answer = std::make_shared<std::promise<DriverView>>();
  auto future = answer->get_future();
  std::thread([&driver, answer] {
    DriverView view;
    view.found.resize(kMostDevices);
    const std::uint32_t count = driver.find(view.found.data(), kMostDevices, view.problem);
    view.found.resize(std::min(count, kMostDevices));
    answer->set_value(std::move(view));
  }).detach();
  if (future.wait_for(std::chrono::duration<double>(patience_s)) == std::future_status::ready) return future.get();
  DriverView silent;
  driver::refuse(silent.problem, driver::Status::kFault, "the driver did not answer in time",
                 "Unplug the device and plug it in again.");
  return silent;
}

Error toError(const driver::Problem& problem, const std::string& file) {
  return {.file = file, .found = std::string(problem.found), .fix = std::string(problem.fix)};  // No ids: they change.
}

const char* toString(driver::Status status) {
  static constexpr std::array kNames{
      "ok",           "nothing_new",    "not_found", "in_use", "no_permission", "missing_library",
      "missing_file", "not_calibrated", "garbled",   "fault",  "vanished"};
  const auto index = static_cast<std::size_t>(status);
  return index < kNames.size() ? kNames[index] : "fault";
}

const char* toString(driver::Kind kind) {
  switch (kind) {
    case driver::Kind::kGlove:
      return "glove";
    case driver::Kind::kSpaceMouse:
      return "space_mouse";
    case driver::Kind::kStylus:
      break;
  }
  return "stylus";
}

}  // namespace hapticell::haptic
