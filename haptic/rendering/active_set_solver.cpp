// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/active_set_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic/rendering/violated_rows.h"

namespace hapticell::haptic {

namespace {

constexpr std::size_t kMaxActive = ActiveRows::kMost;
/// Of rows that are nearly parallel. Half: ForceRenderer.NeverPulls fails; twice: ActiveSetSolver.StaysInAnAcuteCorner.
constexpr double kRegularisation = 1e-7;
// Of the next four half and twice pass the tests of this folder.
constexpr double kTolerance = 1e-9;  // Metres a row may stay violated.
constexpr double kDependent = 1e-6;  // Squared part of a normal that the active rows do not span.
constexpr double kEntered = 1e-6;    // Metres that no row may be left by.
constexpr int kMaxSteps = 400;       // So that a tick ends.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using ActiveVector = std::array<double, kMaxActive>;

/// In pairs: six sums one after the other would have to wait for each other.
double dot(const Vector6& a, const Vector6& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]) + (a[4] * b[4] + a[5] * b[5]);
}

void addScaled(Vector6& a, double scale, const Vector6& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] += scale * b[i];
}

/// The state of Goldfarb and Idnani's method: active rows, their multipliers, and the Cholesky factor of their Gram
/// matrix plus the regularisation. An equality is handled with the sign that it was violated with.
class ActiveSet {
 public:
  ActiveSet(const RowArrays& rows, const Vector6& d0) : rows_(rows), d0_(d0), d_(d0) {}

  void beginWith(const ActiveRows& first);
  SolverResult solve();

 private:
  struct Candidate {
    std::size_t row = 0;
    double sign = 1.0;
    double value = 0.0;  ///< Signed normal . d + slack, negative.
    Vector6 normal{};    ///< With the sign.
  };
  bool isEquality(std::size_t position) const { return rows_.both_ways[row_of_[position]] != 0.0; }
  double leftBy(std::size_t position) const;
  bool chooseViolated(Candidate& candidate) const;
  bool bringIn(const Candidate& candidate);
  void solveFactor(ActiveVector& r) const;
  void drop(std::size_t position);
  void append(const Candidate& candidate, double multiplier);
  void factorise(std::size_t from);
  void moveToRows();

  const RowArrays& rows_;
  Vector6 d0_, d_;
  std::size_t count_ = 0;
  std::array<std::size_t, kMaxActive> row_of_{};
  std::array<double, kMaxActive> sign_{};
  std::array<Vector6, kMaxActive> normal_{};
  ActiveVector multiplier_{};
  std::array<ActiveVector, kMaxActive> factor_{};              // Lower triangle; of the diagonal the reciprocals.
  alignas(64) std::array<double, RowArrays::kMost> barred_{};  ///< The active rows.
  int dependent_ = 0;
  int steps_ = 0;
};

/// Signed normal . d + slack.
double ActiveSet::leftBy(std::size_t position) const {
  return dot(normal_[position], d_) + sign_[position] * rows_.slack[row_of_[position]];
}

bool ActiveSet::chooseViolated(Candidate& candidate) const {
  std::size_t row = 0;
  if (!mostViolated(rows_, barred_.data(), d_, kTolerance, row)) return false;
  candidate = {row, 1.0, 0.0, rows_.normalOf(row)};
  candidate.value = dot(candidate.normal, d_) + rows_.slack[row];
  if (rows_.both_ways[row] == 0.0 || candidate.value <= 0.0) return true;
  candidate.sign = -1.0;
  candidate.value = -candidate.value;
  for (double& number : candidate.normal) number = -number;
  return true;
}

/// The rows of the factor before `from` are those of the last time.
void ActiveSet::factorise(std::size_t from) {
  for (std::size_t i = from; i < count_; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double sum = dot(normal_[i], normal_[j]);
      for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
      factor_[i][j] = sum * factor_[j][j];
    }
    double sum = dot(normal_[i], normal_[i]) + kRegularisation;
    for (std::size_t k = 0; k < i; ++k) sum -= factor_[i][k] * factor_[i][k];
    factor_[i][i] = 1.0 / std::sqrt(std::max(sum, 1e-18));
  }
}

/// Solves for the active rows, in place.
void ActiveSet::solveFactor(ActiveVector& r) const {
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = 0; k < i; ++k) r[i] -= factor_[i][k] * r[k];
    r[i] *= factor_[i][i];
  }
  for (std::size_t i = count_; i-- > 0;) {
    for (std::size_t k = i + 1; k < count_; ++k) r[i] -= factor_[k][i] * r[k];
    r[i] *= factor_[i][i];
  }
}

void ActiveSet::drop(std::size_t position) {
  barred_[row_of_[position]] = 0.0;
  --count_;
  for (std::size_t i = position; i < count_; ++i) {
    row_of_[i] = row_of_[i + 1];
    sign_[i] = sign_[i + 1];
    normal_[i] = normal_[i + 1];
    multiplier_[i] = multiplier_[i + 1];
  }
  factorise(position);
}

void ActiveSet::append(const Candidate& candidate, double multiplier) {
  barred_[candidate.row] = kInfinity;
  row_of_[count_] = candidate.row;
  sign_[count_] = candidate.sign;
  normal_[count_] = candidate.normal;
  multiplier_[count_] = multiplier;
  ++count_;
  factorise(count_ - 1);
}

/// The nearest motion on all active rows, and their multipliers.
void ActiveSet::moveToRows() {
  d_ = d0_;
  for (std::size_t i = 0; i < count_; ++i) multiplier_[i] = -leftBy(i);
  solveFactor(multiplier_);
  for (std::size_t i = 0; i < count_; ++i) addScaled(d_, multiplier_[i], normal_[i]);
}

