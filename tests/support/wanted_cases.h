// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>

namespace hapticell::test {

/// Whether every case is wanted, not the part of them that ./check takes (tools/check_more samples).
inline bool allCasesAreWanted() {
  return std::getenv("HAPTICELL_ALL_CASES") != nullptr;
}

}  // namespace hapticell::test
