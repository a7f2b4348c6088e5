// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hapticell::trajectory {

std::string shortestText(double value) {
  // "-0" would come back as a whole number without its sign.
  if (value == 0.0 && std::signbit(value)) return "-0.0";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string fixedText(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  if (std::abs(value) < 0.5 * unit) value = 0.0;
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals).ptr;
  return {buffer.data(), end};
}

}  // namespace hapticell::trajectory