/// Those of `first` that press when the motion is on them all: with them the method is where it could have come to by
/// itself.
void ActiveSet::beginWith(const ActiveRows& first) {
  for (std::size_t i = 0; i < first.count; ++i) {
    const std::size_t row = first.row[i];
    if (row >= rows_.count || barred_[row] != 0.0) continue;
    append({row, 1.0, 0.0, rows_.normalOf(row)}, 0.0);
    const double inverse = factor_[count_ - 1][count_ - 1];
    if (inverse * inverse * (kDependent + kRegularisation) > 1.0) drop(count_ - 1);
  }
  while (count_ > 0) {
    moveToRows();
    std::size_t leaving = count_;
    double least = kTolerance;
    for (std::size_t i = 0; i < count_; ++i) {
      if (isEquality(i) || multiplier_[i] >= least) continue;
      least = multiplier_[i];
      leaving = i;
    }
    if (leaving == count_) return;
    drop(leaving);
  }
  d_ = d0_;
}

/// Raises the candidate's multiplier from zero until its row holds, dropping rows that would begin to pull. False when
/// the method should stop.
bool ActiveSet::bringIn(const Candidate& candidate) {
  double multiplier = 0.0;
  double value = candidate.value;
  while (steps_++ < kMaxSteps) {
    ActiveVector r{};
    for (std::size_t i = 0; i < count_; ++i) r[i] = dot(normal_[i], candidate.normal);
    solveFactor(r);
    Vector6 z = candidate.normal;
    for (std::size_t i = 0; i < count_; ++i) addScaled(z, -r[i], normal_[i]);
    const double gain = dot(z, candidate.normal) + kRegularisation;
    const double full = -value / gain;
    double partial = kInfinity;
    std::size_t leaving = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (isEquality(i) || r[i] <= 1e-12 || multiplier_[i] >= partial * r[i]) continue;
      partial = multiplier_[i] / r[i];
      leaving = i;
    }
    const double t = std::min(full, partial);
    addScaled(d_, t, z);
    for (std::size_t i = 0; i < count_; ++i) multiplier_[i] -= t * r[i];
    multiplier += t;
    value += t * gain;
    if (partial < full) {
      drop(leaving);
      continue;
    }
    if (dot(z, z) < kDependent) ++dependent_;
    if (count_ == kMaxActive) return false;
    append(candidate, multiplier);
    return dependent_ < 2;
  }
  return false;
}

SolverResult ActiveSet::solve() {
  SolverResult result;
  Candidate candidate;
  while (chooseViolated(candidate)) {
    if (bringIn(candidate)) continue;
    result.status = dependent_ >= 2 || count_ == kMaxActive ? SolverStatus::kInfeasible : SolverStatus::kGaveUp;
    break;
  }
  // One dependent row can be met only by the regularisation's softness: then the rows contradict each other.
  for (std::size_t i = 0; i < count_; ++i) {
    if (result.status == SolverStatus::kSolved && leftBy(i) < -1e-7) result.status = SolverStatus::kInfeasible;
    result.multiplier[row_of_[i]] = sign_[i] * multiplier_[i];
    result.active.row[i] = static_cast<std::uint8_t>(row_of_[i]);
  }
  result.active_count = count_;
  if (result.status == SolverStatus::kSolved) result.active.count = count_;
  result.d = d_;
  return result;
}

RowArrays arraysOf(std::span<const SolverRow> rows) {
  RowArrays arrays;
  for (const SolverRow& row : rows.first(std::min(rows.size(), kMaxRows))) arrays.add(row);
  arrays.fillLastVector();
  return arrays;
}

}  // namespace

SolverResult nearestFeasible(const RowArrays& rows, const Vector6& d0, const ActiveRows& begin_with) noexcept {
  if (begin_with.count > 0) {
    ActiveSet set(rows, d0);
    set.beginWith(begin_with);
    const SolverResult result = set.solve();
    // Where rows contradict each other the method stops early, and where, its way decides.
    if (result.status == SolverStatus::kSolved) return result;
  }
  return ActiveSet(rows, d0).solve();
}

SolverResult nearestFeasible(std::span<const SolverRow> rows, const Vector6& d0) noexcept {
  return nearestFeasible(arraysOf(rows), d0);
}

SolverResult nearestUnentered(const RowArrays& rows, const Vector6& d0, const ActiveRows& begin_with) noexcept {
  const SolverResult middle = nearestFeasible(rows, d0, begin_with);
  if (middle.status == SolverStatus::kSolved) return middle;
  const auto isEquality = [&](std::size_t i) { return rows.both_ways[i] != 0.0; };
  double deepest = 0.0;
  for (std::size_t i = 0; i < rows.count; ++i) deepest = std::max(deepest, isEquality(i) ? 0.0 : -rows.slack[i]);
  RowArrays kept = rows;
  for (std::size_t i = 0; i < rows.count; ++i) {
    if (!isEquality(i) && rows.slack[i] < 0.0) kept.slack[i] += deepest;
  }
  SolverResult result = nearestFeasible(kept, middle.d);
  // Equalities may still contradict; standing still enters nothing.
  for (std::size_t i = 0; i < rows.count; ++i) {
    if (isEquality(i) || dot(kept.normalOf(i), result.d) + kept.slack[i] > -kEntered) continue;
    result.d = {};
    break;
  }
  result.status = middle.status;
  result.active = {};
  for (std::size_t i = 0; i < rows.count; ++i) result.multiplier[i] += middle.multiplier[i];
  result.active_count = std::max(result.active_count, middle.active_count);
  return result;
}

SolverResult nearestUnentered(std::span<const SolverRow> rows, const Vector6& d0) noexcept {
  return nearestUnentered(arraysOf(rows), d0);
}

}  // namespace hapticell::haptic
