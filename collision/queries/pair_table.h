// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace hapticell::collision {

/// The index of a pair by the numbers of its two parts, in either order. One thread; only insert() allocates.
class PairTable {
 public:
  static constexpr std::uint32_t kNone = ~0u;

  /// kNone where the pair is not there. The two numbers differ.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
    if (slots_.empty()) return kNone;
    const std::uint64_t key = keyOf(a, b);
    for (std::size_t at = home(key);; at = next(at)) {
      if (slots_[at].key == key) return slots_[at].index;
      if (slots_[at].key == kFree) return kNone;
    }
  }
  /// Adds the pair, or changes its index.
  void set(std::uint32_t a, std::uint32_t b, std::uint32_t index);
  void erase(std::uint32_t a, std::uint32_t b);
  void clear();
  std::size_t size() const { return count_; }

 private:
  static constexpr std::uint64_t kFree = 0;  // No pair has this key: its larger number is at least 1.
  struct Slot {
    std::uint64_t key = kFree;
    std::uint32_t index = 0;
  };

  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    return a < b ? (std::uint64_t{a} << 32 | b) : (std::uint64_t{b} << 32 | a);
  }
  /// The upper bits of a product with 2^64 divided by the golden ratio (Knuth, "The Art of Computer Programming", 6.4).
  std::size_t home(std::uint64_t key) const { return (key * 0x9E3779B97F4A7C15u) >> shift_; }
  std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }
  void grow();

  std::vector<Slot> slots_;  ///< A power of two, at most half of them in use.
  std::size_t count_ = 0;
  int shift_ = 64;
};

}  // namespace hapticell::collision
