// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/presence_watch.h"

#include <utility>

namespace hapticell::haptic {

PresenceWatch::PresenceWatch(const std::vector<LoadedDriver>& drivers) {
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    driver::Driver* const one = drivers[i].driver;
    if (one == nullptr) continue;
    // What cannot tell at first cannot later either.
    if (const std::uint64_t seen = one->presence(); seen != 0) watched_.push_back({i, one, seen});
  }
}

std::vector<std::size_t> PresenceWatch::look() {
  std::vector<std::size_t> changed;
  for (Watched& each : watched_) {
    const std::uint64_t now = each.driver->presence();
    if (now != std::exchange(each.seen, now)) changed.push_back(each.index);
  }
  return changed;
}

}  // namespace hapticell::haptic
