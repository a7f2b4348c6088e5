// SPDX-License-Identifier: Apache-2.0
// Included once by each of entry_rows*.cpp, which are compiled for different instruction sets. No library, and no
// function of a header: the linker might use a copy that was compiled for a new processor everywhere.
#include <cstddef>

#include "haptic/rendering/lanes.h"

namespace hapticell::haptic {
namespace {

inline __attribute__((always_inline)) Lanes root(Lanes lanes) {
  Lanes result;
  for (std::size_t i = 0; i < kLanes; ++i) result[i] = __builtin_sqrt(lanes[i]);
  return result;
}

/// A gradient over xi as one over the proxy's small motion at xi. A small rotation changes the rotation vector theta by
/// the inverse left Jacobian of SO(3), here to second order, which is right to 0.1 % at 0.5 rad. The same as
/// theta x g twice.
inline __attribute__((always_inline)) void toMetric(Lanes* g, const double* theta, double lever) {
  const Lanes once[3] = {theta[1] * g[5] - g[4] * theta[2], theta[2] * g[3] - g[5] * theta[0],
                         theta[0] * g[4] - g[3] * theta[1]};
  const Lanes twice[3] = {theta[1] * once[2] - once[1] * theta[2], theta[2] * once[0] - once[2] * theta[0],
                          theta[0] * once[1] - once[0] * theta[1]};
  for (std::size_t i = 0; i < 3; ++i) g[3 + i] = (g[3 + i] + 0.5 * once[i] + twice[i] / 12.0) / lever;
}

inline __attribute__((always_inline)) Lanes lengthOfAll(const Lanes* v) {
  Lanes sum{};
  for (std::size_t i = 0; i < 6; ++i) sum += v[i] * v[i];
  return root(sum);
}

template <bool kTrims>
inline __attribute__((always_inline)) void rowsOfAllBy(const EntryArrays& entries, const double* at, double age,
                                                       EntryRows& rows) {
  const double* const theta = at + 3;
  for (std::size_t first = 0; first < entries.count; first += kLanes) {
    Lanes xi[6], g[6];
    for (std::size_t i = 0; i < 3; ++i) xi[i] = at[i] - age * load(&entries.velocity[i][first]);
    for (std::size_t i = 3; i < 6; ++i) xi[i] = at[i] + Lanes{};
    for (std::size_t i = 0; i < 6; ++i) g[i] = Lanes{};
    for (std::size_t i = 0, k = 0; i < 6; ++i) {
      for (std::size_t j = i; j < 6; ++j, ++k) {
        const Lanes b = load(&entries.curvature[k][first]);
        g[i] += b * xi[j];
        if (i != j) g[j] += b * xi[i];
      }
    }
    Lanes value = load(&entries.gap[first]);
    for (std::size_t i = 0; i < 6; ++i) {
      const Lanes a = load(&entries.gradient[i][first]);
      value += (a + 0.5 * g[i]) * xi[i];
      g[i] += a;
    }
    toMetric(g, theta, kRotationLever);
    const Lanes length = lengthOfAll(g), slack = value / length;
    store(&rows.length[first], length);
    if constexpr (!kTrims) {
      store(&rows.slack[first], slack);
      for (std::size_t i = 0; i < 6; ++i) store(&rows.normal[i][first], g[i] / length);
      continue;
    }
    Lanes trim[6], trim_value = load(&entries.trim_gap[first]);
    for (std::size_t i = 0; i < 6; ++i) {
      trim[i] = load(&entries.trim_gradient[i][first]);
      trim_value += trim[i] * xi[i];
    }
    toMetric(trim, theta, kRotationLever);
    const Lanes trim_length = lengthOfAll(trim), trim_slack = trim_value / trim_length;
    const auto by_trim = (trim_length > kLeastSlope) & (trim_slack < slack);
    store(&rows.slack[first], by_trim ? trim_slack : slack);
    const Lanes divisor = by_trim ? trim_length : length;
    for (std::size_t i = 0; i < 6; ++i) store(&rows.normal[i][first], (by_trim ? trim[i] : g[i]) / divisor);
  }
}

void rowsOfAll(const EntryArrays& entries, const double* at, double age, EntryRows& rows) {
  if (entries.any_trim) return rowsOfAllBy<true>(entries, at, age, rows);
  rowsOfAllBy<false>(entries, at, age, rows);
}

}  // namespace
}  // namespace hapticell::haptic
