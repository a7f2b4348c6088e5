// SPDX-License-Identifier: Apache-2.0
// Compiled with AVX2 and FMA where the compiler has them (see CMakeLists.txt): nothing but the kernels belongs here.
#include "kinematics/kernels/loop_lanes.h"

namespace hapticell::kinematics::kernels {

extern const LoopTable* const kAvx2LoopTable;
#if defined(__AVX2__) && defined(__FMA__)
static constexpr LoopTable kTable = loopTableNamed("avx2");
const LoopTable* const kAvx2LoopTable = &kTable;
#else
const LoopTable* const kAvx2LoopTable = nullptr;
#endif

}  // namespace hapticell::kinematics::kernels
