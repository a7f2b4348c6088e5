// SPDX-License-Identifier: Apache-2.0
#include "kinematics/kernels/kernel_table.h"

namespace hapticell::kinematics::kernels {

const Table* plainTable() {
  static constexpr Table kTable = tableNamed("plain");
  return &kTable;
}

}  // namespace hapticell::kinematics::kernels
