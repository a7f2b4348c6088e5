// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptic/devices/driver_library.h"

namespace hapticell::haptic {

/// Detects devices that are plugged in or removed, without opening any, by Driver::presence(). One thread.
class PresenceWatch {
 public:
  /// Ignores drivers that could not be loaded. The drivers outlive the watch.
  explicit PresenceWatch(const std::vector<LoadedDriver>& drivers);
  /// The drivers (indices as given) whose presence() changed since the last call, or since the watch began. Drivers
  /// that cannot detect changes are never included.
  std::vector<std::size_t> look();

 private:
  struct Watched {
    std::size_t index = 0;
    driver::Driver* driver = nullptr;
    std::uint64_t seen = 0;
  };
  std::vector<Watched> watched_;
};

}  // namespace hapticell::haptic
