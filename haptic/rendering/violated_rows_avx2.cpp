// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/violated_rows.h"
#include "haptic/rendering/violated_rows_body.h"

namespace hapticell::haptic {

bool worstRowByAvx2(const RowArrays& rows, const double* barred, const double* d, double tolerance, std::size_t& row);
bool worstRowByAvx2(const RowArrays& rows, const double* barred, const double* d, double tolerance, std::size_t& row) {
  return worstRowOf(rows, barred, d, tolerance, row);
}

}  // namespace hapticell::haptic
