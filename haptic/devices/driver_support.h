// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "haptic/devices/driver_interface.h"

// Helpers for writers of drivers; header only, standard library only.
namespace hapticell::driver {

/// Copies as much of `text` as fits, with a terminating zero.
template <std::size_t N>
void copyText(char (&to)[N], std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), N - 1);
  if (length > 0) std::memcpy(to, text.data(), length);  // The pointer of an empty view may be null.
  to[length] = '\0';
}

/// Fills `problem` and returns its status.
inline Status refuse(Problem& problem, Status status, std::string_view found, std::string_view fix = {}) noexcept {
  problem.status = status;
  copyText(problem.found, found);
  copyText(problem.fix, fix);
  return status;
}

/// A number for the devices seen, for Driver::presence(): practically always different for different devices, never 0.
class PresenceNumber {
 public:
  void add(std::string_view text) noexcept {
    for (const char each : text) mix(static_cast<unsigned char>(each));
    mix(0x100);  // "ab" and "c" are not "a" and "bc".
  }
  void add(std::uint32_t number) noexcept {
    for (int shift = 0; shift < 32; shift += 8) mix(number >> shift & 0xFF);
  }
  std::uint64_t value() const noexcept { return value_ != 0 ? value_ : 1; }

 private:
  /// Fowler, Noll and Vo's hash, 64 bits.
  void mix(std::uint64_t byte) noexcept { value_ = (value_ ^ byte) * 0x100000001B3u; }

  std::uint64_t value_ = 0xCBF29CE484222325u;
};

/// presence() of a driver whose find() is quick and opens nothing.
inline std::uint64_t presenceByFind(Driver& driver) noexcept {
  Found found[8];
  Problem problem;
  const std::uint32_t count = driver.find(found, 8, problem);
  PresenceNumber number;
  number.add(count);
  number.add(static_cast<std::uint32_t>(problem.status));
  for (std::uint32_t i = 0; i < std::min(count, 8u); ++i) {
    number.add(found[i].id);
    number.add(found[i].place);
    number.add(static_cast<std::uint32_t>(found[i].problem.status));
  }
  return number.value();
}

}  // namespace hapticell::driver
