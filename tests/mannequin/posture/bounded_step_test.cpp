// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/bounded_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mannequin/posture/dual_system.h"

namespace hapticell::mannequin {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1.0p-53);
}

/// Rows that a variable of the body can touch: its own limb's and the balance; the root and the spine more.
bool touches(int variable, int row) {
  if (variable < kSpineVariable) return true;
  const bool balance = row == kBalanceRow || row == kBalanceRow + 1;
  if (variable < kArmVariable) return row >= kBalanceRow;
  if (variable < kArmVariable + 9) return balance || (row >= kHandRow && row < kHandRow + 6);
  if (variable < kLegVariable) return balance || row >= kHandRow + 6;
  if (variable < kLegVariable + 6) return balance || row < 6;
  return balance || (row >= 6 && row < kBalanceRow);
}

/// A problem like the solver's whose tasks pull harder than many bounds allow.
StepProblem randomProblem(std::mt19937_64& random, double hand_regularisation) {
  StepProblem problem;
  for (int v = 0; v < kVariables; ++v) {
    const std::size_t i = static_cast<std::size_t>(v);
    for (int r = 0; r < kTaskRows; ++r) {
      if (touches(v, r)) problem.J[i][static_cast<std::size_t>(r)] = uniform(random, -0.6, 0.6);
    }
    problem.D[i] = uniform(random, 0.3, 4.0);
    problem.lower[i] = -uniform(random, 0.0, 0.3);
    problem.upper[i] = uniform(random, 0.0, 0.3);
    if (random() % 8 == 0) problem.lower[i] = 0.0;
    if (random() % 12 == 0) problem.lower[i] = problem.upper[i] = 0.0;
    problem.wish[i] = std::clamp(uniform(random, -0.05, 0.05), problem.lower[i], problem.upper[i]);
  }
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    problem.e[r] = r < kHandRow ? uniform(random, -0.01, 0.01) : uniform(random, -0.4, 0.4);
    problem.R[r] = r < kHandRow ? 1e-4 : hand_regularisation;
    if (r < kBalanceRow) problem.R[r] = 1e-5;
  }
  return problem;
}

/// Half the gradient of the objective, and the size of what it is a difference of.
struct Gradient {
  double value = 0.0, scale = 0.0;
};
Gradient gradientOf(const StepProblem& p, const Variables& step, std::size_t variable) {
  Gradient g{p.D[variable] * (step[variable] - p.wish[variable]), 1.0};
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    double left = -p.e[r];
    for (std::size_t i = 0; i < kVariables; ++i) left += p.J[i][r] * step[i];
    g.value += p.J[variable][r] * left / p.R[r];
    g.scale += std::abs(p.J[variable][r]) * std::max(1e-3, std::abs(left)) / p.R[r];
  }
  return g;
}

/// The conditions of Karush, Kuhn and Tucker: enough for this strictly convex problem.
void expectLeast(const StepProblem& p, const Variables& step) {
  for (std::size_t i = 0; i < kVariables; ++i) {
    EXPECT_GE(step[i], p.lower[i]);
    EXPECT_LE(step[i], p.upper[i]);
    if (p.lower[i] == p.upper[i]) continue;
    const Gradient g = gradientOf(p, step, i);
    const double slack = 1e-6 * g.scale;
    if (step[i] > p.lower[i]) {
      EXPECT_LE(g.value, slack) << "variable " << i;
    }
    if (step[i] < p.upper[i]) {
      EXPECT_GE(g.value, -slack) << "variable " << i;
    }
  }
}

TEST(BoundedStep, IsTheLeastWithinTheBounds) {
  std::mt19937_64 random(5);
  for (int n = 0; n < 300; ++n) {
    const StepProblem problem = randomProblem(random, n % 2 == 0 ? 1e-2 : 1e-3);
    ActiveSet active{};
    Variables step{};
    solveStep(problem, active, step);
    expectLeast(problem, step);
  }
}

TEST(BoundedStep, AGuessThatIsWrongInAFewBoundsLeadsToTheSameStep) {
  std::mt19937_64 random(6);
  for (int n = 0; n < 100; ++n) {
    const StepProblem problem = randomProblem(random, 1e-2);
    ActiveSet cold{};
    Variables from_cold{}, from_guess{};
    solveStep(problem, cold, from_cold);
    ActiveSet guessed = cold;
    for (int k = 0; k < 4; ++k)
      guessed[random() % kVariables] = static_cast<std::int8_t>(static_cast<int>(random() % 3) - 1);
    solveStep(problem, guessed, from_guess);
    for (std::size_t i = 0; i < kVariables; ++i) EXPECT_NEAR(from_cold[i], from_guess[i], 1e-7);
  }
}

