// SPDX-License-Identifier: Apache-2.0
#include "mannequin/bounded_step.h"

#include <algorithm>
#include <cmath>

namespace hapticell::mannequin {

namespace {

constexpr int kMostPasses = 16;
constexpr double kSlack = 1e-12;

/// Rows that a variable's column can touch: two ranges, so that the zeros are not multiplied.
struct RowRanges {
  int begin_a, end_a, begin_b, end_b;
};
RowRanges rowsOf(int variable, bool arms_coupled) {
  if (variable < kSpineVariable) return {0, kTaskRows, kTaskRows, kTaskRows};
  if (variable < kArmVariable) return {kBalanceRow, kTaskRows, kTaskRows, kTaskRows};
  if (variable < kArmVariable + 9) return {kBalanceRow, arms_coupled ? kTaskRows : kHandRow + 6, kTaskRows, kTaskRows};
  if (variable < kLegVariable) return {kBalanceRow, kHandRow, kHandRow + 6, kTaskRows};
  if (variable < kLegVariable + 6) return {kFootRow, 6, kBalanceRow, kHandRow};
  return {6, kHandRow, kTaskRows, kTaskRows};
}

class DualSolver {
 public:
  DualSolver(const StepProblem& problem, const ActiveSet& active) : p_(problem), active_(active) {}

  void pass(Variables& step) {
    build(step);
    factorise();
    substitute();
    for (int v = 0; v < kVariables; ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      if (active_[i] == 0) step[i] = p_.wish[i] + pull(v) / p_.D[i];
    }
  }

  /// J^T y of one variable: the tasks' pull on it.
  double pull(int variable) const {
    const auto& column = p_.J[static_cast<std::size_t>(variable)];
    const RowRanges rows = rowsOf(variable, p_.arms_coupled);
    double sum = 0.0;
    for (int r = rows.begin_a; r < rows.end_a; ++r) sum += column[static_cast<std::size_t>(r)] * y_[r];
    for (int r = rows.begin_b; r < rows.end_b; ++r) sum += column[static_cast<std::size_t>(r)] * y_[r];
    return sum;
  }

 private:
  void build(Variables& step) {
    for (int r = 0; r < kTaskRows; ++r) {
      for (int c = 0; c <= r; ++c) A_[r][c] = 0.0;
      A_[r][r] = p_.R[static_cast<std::size_t>(r)];
      y_[r] = p_.e[static_cast<std::size_t>(r)];
    }
    for (int v = 0; v < kVariables; ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      const RowRanges rows = rowsOf(v, p_.arms_coupled);
      const double* column = p_.J[i].data();
      const double start = active_[i] == 0 ? p_.wish[i] : active_[i] < 0 ? p_.lower[i] : p_.upper[i];
      step[i] = start;
      if (start != 0.0) {
        for (int r = rows.begin_a; r < rows.end_a; ++r) y_[r] -= column[r] * start;
        for (int r = rows.begin_b; r < rows.end_b; ++r) y_[r] -= column[r] * start;
      }
      if (active_[i] == 0) addOuterProduct(column, 1.0 / p_.D[i], rows);
    }
  }

  void addOuterProduct(const double* column, double weight, const RowRanges& rows) {
    for (int r = rows.begin_a; r < rows.end_a; ++r) {
      const double scaled = weight * column[r];
      for (int c = rows.begin_a; c <= r; ++c) A_[r][c] += scaled * column[c];
    }
    for (int r = rows.begin_b; r < rows.end_b; ++r) {
      const double scaled = weight * column[r];
      for (int c = rows.begin_a; c < rows.end_a; ++c) A_[r][c] += scaled * column[c];
      for (int c = rows.begin_b; c <= r; ++c) A_[r][c] += scaled * column[c];
    }
  }

  /// A = L D L^T in place, rows of L below the diagonal.
  void factorise() {
    double scaled[kTaskRows];
    for (int j = 0; j < kTaskRows; ++j) {
      double d = A_[j][j];
      for (int k = 0; k < j; ++k) {
        scaled[k] = A_[j][k] * A_[k][k];
        d -= A_[j][k] * scaled[k];
      }
      A_[j][j] = std::max(d, 1e-14);
      const double inverse = 1.0 / A_[j][j];
      for (int i = j + 1; i < kTaskRows; ++i) {
        double sum = A_[i][j];
        for (int k = 0; k < j; ++k) sum -= A_[i][k] * scaled[k];
        A_[i][j] = sum * inverse;
      }
    }
  }

  void substitute() {
    for (int i = 0; i < kTaskRows; ++i) {
      for (int k = 0; k < i; ++k) y_[i] -= A_[i][k] * y_[k];
    }
    for (int i = 0; i < kTaskRows; ++i) y_[i] /= A_[i][i];
    for (int i = kTaskRows - 1; i >= 0; --i) {
      for (int k = i + 1; k < kTaskRows; ++k) y_[i] -= A_[k][i] * y_[k];
    }
  }

  const StepProblem& p_;
  const ActiveSet& active_;
  double A_[kTaskRows][kTaskRows];
  double y_[kTaskRows];
};

/// Fixes every free variable that left its bounds; true when there was one.
bool fixViolators(const StepProblem& problem, const Variables& step, ActiveSet& active) {
  bool any = false;
  for (std::size_t i = 0; i < kVariables; ++i) {
    if (active[i] != 0) continue;
    if (step[i] < problem.lower[i] - kSlack) active[i] = -1;
    if (step[i] > problem.upper[i] + kSlack) active[i] = 1;
    any = any || active[i] != 0;
  }
  return any;
}

/// Frees the fixed variable that most wants to come back inside; false when none does.
bool releaseWorst(const StepProblem& problem, const DualSolver& solver, const Variables& step, ActiveSet& active) {
  int worst = -1;
  double most = 1e-10;
  for (int v = 0; v < kVariables; ++v) {
    const std::size_t i = static_cast<std::size_t>(v);
    if (active[i] == 0 || problem.lower[i] == problem.upper[i]) continue;
    const double multiplier = problem.D[i] * (step[i] - problem.wish[i]) - solver.pull(v);
    const double wrong = active[i] < 0 ? -multiplier : multiplier;
    if (wrong > most) {
      most = wrong;
      worst = v;
    }
  }
  if (worst < 0) return false;
  active[static_cast<std::size_t>(worst)] = 0;
  return true;
}

}  // namespace

void solveStep(const StepProblem& problem, ActiveSet& active, Variables& step) {
  for (std::size_t i = 0; i < kVariables; ++i) {
    if (problem.lower[i] == problem.upper[i]) active[i] = 1;
  }
  DualSolver solver(problem, active);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    solver.pass(step);
    if (fixViolators(problem, step, active)) continue;
    if (!releaseWorst(problem, solver, step, active)) break;
  }
  for (std::size_t i = 0; i < kVariables; ++i) step[i] = std::clamp(step[i], problem.lower[i], problem.upper[i]);
}

}  // namespace hapticell::mannequin
