// SPDX-License-Identifier: Apache-2.0
#include "app/shell/action_trail.h"

#include <ctime>
#include <string>

#include "geometry/system/plain_text.h"

namespace hapticell::app {

void ActionTrail::add(std::string_view text) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 16> time{};
  std::strftime(time.data(), time.size(), "%H:%M:%S ", &utc);
  const std::string line = plainText(time.data() + std::string(text), kLongest);
  const std::size_t count = count_.load(std::memory_order_relaxed);
  Entry& entry = entries_[count % entries_.size()];
  for (std::size_t i = 0; i < kLongest; ++i)
    entry[i].store(i < line.size() ? line[i] : '\0', std::memory_order_relaxed);
  count_.store(count + 1, std::memory_order_release);
}

}  // namespace hapticell::app
