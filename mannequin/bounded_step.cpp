// SPDX-License-Identifier: Apache-2.0
#include "mannequin/bounded_step.h"

#include <algorithm>
#include <cmath>

namespace hapticell::mannequin {

namespace {

constexpr int kMostPasses = 24;
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

/// The system (J D^-1 J^T + R) y = e - J dq0 over the free variables, kept factorised while variables change sides: a
/// change costs a rank-one update (Gill, Golub, Murray and Saunders, Math. Comp. 28, 1974, method C1).
class DualSolver {
 public:
  DualSolver(const StepProblem& problem, const ActiveSet& active) : p_(problem), known_(active) { build(); }

  void pass(const ActiveSet& active, Variables& step) {
    for (int v = 0; v < kVariables; ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      if (active[i] != known_[i]) change(v, active[i]);
    }
    substitute();
    for (int v = 0; v < kVariables; ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      step[i] = startOf(i);
      if (known_[i] == 0) step[i] += pull(v) / p_.D[i];
    }
  }

  /// J^T y of one variable: the tasks' pull on it.
  double pull(int variable) const {
    const double* column = p_.J[static_cast<std::size_t>(variable)].data();
    const RowRanges rows = rowsOf(variable, p_.arms_coupled);
    double sum = 0.0;
    for (int r = rows.begin_a; r < rows.end_a; ++r) sum += column[r] * y_[r];
    for (int r = rows.begin_b; r < rows.end_b; ++r) sum += column[r] * y_[r];
    return sum;
  }

 private:
  double startOf(std::size_t i) const {
    return known_[i] == 0 ? p_.wish[i] : known_[i] < 0 ? p_.lower[i] : p_.upper[i];
  }

  void build() {
    for (int r = 0; r < kTaskRows; ++r) {
      for (int c = r; c < kTaskRows; ++c) U_[r][c] = 0.0;
      U_[r][r] = p_.R[static_cast<std::size_t>(r)];
      e_[r] = p_.e[static_cast<std::size_t>(r)];
    }
    for (int v = 0; v < kVariables; ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      takeOff(v, startOf(i));
      if (known_[i] == 0) addOuterProduct(p_.J[i].data(), 1.0 / p_.D[i], rowsOf(v, p_.arms_coupled));
    }
    factorise();
  }

  void takeOff(int variable, double value) {
    if (value == 0.0) return;
    const double* column = p_.J[static_cast<std::size_t>(variable)].data();
    const RowRanges rows = rowsOf(variable, p_.arms_coupled);
    for (int r = rows.begin_a; r < rows.end_a; ++r) e_[r] -= column[r] * value;
    for (int r = rows.begin_b; r < rows.end_b; ++r) e_[r] -= column[r] * value;
  }

  void addOuterProduct(const double* column, double weight, const RowRanges& rows) {
    for (int r = rows.begin_a; r < rows.end_a; ++r) {
      const double scaled = weight * column[r];
      for (int c = r; c < rows.end_a; ++c) U_[r][c] += scaled * column[c];
      for (int c = rows.begin_b; c < rows.end_b; ++c) U_[r][c] += scaled * column[c];
    }
    for (int r = rows.begin_b; r < rows.end_b; ++r) {
      const double scaled = weight * column[r];
      for (int c = r; c < rows.end_b; ++c) U_[r][c] += scaled * column[c];
    }
  }

  /// A = U^T D U with a unit diagonal in U; D stands on the diagonal.
  void factorise() {
    for (int j = 0; j < kTaskRows; ++j) {
      U_[j][j] = std::max(U_[j][j], 1e-14);
      const double inverse = 1.0 / U_[j][j];
      for (int k = j + 1; k < kTaskRows; ++k) {
        const double share = U_[j][k] * inverse;
        if (share == 0.0) continue;
        for (int i = k; i < kTaskRows; ++i) U_[k][i] -= share * U_[j][i];
      }
      for (int k = j + 1; k < kTaskRows; ++k) U_[j][k] *= inverse;
    }
  }

  void change(int variable, std::int8_t now) {
    const std::size_t i = static_cast<std::size_t>(variable);
    const double before = startOf(i);
    const bool was_free = known_[i] == 0;
    known_[i] = now;
    takeOff(variable, startOf(i) - before);
    if (was_free == (now == 0)) return;
    const RowRanges rows = rowsOf(variable, p_.arms_coupled);
    double w[kTaskRows] = {};
    for (int r = rows.begin_a; r < rows.end_a; ++r) w[r] = p_.J[i][static_cast<std::size_t>(r)];
    for (int r = rows.begin_b; r < rows.end_b; ++r) w[r] = p_.J[i][static_cast<std::size_t>(r)];
    update(w, (now == 0 ? 1.0 : -1.0) / p_.D[i], rows.begin_a);
  }

  void update(double* w, double sigma, int first) {
    for (int j = first; j < kTaskRows; ++j) {
      const double p = w[j], d = U_[j][j];
      if (p == 0.0) continue;
      const double grown = std::max(d + sigma * p * p, 1e-14);
      const double beta = p * sigma / grown;
      sigma *= d / grown;
      U_[j][j] = grown;
      for (int r = j + 1; r < kTaskRows; ++r) {
        w[r] -= p * U_[j][r];
        U_[j][r] += beta * w[r];
      }
    }
  }

  void substitute() {
    for (int i = 0; i < kTaskRows; ++i) y_[i] = e_[i];
    for (int j = 0; j < kTaskRows; ++j) {
      for (int i = j + 1; i < kTaskRows; ++i) y_[i] -= U_[j][i] * y_[j];
    }
    for (int j = kTaskRows - 1; j >= 0; --j) {
      double sum = y_[j] / U_[j][j];
      for (int i = j + 1; i < kTaskRows; ++i) sum -= U_[j][i] * y_[i];
      y_[j] = sum;
    }
  }

  const StepProblem& p_;
  ActiveSet known_;
  double U_[kTaskRows][kTaskRows];
  double e_[kTaskRows];
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

/// Frees the fixed variable that most wants to come back inside; false when none does by more than a trifle.
bool releaseWorst(const StepProblem& problem, const DualSolver& solver, const Variables& step, ActiveSet& active) {
  int worst = -1;
  double most = 1e-3;
  for (int v = 0; v < kVariables; ++v) {
    const std::size_t i = static_cast<std::size_t>(v);
    if (active[i] == 0 || problem.lower[i] == problem.upper[i]) continue;
    const double multiplier = problem.D[i] * (step[i] - problem.wish[i]) - solver.pull(v);
    const double wrong = active[i] < 0 ? -multiplier : multiplier;
    if (wrong <= most) continue;
    most = wrong;
    worst = v;
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
    solver.pass(active, step);
    if (fixViolators(problem, step, active)) continue;
    if (!releaseWorst(problem, solver, step, active)) break;
  }
  for (std::size_t i = 0; i < kVariables; ++i) step[i] = std::clamp(step[i], problem.lower[i], problem.upper[i]);
}

}  // namespace hapticell::mannequin
