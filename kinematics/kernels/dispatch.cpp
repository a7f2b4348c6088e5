// SPDX-License-Identifier: Apache-2.0
#include "kinematics/kernels/kernels.h"

namespace hapticell::kinematics::kernels {

extern const Table* const kAvx2Table;

const Table* avx2Table() {
#if defined(__x86_64__)
  static const bool can_run = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return can_run ? kAvx2Table : nullptr;
#else
  return nullptr;
#endif
}

const Table& table() {
  static const Table& chosen = avx2Table() != nullptr ? *avx2Table() : *plainTable();
  return chosen;
}

}  // namespace hapticell::kinematics::kernels
