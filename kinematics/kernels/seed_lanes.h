// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"

namespace hapticell::kinematics::kernels {
namespace {

/// The best of each of sixteen interleaved groups, nearest first. Sixteen floats wide, so that the compiler keeps them
/// in registers.
inline void nearestSeeds(const SeedPoses& seeds, const float* wanted, float scale, int* order) {
  float best[kSeedGroups];
  int index[kSeedGroups];
  for (int g = 0; g < kSeedGroups; ++g) {
    best[g] = 1e30f;
    index[g] = g;
  }
  for (int s = 0; s + kSeedGroups <= seeds.count; s += kSeedGroups) {
    for (int g = 0; g < kSeedGroups; ++g) {
      const float x = scale * (seeds.values[0][s + g] - wanted[0]), y = scale * (seeds.values[1][s + g] - wanted[1]),
                  z = scale * (seeds.values[2][s + g] - wanted[2]);
      const float cosine = seeds.values[3][s + g] * wanted[3] + seeds.values[4][s + g] * wanted[4] +
                           seeds.values[5][s + g] * wanted[5] + seeds.values[6][s + g] * wanted[6];
      const float cost = x * x + y * y + z * z + 4.0f * (1.0f - cosine * cosine);
      index[g] = cost < best[g] ? s + g : index[g];
      best[g] = cost < best[g] ? cost : best[g];
    }
  }
  for (int i = 0; i < kSeedGroups; ++i) {  // sixteen numbers: by insertion
    int at = i;
    for (; at > 0 && best[order[at - 1] % kSeedGroups] > best[i]; --at) order[at] = order[at - 1];
    order[at] = index[i];
  }
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
