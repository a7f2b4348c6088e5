// SPDX-License-Identifier: Apache-2.0
#include "geometry/assertion.h"

#include <cstdio>
#include <cstdlib>

namespace hapticell::detail {

void contractBroken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, condition);
  std::abort();
}

}  // namespace hapticell::detail
