// SPDX-License-Identifier: Apache-2.0
// Included once by each of entry_rows*.cpp, which are compiled for different instruction sets. No library, and no
// function of a header: the linker might use a copy that was compiled for a new processor everywhere.
#include <cstddef>

namespace hapticell::haptic {
namespace {

/// Numbers that are worked on together: four doubles are a vector of AVX2, or two of SSE2.
constexpr std::size_t kLanes = 4;
using Lanes = double __attribute__((vector_size(32)));

inline __attribute__((always_inline)) Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof(Lanes));
  return lanes;
}
inline __attribute__((always_inline)) void store(double* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof(Lanes));
}
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

void rowsOfAll(const EntryArrays& entries, const double* at, double age, EntryRows& rows) {
  const double* const theta = at + 3;
  for (std::size_t first = 0; first < entries.count; first += kLanes) {
    Lanes xi[6], g[6], trim[6];
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
    Lanes value = load(&entries.gap[first]), trim_value = load(&entries.trim_gap[first]);
    for (std::size_t i = 0; i < 6; ++i) {
      const Lanes a = load(&entries.gradient[i][first]);
      value += (a + 0.5 * g[i]) * xi[i];
      g[i] += a;
      trim[i] = load(&entries.trim_gradient[i][first]);
      trim_value += trim[i] * xi[i];
    }
    toMetric(g, theta, kRotationLever);
    toMetric(trim, theta, kRotationLever);
    const Lanes length = lengthOfAll(g), trim_length = lengthOfAll(trim);
    store(&rows.length[first], length);
    const Lanes slack = value / length, trim_slack = trim_value / trim_length;
    const auto by_trim = (trim_length > kLeastSlope) & (trim_slack < slack);
    store(&rows.slack[first], by_trim ? trim_slack : slack);
    const Lanes divisor = by_trim ? trim_length : length;
    for (std::size_t i = 0; i < 6; ++i) store(&rows.normal[i][first], (by_trim ? trim[i] : g[i]) / divisor);
  }
}

}  // namespace
}  // namespace hapticell::haptic
