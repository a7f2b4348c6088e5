// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "haptic/devices/driver_interface.h"
#include "haptic/devices/drivers/openhaptics/open_haptics_device.h"

namespace hapticell::driver {

/// 3D Systems / SensAble Phantom, Touch and Touch X through OpenHaptics. Settings: `library` (path of libHD.so),
/// `device` (name of the device as the vendor's setup calls it).
class OpenHapticsDriver final : public Driver {
 public:
  const Information& information() const noexcept override { return information_; }
  void configure(const char* key, const char* value) noexcept override;
  /// Opens the default device briefly, if it is not already open.
  std::uint32_t find(Found* found, std::uint32_t room, Problem& problem) noexcept override;
  Device* open(const char* id, Problem& problem) noexcept override;
  void close(Device* device) noexcept override;
  /// Depends on the devices that the system lists; the vendor's library is not used. It does not see a Touch on
  /// Ethernet.
  std::uint64_t presence() noexcept override;

  /// The names to try with hdInitDevice, in order; a null pointer means the vendor's default.
  std::vector<const char*> namesToTry(const char* id) const;

 private:
  std::vector<std::string> libraryNames() const;
  Problem load();
  unsigned initialise(const char* id, Problem& problem);

  Information information_{"openhaptics", "3D Systems Touch, Touch X, SensAble Phantom (OpenHaptics)", "1.0",
                           "libHD.so of 3D Systems, found at run time",
                           "Tested against a stand-in of the vendor's library, not on a real device."};
  std::string library_, device_;
  HdLibrary hd_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<OpenHapticsDevice>> open_;
};

}  // namespace hapticell::driver
