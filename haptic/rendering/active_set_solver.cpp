// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/active_set_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic/rendering/violated_rows.h"

namespace hapticell::haptic {

namespace {

constexpr std::size_t kMaxActive = 8;  // Six independent rows and two dependent ones.
/// Of rows that are nearly parallel. Half: ForceRenderer.NeverPulls fails; twice: ActiveSetSolver.StaysInAnAcuteCorner.
constexpr double kRegularisation = 1e-7;
// Of the next four half and twice pass the tests of this folder.
constexpr double kTolerance = 1e-9;  // Metres a row may stay violated.
constexpr double kDependent = 1e-6;  // Squared part of a normal that the active rows do not span.
constexpr double kEntered = 1e-6;    // Metres that no row may be left by.
constexpr int kMaxSteps = 400;       // So that a tick ends.
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using ActiveVector = std::array<double, kMaxActive>;

double dot(const Vector6& a, const Vector6& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

void addScaled(Vector6& a, double scale, const Vector6& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] += scale * b[i];
}

/// The state of Goldfarb and Idnani's method: active rows, their multipliers, and the Cholesky factor of their Gram
/// matrix plus the regularisation. An equality is handled with the sign that it was violated with.
class ActiveSet {
 public:
  ActiveSet(std::span<const SolverRow> rows, const Vector6& d0);

  SolverResult solve();

 private:
  struct Candidate {
    std::size_t row = 0;
    double sign = 1.0;
    double value = 0.0;  ///< Signed normal . d + slack, negative.
  };
  bool chooseViolated(Candidate& candidate) const;
  bool bringIn(const Candidate& candidate);
  void stepDirection(const Vector6& normal, ActiveVector& r, Vector6& z) const;
  void drop(std::size_t position);
  void append(std::size_t row, double sign, double multiplier);
  void factorise(std::size_t from);

  std::span<const SolverRow> rows_;
  Vector6 d_;
  std::size_t count_ = 0;
  std::array<std::size_t, kMaxActive> row_of_{};
  std::array<double, kMaxActive> sign_{};
  std::array<Vector6, kMaxActive> normal_{};
  ActiveVector multiplier_{};
  std::array<ActiveVector, kMaxActive> factor_{};  // Lower triangle.
  RowArrays arrays_;  ///< Of all rows; the active ones are barred.
  int dependent_ = 0;
  int steps_ = 0;
};

ActiveSet::ActiveSet(std::span<const SolverRow> rows, const Vector6& d0) : rows_(rows), d_(d0) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) arrays_.normal[k][i] = rows[i].normal[k];
    arrays_.slack[i] = rows[i].slack;
    arrays_.both_ways[i] = rows[i].equality ? 1.0 : 0.0;
    arrays_.barred[i] = 0.0;
  }
  for (arrays_.count = rows.size(); arrays_.count % 4 != 0; ++arrays_.count) {
    for (auto& numbers : arrays_.normal) numbers[arrays_.count] = 0.0;
    arrays_.slack[arrays_.count] = arrays_.both_ways[arrays_.count] = 0.0;
    arrays_.barred[arrays_.count] = kInfinity;
  }
}

bool ActiveSet::chooseViolated(Candidate& candidate) const {
  std::size_t row = 0;
  if (!mostViolated(arrays_, d_, kTolerance, row)) return false;
  const double value = dot(rows_[row].normal, d_) + rows_[row].slack;
  const double sign = rows_[row].equality && value > 0.0 ? -1.0 : 1.0;
  candidate = {row, sign, sign * value};
  return true;
}

/// The rows of the factor before `from` are those of the last time.
void ActiveSet::factorise(std::size_t from) {
  for (std::size_t i = from; i < count_; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = dot(normal_[i], normal_[j]) + (i == j ? kRegularisation : 0.0);
      for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
      factor_[i][j] = i == j ? std::sqrt(std::max(sum, 1e-18)) : sum / factor_[j][j];
    }
  }
}

