// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/system_access.h"

#include <grp.h>
#include <pwd.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

#include "geometry/system/text.h"
#include "haptic/devices/device_node.h"

namespace hapticell::haptic {

namespace {

constexpr rlim_t kPriority = 80;  // The force loop's.
constexpr const char* kLimits = "/etc/security/limits.d/90-hapticell.conf";

/// The group of packaging/limits/90-hapticell.conf, which the server's package installs.
constexpr const char* kGroup = "realtime";

std::string limitFix(const std::string& line) {
  if (access(kLimits, F_OK) == 0 && getgrnam(kGroup) != nullptr)
    return std::string("sudo usermod -aG ") + kGroup + " " + driver::userName() + ", then log in again";
  return "echo '" + driver::userName() + " - " + line + "' | sudo tee -a " + kLimits + ", then log in again";
}

}  // namespace

std::string priorityFix() {
  return limitFix("rtprio 80");
}

std::string lockedMemoryFix() {
  return limitFix("memlock unlimited");
}

namespace {

SystemGrant priorityGrant() {
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  SystemGrant grant{"real-time priority", geteuid() == 0 || limit.rlim_cur >= kPriority, "", ""};
  grant.found =
      english(geteuid() == 0 ? Text("allowed for root") : Text("allowed up to %1; 80 is needed", limit.rlim_cur));
  if (!grant.granted) grant.fix = priorityFix();
  return grant;
}

SystemGrant memoryGrant() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  SystemGrant grant{"locked memory", geteuid() == 0 || limit.rlim_cur == RLIM_INFINITY, "", ""};
  grant.found = english(grant.granted ? Text("unlimited") : Text("limited to %1 KiB", limit.rlim_cur / 1024));
  if (!grant.granted) grant.fix = lockedMemoryFix();
  return grant;
}

SystemGrant rulesGrant() {
  SystemGrant grant{"udev rules", driver::udevRulesInstalled(), "", ""};
  grant.found = grant.granted ? "70-hapticell.rules is installed" : "70-hapticell.rules is not installed";
  if (!grant.granted) grant.fix = driver::udevFix();
  return grant;
}

SystemGrant serialGrant() {
  SystemGrant grant{"serial ports", geteuid() == 0, "", ""};
  const group* const dialout = getgrnam("dialout");
  if (dialout != nullptr && !grant.granted) {
    std::vector<gid_t> groups(static_cast<std::size_t>(std::max(0, getgroups(0, nullptr))));
    const int count = getgroups(static_cast<int>(groups.size()), groups.data());
    groups.resize(static_cast<std::size_t>(std::max(0, count)));
    grant.granted =
        getegid() == dialout->gr_gid || std::find(groups.begin(), groups.end(), dialout->gr_gid) != groups.end();
  }
  grant.found = grant.granted ? "member of dialout" : "not a member of dialout";
  if (geteuid() == 0) grant.found = "allowed for root";
  if (!grant.granted) grant.fix = english(Text("sudo usermod -aG dialout %1, then log in again", driver::userName()));
  return grant;
}

}  // namespace

std::vector<SystemGrant> systemGrants() {
  return {priorityGrant(), memoryGrant(), rulesGrant(), serialGrant()};
}

}  // namespace hapticell::haptic
