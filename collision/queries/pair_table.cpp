// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/pair_table.h"

#include <algorithm>
#include <utility>

namespace hapticell::collision {

void PairTable::set(std::uint32_t a, std::uint32_t b, std::uint32_t index) {
  if (2 * (count_ + 1) > slots_.size()) grow();
  const std::uint64_t key = keyOf(a, b);
  std::size_t at = home(key);
  while (slots_[at].key != kFree && slots_[at].key != key) at = next(at);
  if (slots_[at].key == kFree) ++count_;
  slots_[at] = {key, index};
}

void PairTable::erase(std::uint32_t a, std::uint32_t b) {
  if (slots_.empty()) return;
  const std::uint64_t key = keyOf(a, b);
  std::size_t at = home(key);
  while (slots_[at].key != key) {
    if (slots_[at].key == kFree) return;
    at = next(at);
  }
  --count_;
  // What stands behind it and may stand here moves up, so that no search ends too soon.
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t behind = next(at); slots_[behind].key != kFree; behind = next(behind)) {
    const std::size_t wanted = home(slots_[behind].key);
    if (((behind - wanted) & mask) < ((behind - at) & mask)) continue;
    slots_[at] = slots_[behind];
    at = behind;
  }
  slots_[at] = {};
}

void PairTable::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  count_ = 0;
}

void PairTable::grow() {
  constexpr std::size_t kFirst = 64;
  const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(std::max(kFirst, 2 * slots_.size())));
  shift_ = 64;
  for (std::size_t size = slots_.size(); size > 1; size /= 2) --shift_;
  for (const Slot& slot : old) {
    if (slot.key == kFree) continue;
    std::size_t at = home(slot.key);
    while (slots_[at].key != kFree) at = next(at);
    slots_[at] = slot;
  }
}

}  // namespace hapticell::collision
