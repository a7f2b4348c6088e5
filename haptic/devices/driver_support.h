// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>
#include <string_view>

#include "haptic/devices/driver_interface.h"

// Helpers for writers of drivers; header only, standard library only.
namespace hapticell::driver {

/// Copies as much of `text` as fits, zero-terminated.
template <std::size_t N>
void copyText(char (&to)[N], std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), N - 1);
  if (length > 0) std::memcpy(to, text.data(), length);  // An empty view may point nowhere.
  to[length] = '\0';
}

/// Fills `problem` and returns its status.
inline Status refuse(Problem& problem, Status status, std::string_view found, std::string_view fix = {}) noexcept {
  problem.status = status;
  copyText(problem.found, found);
  copyText(problem.fix, fix);
  return status;
}

}  // namespace hapticell::driver
