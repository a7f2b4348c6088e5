// SPDX-License-Identifier: Apache-2.0
#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/loop_lanes.h"

namespace hapticell::kinematics::kernels {

extern const LoopTable* const kAvx2LoopTable;

const LoopTable* plainLoopTable() {
  static constexpr LoopTable kPlain = loopTableNamed("plain");
  return &kPlain;
}

const LoopTable* avx2LoopTable() {
  return avx2Table() != nullptr ? kAvx2LoopTable : nullptr;
}

const LoopTable& loopTable() {
  static const LoopTable& chosen = avx2LoopTable() != nullptr ? *avx2LoopTable() : *plainLoopTable();
  return chosen;
}

}  // namespace hapticell::kinematics::kernels
