// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <ranges>
#include <span>
#include <type_traits>

namespace hapticell::test {

/// Whether two values, or two rows of values, are the same to the last bit. Of values without padding only.
template <typename T>
bool sameBits(const T& a, const T& b) {
  const auto bytes = [](const T& value) {
    if constexpr (std::ranges::contiguous_range<const T>) {
      return std::as_bytes(std::span(value));
    } else {
      static_assert(std::is_standard_layout_v<T>);
      return std::as_bytes(std::span(&value, 1));
    }
  };
  const auto bytes_a = bytes(a), bytes_b = bytes(b);
  return std::equal(bytes_a.begin(), bytes_a.end(), bytes_b.begin(), bytes_b.end());
}

}  // namespace hapticell::test
