// SPDX-License-Identifier: Apache-2.0
#include "cli/device/health_check.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/device/program_answer.h"
#include "config/user_folders.h"
#include "geometry/system/plain_text.h"
#include "haptic/client/server_watch.h"
#include "haptic/devices/system_access.h"

namespace hapticell::cli {

namespace fs = std::filesystem;

namespace {

using nlohmann::ordered_json;

// ms: a driver of graphics may be slow the first time. Half: slow machines count as having none; twice: a hung one is
// waited for longer.
constexpr int kProbePatience = 20'000;
// Bytes free on a disk: room for some documents, packs and recordings, our choice. Half: it warns too late; twice:
// small disks are reported.
constexpr std::uintmax_t kNeeded = 500'000'000;
// s that a service on this machine may take to answer, by trial. Half: a busy one counts as missing; twice: a longer
// wait.
constexpr double kLinkPatience = 1.5;

std::string wordIn(const ordered_json& answer, const char* name) {
  const auto found = answer.find(name);
  return found != answer.end() && found->is_string() ? plainText(found->get<std::string>()) : std::string();
}

HealthCheck cardCheck() {
  std::error_code ignored;
  HealthCheck check{"graphics card", Health::kNote, "no /dev/dri/renderD*: pictures are drawn by the processor",
                    "If this machine has a graphics card, install its driver."};
  for (fs::directory_iterator entry("/dev/dri", ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string path = entry->path().string();
    if (path.find("renderD") == std::string::npos) continue;
    if (::access(path.c_str(), R_OK | W_OK) == 0) return {"graphics card", Health::kGood, path};
    check = {"graphics card", Health::kProblem, path + " cannot be opened by this user",
             "sudo usermod -aG render,video $USER, then log in again"};
  }
  return check;
}

HealthCheck openGlCheck() {
  const fs::path window = siblingProgram("hapticell");
  if (window.empty())
    return {"OpenGL", Health::kNote, "not checked: the window (hapticell) is not installed",
            "Install the package hapticell, unless this station only serves the stylus."};
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    return {"OpenGL", Health::kNote, "not checked: no display",
            "Run hapticell-cli doctor in a terminal on the desktop."};
  const auto answer = ordered_json::parse(answerOf(window, {"--probe-graphics"}, kProbePatience), nullptr, false);
  const std::string fix =
      "Install the graphics card driver, or, to draw by the processor: sudo apt install libgl1-mesa-dri";
  if (!answer.is_object()) return {"OpenGL", Health::kProblem, "the window did not answer", fix};
  if (const std::string problem = wordIn(answer, "problem"); !problem.empty())
    return {"OpenGL", Health::kProblem, problem, fix};
  HealthCheck check{"OpenGL", Health::kGood,
                    wordIn(answer, "version") + " on " + wordIn(answer, "renderer") + ", " + wordIn(answer, "vendor")};
  if (answer.value("software", false)) {
    check.health = Health::kNote;
    check.found += ": drawn by the processor";
    check.fix =
        "It works, but the view shows less detail while it turns. For full speed, install the driver of the graphics "
        "card.";
  }
  return check;
}

/// Says what the driver itself, or its device `entry`, is like.
HealthCheck checkOf(const std::string& what, const ordered_json& entry, const std::string& good) {
  if (entry.value("usable", false)) return {what, Health::kGood, good};
  const std::string problem = wordIn(entry, "problem");
  return {what, Health::kProblem, good + ": " + (problem.empty() ? "it cannot be used" : problem),
          wordIn(entry, "fix")};
}

bool isTaken(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int yes = 1;  // A connection that has just ended keeps nobody from listening.
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool taken =
      bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 && errno == EADDRINUSE;
  close(socket);
  return taken;
}

/// The device of the haptic server on this machine's port, asked as one who only watches; empty: none answers.
std::string servedDevice(std::uint16_t port) {
  const auto link = haptic::watchServer("127.0.0.1", port, "hapticell-cli doctor", kLinkPatience);
  if (!link) return {};
  const auto device = (*link)->device();
  return device ? plainText(device->name) : std::string();
}

/// The folder, or the nearest one above it that is there.
fs::path standing(fs::path folder) {
  std::error_code ignored;
  while (!fs::is_directory(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder;
}

HealthCheck diskCheck(const std::string& what, const Expected<fs::path>& folder) {
  if (!folder) return {what, Health::kProblem, folder.error().message(), "Set HOME to your home folder."};
  const fs::path there = standing(*folder);
  if (::access(there.c_str(), W_OK) != 0)
    return {what, Health::kProblem, there.string() + " is not writable", "sudo chown $USER " + there.string()};
  struct statvfs disk {};
  if (statvfs(there.c_str(), &disk) != 0)
    return {what, Health::kProblem, there.string() + ": " + std::strerror(errno), "Check this disk."};
  const auto free = static_cast<std::uintmax_t>(disk.f_bavail) * disk.f_frsize;
  const std::string found = folder->string() + ": " + std::to_string(free / 1'000'000) + " MB free";
  if (free >= kNeeded) return {what, Health::kGood, found};
  return {what, Health::kProblem, found, "Free disk space: at least " + std::to_string(kNeeded / 1'000'000) + " MB."};
}

}  // namespace

std::vector<HealthCheck> graphicsChecks() {
  return {cardCheck(), openGlCheck()};
}

std::vector<HealthCheck> grantChecks() {
  std::vector<HealthCheck> checks;
  for (const haptic::SystemGrant& grant : haptic::systemGrants())
    checks.push_back({grant.what, grant.granted ? Health::kGood : Health::kProblem, grant.found, grant.fix});
  return checks;
}

std::vector<HealthCheck> deviceChecks(const std::vector<DriverEntries>& drivers) {
  std::vector<HealthCheck> checks;
  for (const DriverEntries& entries : drivers) {
    const std::string name = wordIn(entries.driver, "name");
    // A driver without its vendor's library matters only to who has such a device, which nobody can see without it.
    if (!entries.driver.value("usable", false)) {
      HealthCheck check = checkOf("driver " + name, entries.driver, name);
      if (wordIn(entries.driver, "reason") != "fault") check.health = Health::kNote;
      checks.push_back(check);
    }
    for (const ordered_json& device : entries.devices)
      checks.push_back(checkOf("device " + wordIn(device, "device"), device, wordIn(device, "name")));
  }
  if (checks.empty() || drivers.empty() || std::none_of(checks.begin(), checks.end(), [](const HealthCheck& check) {
        return check.what.starts_with("device ");
      }))
    checks.push_back({"devices", Health::kNote, "no stylus, 3D mouse or glove found; a simulated stylus is used",
                      "If you have a device, connect it and switch it on. For details: hapticell-cli devices"});
  return checks;
}

std::vector<HealthCheck> programChecks() {
  std::vector<HealthCheck> checks;
  for (const char* name : {"hapticell-haptic-server", "hapticell-importer", "hapticell-ros2"}) {
    const fs::path program = siblingProgram(name);
    const char* const package = std::strcmp(name, "hapticell-haptic-server") == 0 ? "hapticell-server" : "hapticell";
    checks.push_back(program.empty() ? HealthCheck{name, Health::kProblem, "not installed",
                                                   std::string("Install the package ") + package + "."}
                                     : HealthCheck{name, Health::kGood, program.string()});
  }
  return checks;
}

HealthCheck portCheck(const config::Configuration& configuration) {
  const auto port = static_cast<std::uint16_t>(configuration.server.port);
  const std::string what = "port " + std::to_string(port);
  if (!isTaken(port)) return {what, Health::kGood, "free: no haptic server is running"};
  const std::string device = servedDevice(port);
  if (!device.empty()) return {what, Health::kGood, "a haptic server answers: " + device};
  return {what, Health::kProblem, "used by another program, or by a haptic server that does not respond",
          "ss -ltnp 'sport = :" + std::to_string(port) +
              "' shows which. Stop it, or set another port in [server] of hapticell.toml."};
}

std::vector<HealthCheck> diskChecks() {
  std::error_code ignored;
  return {diskCheck("disk, settings", config::userSettingsFolder()),
          diskCheck("disk, copies", config::userStateFolder()),
          diskCheck("disk, temporary", fs::temp_directory_path(ignored))};
}

}  // namespace hapticell::cli
