// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/violated_rows.h"

#include <limits>

#include "haptic/rendering/violated_rows_body.h"

namespace hapticell::haptic {

#ifdef HAPTICELL_X86_KERNELS
bool worstRowByAvx2(const RowArrays& rows, const double* barred, const double* d, double tolerance, std::size_t& row);
#endif

namespace {

using WorstRow = bool (*)(const RowArrays&, const double*, const double*, double, std::size_t&);

WorstRow widestWorstRow() {
#ifdef HAPTICELL_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) return worstRowByAvx2;
#endif
  return worstRowOf;
}

const WorstRow worst_row = widestWorstRow();

}  // namespace

bool mostViolated(const RowArrays& rows, const double* barred, const Vector6& d, double tolerance,
                  std::size_t& row) noexcept {
  return worst_row(rows, barred, d.data(), tolerance, row);
}

bool mostViolatedPortably(const RowArrays& rows, const double* barred, const Vector6& d, double tolerance,
                          std::size_t& row) noexcept {
  return worstRowOf(rows, barred, d.data(), tolerance, row);
}

Vector6 RowArrays::normalOf(std::size_t i) const {
  return {normal[0][i], normal[1][i], normal[2][i], normal[3][i], normal[4][i], normal[5][i]};
}

void RowArrays::put(std::size_t i, const SolverRow& row) {
  for (std::size_t k = 0; k < 6; ++k) normal[k][i] = row.normal[k];
  slack[i] = row.slack;
  both_ways[i] = row.equality ? 1.0 : 0.0;
}

void RowArrays::fillLastVector() {
  for (std::size_t i = count; i % kLanes != 0; ++i) put(i, {{}, std::numeric_limits<double>::infinity(), false});
}

}  // namespace hapticell::haptic