void ActiveSet::stepDirection(const Vector6& normal, ActiveVector& r, Vector6& z) const {
  for (std::size_t i = 0; i < count_; ++i) {
    r[i] = dot(normal_[i], normal);
    for (std::size_t k = 0; k < i; ++k) r[i] -= factor_[i][k] * r[k];
    r[i] /= factor_[i][i];
  }
  for (std::size_t i = count_; i-- > 0;) {
    for (std::size_t k = i + 1; k < count_; ++k) r[i] -= factor_[k][i] * r[k];
    r[i] /= factor_[i][i];
  }
  z = normal;
  for (std::size_t i = 0; i < count_; ++i) addScaled(z, -r[i], normal_[i]);
}

void ActiveSet::drop(std::size_t position) {
  arrays_.barred[row_of_[position]] = 0.0;
  --count_;
  for (std::size_t i = position; i < count_; ++i) {
    row_of_[i] = row_of_[i + 1];
    sign_[i] = sign_[i + 1];
    normal_[i] = normal_[i + 1];
    multiplier_[i] = multiplier_[i + 1];
  }
  factorise(position);
}

void ActiveSet::append(std::size_t row, double sign, double multiplier) {
  arrays_.barred[row] = kInfinity;
  row_of_[count_] = row;
  sign_[count_] = sign;
  normal_[count_] = rows_[row].normal;
  for (double& number : normal_[count_]) number *= sign;
  multiplier_[count_] = multiplier;
  ++count_;
  factorise(count_ - 1);
}

/// Raises the candidate's multiplier from zero until its row holds, dropping rows that would begin to pull. False when
/// the method should stop.
bool ActiveSet::bringIn(const Candidate& candidate) {
  Vector6 normal = rows_[candidate.row].normal;
  for (double& number : normal) number *= candidate.sign;
  double multiplier = 0.0;
  double value = candidate.value;
  while (steps_++ < kMaxSteps) {
    ActiveVector r{};
    Vector6 z{};
    stepDirection(normal, r, z);
    const double gain = dot(z, normal) + kRegularisation;
    const double full = -value / gain;
    double partial = kInfinity;
    std::size_t leaving = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (rows_[row_of_[i]].equality || r[i] <= 1e-12 || multiplier_[i] / r[i] >= partial) continue;
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
    append(candidate.row, candidate.sign, multiplier);
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
    const SolverRow& row = rows_[row_of_[i]];
    const double value = sign_[i] * (dot(row.normal, d_) + row.slack);
    if (result.status == SolverStatus::kSolved && value < -1e-7) result.status = SolverStatus::kInfeasible;
    result.multiplier[row_of_[i]] = sign_[i] * multiplier_[i];
  }
  result.active_count = count_;
  result.d = d_;
  return result;
}

}  // namespace

SolverResult nearestFeasible(std::span<const SolverRow> rows, const Vector6& d0) noexcept {
  return ActiveSet(rows.first(std::min(rows.size(), kMaxRows)), d0).solve();
}

SolverResult nearestUnentered(std::span<const SolverRow> rows, const Vector6& d0) noexcept {
  rows = rows.first(std::min(rows.size(), kMaxRows));
  const SolverResult middle = nearestFeasible(rows, d0);
  if (middle.status == SolverStatus::kSolved) return middle;
  double deepest = 0.0;
  for (const SolverRow& row : rows) deepest = std::max(deepest, row.equality ? 0.0 : -row.slack);
  std::array<SolverRow, kMaxRows> kept;  // As many as there are rows.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    kept[i] = rows[i];
    if (!rows[i].equality && rows[i].slack < 0.0) kept[i].slack += deepest;
  }
  SolverResult result = nearestFeasible(std::span(kept).first(rows.size()), middle.d);
  // Equalities may still contradict; standing still enters nothing.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (kept[i].equality || dot(kept[i].normal, result.d) + kept[i].slack > -kEntered) continue;
    result.d = {};
    break;
  }
  result.status = middle.status;
  for (std::size_t i = 0; i < rows.size(); ++i) result.multiplier[i] += middle.multiplier[i];
  result.active_count = std::max(result.active_count, middle.active_count);
  return result;
}

}  // namespace hapticell::haptic
