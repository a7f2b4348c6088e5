// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/bounded_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

}  // namespace
}  // namespace hapticell::mannequin
