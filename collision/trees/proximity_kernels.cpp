// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/proximity_kernels.h"

#include <cstdlib>
#include <string_view>

namespace hapticell::collision {

extern const ProximityKernels kKernelsPortable;
#ifdef HAPTICELL_X86_KERNELS
extern const ProximityKernels kKernelsAvx2;
extern const ProximityKernels kKernelsAvx512;
#endif

namespace {

const ProximityKernels& chosen() {
  if (const char* wanted = std::getenv("HAPTICELL_SIMD")) {
    if (const ProximityKernels* kernels = proximityKernels(wanted)) return *kernels;
  }
  for (const char* name : {"avx512", "avx2"}) {
    if (const ProximityKernels* kernels = proximityKernels(name)) return *kernels;
  }
  return kKernelsPortable;
}

}  // namespace

const ProximityKernels* proximityKernels(const char* name) {
  const std::string_view wanted(name);
  if (wanted == "portable") return &kKernelsPortable;
#ifdef HAPTICELL_X86_KERNELS
  __builtin_cpu_init();
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (wanted == "avx2" && has_avx2) return &kKernelsAvx2;
  const bool has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  if (wanted == "avx512" && has_avx512) return &kKernelsAvx512;
#endif
  return nullptr;
}

const ProximityKernels& proximityKernels() {
  static const ProximityKernels& kernels = chosen();
  return kernels;
}

}  // namespace hapticell::collision
