// SPDX-License-Identifier: Apache-2.0
// Compiled with AVX2 and FMA where the compiler has them (see CMakeLists.txt): nothing but the kernels belongs here.
#include "kinematics/kernels/kernel_table.h"

namespace hapticell::kinematics::kernels {

extern const Table* const kAvx2Table;
#if defined(__AVX2__) && defined(__FMA__)
static constexpr Table kTable = tableNamed("avx2");
const Table* const kAvx2Table = &kTable;
#else
const Table* const kAvx2Table = nullptr;
#endif

}  // namespace hapticell::kinematics::kernels
