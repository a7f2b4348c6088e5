// SPDX-License-Identifier: Apache-2.0
// Included by what is compiled for different instruction sets: no library, and no function that a linker could share.
#pragma once

#include <cstddef>

namespace hapticell::haptic {
namespace {

/// Numbers that are worked on together: four doubles are a vector of AVX2, or two of SSE2.
constexpr std::size_t kLanes = 4;
using Lanes = double __attribute__((vector_size(32)));

inline __attribute__((always_inline)) Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof(Lanes));
  return lanes;
}
inline __attribute__((always_inline)) void store(double* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof(Lanes));
}

}  // namespace
}  // namespace hapticell::haptic
