// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/assertion.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace hapticell {

namespace {

std::array<char, 512> broken{};
std::atomic<bool> is_taken{false}, is_there{false};

}  // namespace

const char* brokenContract() {
  return is_there.load(std::memory_order_acquire) ? broken.data() : "";
}

void detail::contractBroken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, condition);
  if (!is_taken.exchange(true)) {
    const char* slash = std::strrchr(file, '/');
    std::snprintf(broken.data(), broken.size(), "%s:%d: %s", slash ? slash + 1 : file, line, condition);
    is_there.store(true, std::memory_order_release);
  }
  std::abort();
}

}  // namespace hapticell
