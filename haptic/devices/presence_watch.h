// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptic/devices/driver_library.h"

namespace hapticell::haptic {

/// Notices devices that come and go, without opening any: asks the drivers for Driver::presence(). One thread.
class PresenceWatch {
 public:
  /// Drivers that could not be loaded are left out. They outlive the watch.
  explicit PresenceWatch(const std::vector<LoadedDriver>& drivers);
  /// Which of the drivers (indices as given) see something else than at the last look, or since the watch began. Those
  /// that cannot tell are never among them.
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
