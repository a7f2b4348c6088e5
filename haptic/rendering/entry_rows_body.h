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
/// the inverse left Jacobian of SO(3), here to second order, which is right to 0.1 % at 0.5 rad.
class MetricChange {
 public:
  inline __attribute__((always_inline)) MetricChange(const double* theta, double lever) {
    const double x = theta[0], y = theta[1], z = theta[2], squares = x * x + y * y + z * z;
    // 1 + [theta] / 2 + [theta]^2 / 12, where [theta]^2 = theta theta' - |theta|^2.
    const double half[3][3] = {{0.0, -0.5 * z, 0.5 * y}, {0.5 * z, 0.0, -0.5 * x}, {-0.5 * y, 0.5 * x, 0.0}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double square = theta[i] * theta[j] - (i == j ? squares : 0.0);
        part_[i][j] = ((i == j ? 1.0 : 0.0) + half[i][j] + square / 12.0) / lever;
      }
    }
  }
  inline __attribute__((always_inline)) void apply(Lanes* g) const {
    const Lanes a = g[3], b = g[4], c = g[5];
    for (std::size_t i = 0; i < 3; ++i) g[3 + i] = part_[i][0] * a + part_[i][1] * b + part_[i][2] * c;
  }

 private:
  double part_[3][3];
};

inline __attribute__((always_inline)) Lanes lengthOfAll(const Lanes* v) {
  Lanes sum{};
  for (std::size_t i = 0; i < 6; ++i) sum += v[i] * v[i];
  return root(sum);
}

/// Adds the curvature's row i and what mirrors it, times xi; then those that follow. By a template: as a loop in a loop
/// the compiler keeps g in memory.
template <std::size_t i>
inline __attribute__((always_inline)) void addCurvature(const EntryArrays& entries, std::size_t first, const Lanes* xi,
                                                        Lanes* g) {
  constexpr std::size_t kDiagonal = i * (13 - i) / 2;  // Of SymmetricMatrix6.
  g[i] += load(&entries.curvature[kDiagonal][first]) * xi[i];
  for (std::size_t j = i + 1; j < 6; ++j) {
    const Lanes b = load(&entries.curvature[kDiagonal + j - i][first]);
    g[i] += b * xi[j];
    g[j] += b * xi[i];
  }
  if constexpr (i < 5) addCurvature<i + 1>(entries, first, xi, g);
}

template <bool kTrims>
inline __attribute__((always_inline)) void rowsOfAllBy(const EntryArrays& entries, const double* at, double age,
                                                       EntryRows& rows) {
  const MetricChange to_metric(at + 3, kRotationLever);
  for (std::size_t first = 0; first < entries.count; first += kLanes) {
    Lanes xi[6], g[6];
    for (std::size_t i = 0; i < 3; ++i) xi[i] = at[i] - age * load(&entries.velocity[i][first]);
    for (std::size_t i = 3; i < 6; ++i) xi[i] = at[i] + Lanes{};
    for (std::size_t i = 0; i < 6; ++i) g[i] = Lanes{};
    addCurvature<0>(entries, first, xi, g);
    Lanes value = load(&entries.gap[first]);
    for (std::size_t i = 0; i < 6; ++i) {
      const Lanes a = load(&entries.gradient[i][first]);
      value += (a + 0.5 * g[i]) * xi[i];
      g[i] += a;
    }
    to_metric.apply(g);
    const Lanes length = lengthOfAll(g);
    Lanes per_length = 1.0 / length, slack = value * per_length;
    store(&rows.length[first], length);
    if constexpr (kTrims) {
      Lanes trim[6], trim_value = load(&entries.trim_gap[first]);
      for (std::size_t i = 0; i < 6; ++i) {
        trim[i] = load(&entries.trim_gradient[i][first]);
        trim_value += trim[i] * xi[i];
      }
      to_metric.apply(trim);
      const Lanes trim_length = lengthOfAll(trim), per_trim = 1.0 / trim_length, trim_slack = trim_value * per_trim;
      const auto by_trim = (trim_length > kLeastSlope) & (trim_slack < slack);
      slack = by_trim ? trim_slack : slack;
      per_length = by_trim ? per_trim : per_length;
      for (std::size_t i = 0; i < 6; ++i) g[i] = by_trim ? trim[i] : g[i];
    }
    store(&rows.slack[first], slack);
    for (std::size_t i = 0; i < 6; ++i) store(&rows.normal[i][first], g[i] * per_length);
  }
}

void rowsOfAll(const EntryArrays& entries, const double* at, double age, EntryRows& rows) {
  if (entries.any_trim) return rowsOfAllBy<true>(entries, at, age, rows);
  rowsOfAllBy<false>(entries, at, age, rows);
}

}  // namespace
}  // namespace hapticell::haptic
