// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mannequin/posture/bounded_step.h"

namespace hapticell::mannequin {

using Rows = std::array<double, kTaskRows>;

/// Rows that a variable's column can touch: two ranges, so that the zeros are not multiplied.
struct RowRanges {
  int begin_a, end_a, begin_b, end_b;
};
inline RowRanges rowsOf(int variable, bool arms_coupled) {
  if (variable < kSpineVariable) return {0, kTaskRows, kTaskRows, kTaskRows};
  if (variable < kArmVariable) return {kBalanceRow, kTaskRows, kTaskRows, kTaskRows};
  if (variable < kArmVariable + 9) return {kBalanceRow, arms_coupled ? kTaskRows : kHandRow + 6, kTaskRows, kTaskRows};
  if (variable < kLegVariable) return {kBalanceRow, kHandRow, kHandRow + 6, kTaskRows};
  if (variable < kLegVariable + 6) return {kFootRow, 6, kBalanceRow, kHandRow};
  return {6, kHandRow, kTaskRows, kTaskRows};
}

/// Changes of side beyond which factorising afresh is cheaper: about half the 26 rows. Half, twice: the same steps,
/// slower.
inline constexpr int kMostUpdates = 14;

/// The system (J D^-1 J^T + R) y = e - J dq0 over the free variables, kept factorised while variables enter or leave
/// bounds: each change is a rank-one update (Gill, Golub, Murray and Saunders, Math. Comp. 28, 1974, method C1).
class DualSystem {
 public:
  DualSystem(const StepProblem& problem, const ActiveSet& active) : p_(problem), known_(active) { build(); }

  /// Switches to another active set; true if it was the same.
  bool takeOver(const ActiveSet& active) {
    int changes = 0;
    for (std::size_t i = 0; i < kVariables; ++i) changes += active[i] != known_[i] ? 1 : 0;
    if (changes > kMostUpdates) {
      known_ = active;
      build();
    } else if (changes > 0) {
      for (int v = 0; v < kVariables; ++v) {
        const std::size_t i = static_cast<std::size_t>(v);
        if (active[i] != known_[i]) change(v, active[i]);
      }
    }
    return changes == 0;
  }

  Rows solve() const {
    Rows y;
    for (int i = 0; i < kTaskRows; ++i) y[i] = e_[i];
    for (int j = 0; j < kTaskRows; ++j) {
      for (int i = j + 1; i < kTaskRows; ++i) y[i] -= U_[j][i] * y[j];
    }
    for (int j = kTaskRows - 1; j >= 0; --j) {
      double sum = y[j] / U_[j][j];
      for (int i = j + 1; i < kTaskRows; ++i) sum -= U_[j][i] * y[i];
      y[j] = sum;
    }
    return y;
  }

 private:
  double startOf(std::size_t i) const {
    if (known_[i] == 0) return p_.wish[i];
    return known_[i] < 0 ? p_.lower[i] : p_.upper[i];
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

  /// A = U^T D U with a unit diagonal in U; D is on the diagonal.
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

  const StepProblem& p_;
  ActiveSet known_;
  double U_[kTaskRows][kTaskRows];
  double e_[kTaskRows];
};

}  // namespace hapticell::mannequin
