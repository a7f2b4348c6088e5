// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/openhaptics/open_haptics_driver.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "haptic/devices/driver_support.h"
#include "haptic/devices/usb_scan.h"

namespace hapticell::driver {

namespace {

bool isTouch(const UsbDevice& device) {
  return (device.vendor == 0x2988 && device.product == 0x0302) || (device.vendor == 0x0301 && device.product == 0x2988);
}

/// The file, or one of that name where the system's libraries are.
bool isInstalled(const std::string& library) {
  std::error_code ignored;
  if (library.find('/') != std::string::npos) return std::filesystem::exists(library, ignored);
  for (const char* folder : {"/usr/lib/", "/usr/lib64/", "/usr/lib/x86_64-linux-gnu/", "/usr/local/lib/"}) {
    if (std::filesystem::exists(folder + library, ignored)) return true;
  }
  return false;
}

/// A Touch that the system sees though the vendor's library does not open it.
void addSeen(const Problem& why, Found* found, std::uint32_t room, std::uint32_t& count) {
  for (const UsbDevice& device : usbDevices()) {
    if (!isTouch(device)) continue;
    if (count < room) {
      Found& entry = found[count];
      copyText(entry.name, device.name.empty() ? "3D Systems Touch" : device.name);
      copyText(entry.place, device.place);
      entry.problem = why;
      for (const std::string& node : device.nodes) {
        if (const Problem denied = nodeProblem(node); denied.status != Status::kOk) entry.problem = denied;
      }
    }
    ++count;
  }
}

}  // namespace

void OpenHapticsDriver::configure(const char* key, const char* value) noexcept {
  if (std::string_view(key) == "library") library_ = value;
  if (std::string_view(key) == "device") device_ = value;
}

std::vector<std::string> OpenHapticsDriver::libraryNames() const {
  if (!library_.empty()) return {library_};
  return {"libHD.so", "libHD.so.3.4", "libHD.so.3.0", "/usr/lib/libHD.so"};
}

Problem OpenHapticsDriver::load() {
  return hd_.load(libraryNames());
}

std::uint64_t OpenHapticsDriver::presence() noexcept {
  PresenceNumber number;
  for (const std::string& name : libraryNames()) number.add(isInstalled(name) ? 1u : 0u);
  for (const UsbDevice& device : usbDevices()) {
    if (!isTouch(device)) continue;
    number.add(device.place);
    for (const std::string& node : device.nodes) {
      number.add(node);
      number.add(static_cast<std::uint32_t>(nodeProblem(node).status));
    }
  }
  return number.value();
}

std::vector<const char*> OpenHapticsDriver::namesToTry(const char* id) const {
  if (*id != '\0') return {id};
  if (!device_.empty()) return {device_.c_str()};
  return {"Default Device", nullptr, "Default PHANToM"};
}

unsigned OpenHapticsDriver::initialise(const char* id, Problem& problem) {
  for (const char* name : namesToTry(id)) {
    while (hd_.hdGetError().code != 0) {
    }
    const unsigned handle = hd_.hdInitDevice(name);
    const HdError error = hd_.hdGetError();
    if (handle != hd::kBadHandle && error.code == 0) return handle;
    const char* const words = hd_.hdGetErrorString(error.code);
    Problem reason = hdProblem(error.code, error.internal, words != nullptr ? words : "");
    // What says most: in use, before no answer, before a name that is unknown.
    const bool first = problem.status == Status::kOk;
    if (first || reason.status == Status::kInUse) problem = reason;
    if (handle != hd::kBadHandle) hd_.hdDisableDevice(handle);
  }
  if (problem.status == Status::kVanished) problem.status = Status::kNotFound;
  return hd::kBadHandle;
}

std::uint32_t OpenHapticsDriver::find(Found* found, std::uint32_t room, Problem& problem) noexcept {
  const std::scoped_lock lock(mutex_);
  std::uint32_t count = 0;
  problem = load();
  if (problem.status != Status::kOk) {
    addSeen(problem, found, room, count);
    return count;
  }
  const auto add = [&](const Capabilities& about, bool in_use) {
    if (count < room) {
      copyText(found[count].name, about.name);
      copyText(found[count].firmware, about.firmware);
      copyText(found[count].place, hd_.file);
      if (in_use) refuse(found[count].problem, Status::kInUse, "it is open in this program");
    }
    ++count;
  };
  for (const auto& device : open_) add(device->capabilities(), true);
  if (!open_.empty()) return count;
  Problem why;
  const unsigned handle = initialise("", why);
  if (handle == hd::kBadHandle) {
    addSeen(why, found, room, count);
    return count;
  }
  add(OpenHapticsDevice(hd_, handle).capabilities(), false);
  return count;
}

Device* OpenHapticsDriver::open(const char* id, Problem& problem) noexcept {
  const std::scoped_lock lock(mutex_);
  problem = load();
  if (problem.status != Status::kOk) return nullptr;
  // Devices are initialised while the scheduler stands: the vendor's rule.
  if (!open_.empty()) hd_.hdStopScheduler();
  const unsigned handle = initialise(id, problem);
  if (handle != hd::kBadHandle) {
    problem = {};
    open_.push_back(std::make_unique<OpenHapticsDevice>(hd_, handle));
    open_.back()->schedule();
    hd_.hdSetSchedulerRate(1000);
  }
  if (!open_.empty()) hd_.hdStartScheduler();
  return handle != hd::kBadHandle ? open_.back().get() : nullptr;
}

void OpenHapticsDriver::close(Device* device) noexcept {
  const std::scoped_lock lock(mutex_);
  hd_.hdStopScheduler();
  std::erase_if(open_, [&](const auto& own) { return own.get() == device; });
  if (!open_.empty()) hd_.hdStartScheduler();
}

}  // namespace hapticell::driver
