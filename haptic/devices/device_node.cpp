// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/device_node.h"

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "config/program_folders.h"
#include "config/user_folders.h"
#include "haptic/devices/driver_support.h"

namespace hapticell::driver {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRules = "70-hapticell.rules";

/// The rules beside the program, for the command that copies them.
std::string rulesFile() {
  std::error_code ignored;
  for (const fs::path& programs : config::programFolders()) {
    const fs::path installed = programs.parent_path() / "share" / "hapticell" / "udev" / kRules;
    if (fs::exists(installed, ignored)) return installed.string();
  }
  const fs::path source = fs::path(HAPTICELL_UDEV_SOURCE_DIR) / kRules;
  return fs::exists(source, ignored) ? source.string() : std::string("packaging/udev/") + kRules;
}

/// The group whose members may read and write the file; empty where the group may not.
std::string groupOf(const std::string& path) {
  struct stat about {};
  if (stat(path.c_str(), &about) != 0 || (about.st_mode & 0060) != 0060 || about.st_gid == 0) return {};
  const group* const entry = getgrgid(about.st_gid);
  return entry != nullptr ? entry->gr_name : std::string();
}

}  // namespace

std::string userName() {
  const passwd* const entry = getpwuid(geteuid());
  return entry != nullptr ? entry->pw_name : std::to_string(geteuid());
}

std::string udevFix() {
  return "sudo cp " + rulesFile() + " /etc/udev/rules.d/ && sudo udevadm control --reload && sudo udevadm trigger";
}

bool udevRulesInstalled() {
  std::error_code ignored;
  for (const char* folder : {"/etc/udev/rules.d", "/usr/lib/udev/rules.d", "/lib/udev/rules.d", "/run/udev/rules.d"}) {
    if (fs::exists(fs::path(folder) / kRules, ignored)) return true;
  }
  return false;
}

Problem nodeProblem(const std::string& path, int error) {
  Problem problem;
  if (error == 0 && access(path.c_str(), R_OK | W_OK) != 0) error = errno;
  if (error == 0) return problem;
  const std::string found = path + " may not be opened: " + std::strerror(error);
  if (error == EBUSY || error == EWOULDBLOCK) {
    refuse(problem, Status::kInUse, path + " is in use by another program", "Close the program that uses it.");
  } else if (error == ENOENT || error == ENODEV || error == ENXIO) {
    refuse(problem, Status::kNotFound, path + " is not there", "Plug the device in, or name its port.");
  } else if (error == EACCES || error == EPERM) {
    const std::string group = groupOf(path);
    const std::string fix = group.empty() ? udevFix() : "sudo usermod -aG " + group + " " + userName();
    refuse(problem, Status::kNoPermission, found, fix);
  } else {
    refuse(problem, Status::kFault, found);
  }
  return problem;
}

std::string userDeviceFolder() {
  const auto folder = config::userSettingsFolder();
  return folder ? (*folder / "devices").string() : std::string();
}

}  // namespace hapticell::driver
