// SPDX-License-Identifier: Apache-2.0
#include <atomic>

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

namespace {

const Table* best() {
  return avx2Table() != nullptr ? avx2Table() : plainTable();
}

// Set before main, changed only by usePlain().
std::atomic<const Table*> chosen{best()};

}  // namespace

const Table& table() {
  return *chosen.load(std::memory_order_relaxed);
}

void usePlain(bool plain) {
  chosen = plain ? plainTable() : best();
}

}  // namespace hapticell::kinematics::kernels
