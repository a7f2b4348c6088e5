// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace hapticell::workcell {

/// A number of type T from the first bytes of `bytes` (at least sizeof(T)), in the given byte order.
template <typename T>
T readNumber(std::string_view bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data(), sizeof(T));
  if (order != std::endian::native) {
    for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(raw[k], raw[sizeof(T) - 1 - k]);
  }
  return std::bit_cast<T>(raw);
}

}  // namespace hapticell::workcell
