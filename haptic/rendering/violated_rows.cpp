// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/violated_rows.h"

#include "haptic/rendering/violated_rows_body.h"

namespace hapticell::haptic {

#ifdef HAPTICELL_X86_KERNELS
bool worstRowByAvx2(const RowArrays& rows, const double* d, double tolerance, std::size_t& row);
#endif

namespace {

using WorstRow = bool (*)(const RowArrays&, const double*, double, std::size_t&);

WorstRow widestWorstRow() {
#ifdef HAPTICELL_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) return worstRowByAvx2;
#endif
  return worstRowOf;
}

const WorstRow worst_row = widestWorstRow();

}  // namespace

bool mostViolated(const RowArrays& rows, const Vector6& d, double tolerance, std::size_t& row) noexcept {
  return worst_row(rows, d.data(), tolerance, row);
}

bool mostViolatedPortably(const RowArrays& rows, const Vector6& d, double tolerance, std::size_t& row) noexcept {
  return worstRowOf(rows, d.data(), tolerance, row);
}

}  // namespace hapticell::haptic