TEST(BoundedStep, WhatIsWithinReachIsMetWithoutTouchingABound) {
  std::mt19937_64 random(7);
  StepProblem problem = randomProblem(random, 1e-6);
  Variables known{};
  for (std::size_t i = 0; i < kVariables; ++i) {
    problem.lower[i] = -10.0;
    problem.upper[i] = 10.0;
    problem.wish[i] = 0.0;
    known[i] = uniform(random, -0.1, 0.1);
  }
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    problem.e[r] = 0.0;
    for (std::size_t i = 0; i < kVariables; ++i) problem.e[r] += problem.J[i][r] * known[i];
  }
  ActiveSet active{};
  Variables step{};
  solveStep(problem, active, step);
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    double reached = 0.0;
    for (std::size_t i = 0; i < kVariables; ++i) reached += problem.J[i][r] * step[i];
    EXPECT_NEAR(reached, problem.e[r], 1e-3);
  }
  for (const std::int8_t side : active) EXPECT_EQ(side, 0);
}

/// How far `y` is from solving (J D^-1 J^T + R) y = e - J dq0 over the free variables, relative to the size of the
/// terms. The matrix is positive definite, so that only one y solves it.
double residualOf(const StepProblem& p, const ActiveSet& active, const Rows& y) {
  double worst = 0.0;
  for (std::size_t r = 0; r < kTaskRows; ++r) {
    double sum = p.R[r] * y[r] - p.e[r], size = std::abs(p.R[r] * y[r]) + std::abs(p.e[r]);
    for (std::size_t i = 0; i < kVariables; ++i) {
      double term = 0.0;
      if (active[i] == 0) {
        for (std::size_t c = 0; c < kTaskRows; ++c) term += p.J[i][c] * y[c];
        term = p.wish[i] + term / p.D[i];
      } else {
        term = active[i] < 0 ? p.lower[i] : p.upper[i];
      }
      sum += p.J[i][r] * term;
      size += std::abs(p.J[i][r] * term);
    }
    worst = std::max(worst, std::abs(sum) / std::max(size, 1e-12));
  }
  return worst;
}

TEST(DualSystem, SkipsOnlyRowsThatAVariableCannotTouch) {
  for (int v = 0; v < kVariables; ++v) {
    const RowRanges rows = rowsOf(v, false), coupled = rowsOf(v, true);
    for (int r = 0; r < kTaskRows; ++r) {
      const auto has = [r](const RowRanges& of) {
        return (r >= of.begin_a && r < of.end_a) || (r >= of.begin_b && r < of.end_b);
      };
      const bool of_left_arm = v >= kArmVariable && v < kArmVariable + 9;
      EXPECT_EQ(has(rows), touches(v, r)) << v << " " << r;
      EXPECT_EQ(has(coupled), touches(v, r) || (of_left_arm && r >= kHandRow + 6)) << v << " " << r;
    }
  }
}

TEST(DualSystem, SolvesItsEquationsAfterAnyChangesOfSides) {
  std::mt19937_64 random(8);
  for (int n = 0; n < 40; ++n) {
    StepProblem problem = randomProblem(random, 1e-3);
    problem.arms_coupled = n % 2 == 1;
    if (problem.arms_coupled) {
      for (std::size_t v = kArmVariable; v < kArmVariable + 9; ++v)
        for (std::size_t r = kHandRow + 6; r < kTaskRows; ++r) problem.J[v][r] = uniform(random, -0.6, 0.6);
    }
    ActiveSet active{};
    DualSystem system(problem, active);
    EXPECT_LT(residualOf(problem, active, system.solve()), 1e-9);
    // Few changes are updates of the factors, many factorise afresh.
    for (const int changes : {0, 1, 3, kMostUpdates, 1, 40, 2, 5}) {
      const ActiveSet before = active;
      for (int k = 0; k < changes; ++k)
        active[random() % kVariables] = static_cast<std::int8_t>(static_cast<int>(random() % 3) - 1);
      EXPECT_EQ(system.takeOver(active), active == before);
      EXPECT_LT(residualOf(problem, active, system.solve()), 1e-8) << changes << " changes";
    }
  }
}

}  // namespace
}  // namespace hapticell::mannequin
