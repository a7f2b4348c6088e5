// SPDX-License-Identifier: Apache-2.0
#include "cli/device/device_list.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "cli/kit/result_writer.h"
#include "config/device_profile.h"
#include "geometry/system/plain_text.h"
#include "haptic/devices/device_choice.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/system_access.h"
#include "haptic/protocol/messages.h"

namespace hapticell::cli {

namespace {

using haptic::LoadedDriver;
using nlohmann::ordered_json;

// ms: more than haptic::look() waits, so that it gives its own answer. Half: its answer may come too late; twice: a
// hung driver is waited for longer.
constexpr int kAskPatience = 10'000;

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

ordered_json simulatedJson(const std::string& name) {
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
  addProblem(device, {});
  if (!profile) {
    device["usable"] = false;
    device["reason"] = "fault";
    device["problem"] = profile.error().message();
  }
  return device;
}

ordered_json deviceJson(const std::string& driver, const driver::Found& found) {
  ordered_json device{{"device", driver + (found.id[0] != '\0' ? std::string(":") + found.id : "")},
                      {"driver", driver},
                      {"id", found.id},
                      {"name", plainText(found.name)},
                      {"kind", haptic::toString(found.kind)},
                      {"simulated", false},
                      {"place", textOrNull(found.place)},
                      {"firmware", textOrNull(found.firmware)}};
  addProblem(device, found.problem);
  return device;
}

/// Who the driver is, as far as that is known without asking it for devices.
ordered_json driverJson(const LoadedDriver& loaded) {
  ordered_json entry{{"name", loaded.file.stem().string()}, {"title", nullptr},   {"version", nullptr},
                     {"file", loaded.file.string()},        {"library", nullptr}, {"note", nullptr}};
  if (loaded.driver == nullptr) {
    entry["usable"] = false;
    entry["reason"] = "missing_library";
    entry["problem"] = loaded.problem.found;
    entry["fix"] = textOrNull(english(loaded.problem.fix));
    return entry;
  }
  const driver::Information& about = loaded.driver->information();
  entry["name"] = about.name;
  entry["title"] = about.title;
  entry["version"] = about.version;
  entry["library"] = textOrNull(about.library);
  entry["note"] = textOrNull(about.note);
  return entry;
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

/// Asks the driver here: what it loads and opens for that stays with this process.
DriverEntries entriesOf(const LoadedDriver& loaded) {
  DriverEntries entries{driverJson(loaded), ordered_json::array()};
  if (loaded.driver == nullptr) return entries;
  const haptic::DriverView view = haptic::look(*loaded.driver);
  addProblem(entries.driver, view.problem);
  for (const driver::Found& found : view.found)
    entries.devices.push_back(deviceJson(loaded.driver->information().name, found));
  return entries;
}

/// In the child: the answer goes into the pipe, nothing else of this process is ended.
[[noreturn]] void answer(const LoadedDriver& loaded, int pipe) {
  const DriverEntries entries = entriesOf(loaded);
  const std::string text = ordered_json{{"driver", entries.driver}, {"devices", entries.devices}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(pipe, text.data() + done, text.size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  _exit(0);
}

/// What comes until the other end closes, or the time is over.
std::string readAll(int pipe) {
  std::string text;
  std::array<char, 4096> piece{};
  for (;;) {
    pollfd waited{pipe, POLLIN, 0};
    const int ready = poll(&waited, 1, kAskPatience);
    if (ready < 0 && errno == EINTR) continue;
    const ssize_t count = ready > 0 ? read(pipe, piece.data(), piece.size()) : 0;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

DriverEntries simulatedEntries() {
  DriverEntries entries;
  entries.driver = {{"name", "simulated"}, {"title", "Simulated stylus"}, {"version", HAPTICELL_VERSION},
                    {"file", nullptr},     {"library", nullptr},          {"note", nullptr}};
  addProblem(entries.driver, {});
  for (const std::string& name : haptic::simulatedProfiles()) entries.devices.push_back(simulatedJson(name));
  return entries;
}

DriverEntries entriesAskedApart(const LoadedDriver& loaded) {
  int ends[2];
  if (loaded.driver == nullptr || pipe2(ends, O_CLOEXEC) != 0) return entriesOf(loaded);
  const pid_t child = fork();
  if (child == 0) answer(loaded, ends[1]);
  close(ends[1]);
  const std::string text = child > 0 ? readAll(ends[0]) : std::string();
  close(ends[0]);
  if (child > 0) {
    kill(child, SIGKILL);  // It has answered, or never will.
    waitpid(child, nullptr, 0);
  }
  const ordered_json told = ordered_json::parse(text, nullptr, false);
  if (told.is_object()) return {told["driver"], told["devices"]};
  driver::Problem problem;
  driver::refuse(problem, driver::Status::kFault, "it crashed while it searched for devices",
                 "Update the driver or the vendor's library, or remove " + loaded.file.string() + ".");
  DriverEntries entries{driverJson(loaded), ordered_json::array()};
  addProblem(entries.driver, problem);
  return entries;
}

ordered_json listingOf(const std::vector<DriverEntries>& drivers, const std::vector<std::filesystem::path>& folders) {
  ordered_json all = ordered_json::array(), devices = ordered_json::array(), searched = ordered_json::array();
  for (const DriverEntries& entries : drivers) {
    all.push_back(entries.driver);
    for (const ordered_json& device : entries.devices) devices.push_back(device);
  }
  for (const auto& folder : folders) searched.push_back(folder.string());
  return {{"drivers", std::move(all)},
          {"devices", std::move(devices)},
          {"permissions", grantsJson()},
          {"versions", versionsJson()},
          {"driver_folders", std::move(searched)}};
}

}  // namespace hapticell::cli
