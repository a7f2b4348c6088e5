// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace hapticell::agents {

/// Random numbers that a seed decides: SplitMix64 (Steele, Lea, Flood 2014). Equal on all machines, whatever the
/// standard library.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double share() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  /// In [-most, most).
  double within(double most) { return most * (2.0 * share() - 1.0); }

 private:
  std::uint64_t state_;
};

}  // namespace hapticell::agents
