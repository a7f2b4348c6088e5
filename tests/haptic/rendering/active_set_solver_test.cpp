// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/active_set_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace hapticell::haptic {
namespace {

using Vec = Eigen::Matrix<double, 6, 1>;

Vec toEigen(const Vector6& v) {
  return Eigen::Map<const Vec>(v.data());
}

Vector6 unit(std::array<double, 6> v) {
  double sum = 0.0;
  for (const double number : v) sum += number * number;
  for (double& number : v) number /= std::sqrt(sum);
  return v;
}

double worstViolation(const std::vector<SolverRow>& rows, const Vector6& d) {
  double worst = 0.0;
  for (const SolverRow& row : rows) {
    const double value = toEigen(row.normal).dot(toEigen(d)) + row.slack;
    worst = std::max(worst, row.equality ? std::abs(value) : -value);
  }
  return worst;
}

/// The second method: projects d0 on the flat of every subset of at most six rows and keeps the nearest that is
/// feasible.
std::optional<Vec> bruteForce(const std::vector<SolverRow>& rows, const Vec& d0) {
  std::optional<Vec> best;
  const std::size_t n = rows.size();
  for (std::uint32_t subset = 0; subset < (1u << n); ++subset) {
    if (std::popcount(subset) > 6) continue;
    Eigen::MatrixXd N(6, std::popcount(subset));
    Eigen::VectorXd b(std::popcount(subset));
    for (std::size_t i = 0, k = 0; i < n; ++i) {
      if ((subset >> i & 1u) == 0) continue;
      N.col(static_cast<Eigen::Index>(k)) = toEigen(rows[i].normal);
      b[static_cast<Eigen::Index>(k++)] = -rows[i].slack;
    }
    Vec d = d0;
    if (N.cols() > 0) d += N * (N.transpose() * N).completeOrthogonalDecomposition().solve(b - N.transpose() * d0);
    Vector6 as_array{};
    Vec::Map(as_array.data()) = d;
    if (worstViolation(rows, as_array) > 1e-9) continue;
    if (!best || (d - d0).norm() < (*best - d0).norm()) best = d;
  }
  return best;
}

/// Optimality by Karush, Kuhn and Tucker: feasible, d - d0 a combination of normals, no row pulls, only tight rows
/// press.
void expectOptimal(const std::vector<SolverRow>& rows, const Vector6& d0, const SolverResult& result) {
  // The regularisation lets a pressing row give by 1e-7 of its multiplier.
  const double hardest = *std::max_element(result.multiplier.begin(), result.multiplier.end());
  EXPECT_LE(worstViolation(rows, result.d), 2e-9 + 1.01e-7 * hardest);
  Vec combination = Vec::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    combination += result.multiplier[i] * toEigen(rows[i].normal);
    if (!rows[i].equality) {
      EXPECT_GE(result.multiplier[i], -1e-9);
    }
    if (result.multiplier[i] == 0.0) continue;
    EXPECT_NEAR(toEigen(rows[i].normal).dot(toEigen(result.d)) + rows[i].slack, 0.0,
                1e-9 + 1.01e-7 * std::abs(result.multiplier[i]));
  }
  EXPECT_LT((combination - (toEigen(result.d) - toEigen(d0))).norm(), 1e-9);
}

class Random {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector6 direction() {
    std::normal_distribution<double> normal;
    return unit({normal(engine_), normal(engine_), normal(engine_), normal(engine_), normal(engine_), normal(engine_)});
  }
  Vector6 motion(double size) {
    Vector6 v = direction();
    for (double& number : v) number *= size;
    return v;
  }

 private:
  std::mt19937_64 engine_{42};
};

TEST(ActiveSetSolver, KeepsAFreeMotionAsItIs) {
  const Vector6 d0{1e-3, 2e-3, 0, 0, 0, 1e-4};
  const SolverRow far{unit({1, 0, 0, 0, 0, 0}), 0.01, false};
  const SolverResult result = nearestFeasible(std::span(&far, 1), d0);
  EXPECT_EQ(result.status, SolverStatus::kSolved);
  EXPECT_EQ(result.d, d0);
  EXPECT_EQ(result.active_count, 0u);
  EXPECT_EQ(nearestFeasible(std::span<const SolverRow>(), d0).d, d0);
}

TEST(ActiveSetSolver, AgreesWithTheEnumerationOfAllActiveSets) {
  Random random;
  int active_total = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<SolverRow> rows(3 + static_cast<std::size_t>(trial % 8));
    for (SolverRow& row : rows) row = {random.direction(), random.uniform(0.0, 2e-3), false};
    if (trial % 3 == 0) rows[0].equality = true;
    if (trial % 5 == 0) rows[1] = rows[0];
    const Vector6 d0 = random.motion(5e-3);
    const auto best = bruteForce(rows, toEigen(d0));
    ASSERT_TRUE(best.has_value()) << trial;
    const SolverResult result = nearestFeasible(rows, d0);
    EXPECT_EQ(result.status, SolverStatus::kSolved) << trial;
    EXPECT_LT((toEigen(result.d) - *best).norm(), 1e-7) << trial;
    expectOptimal(rows, d0, result);
    active_total += static_cast<int>(result.active_count);
  }
  EXPECT_GT(active_total, 400);
}

TEST(ActiveSetSolver, IsOptimalWithSixtyFourRandomRows) {
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<SolverRow> rows(64);
    for (SolverRow& row : rows) row = {random.direction(), random.uniform(0.0, 2e-3), false};
    const Vector6 d0 = random.motion(5e-3);
    const SolverResult result = nearestFeasible(rows, d0);
    EXPECT_EQ(result.status, SolverStatus::kSolved) << trial;
    expectOptimal(rows, d0, result);
  }
}

std::vector<SolverRow> boreTangents(int count, double clearance) {
  std::vector<SolverRow> rows;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    rows.push_back({{-std::cos(angle), -std::sin(angle), 0, 0, 0, 0}, clearance, false});
  }
  return rows;
}

TEST(ActiveSetSolver, FindsThePolygonOfABoresTangents) {
  const double clearance = 1e-3;
  const auto rows = boreTangents(64, clearance);
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.0628 * i;
    const Vector6 d0{5e-3 * std::cos(angle), 5e-3 * std::sin(angle), 1e-3, 0, 0, 0};
    const SolverResult result = nearestFeasible(rows, d0);
    expectOptimal(rows, d0, result);
    const double radius = std::hypot(result.d[0], result.d[1]);
    EXPECT_GE(radius, clearance - 1e-8);
    EXPECT_LE(radius, clearance / std::cos(std::numbers::pi / 64) + 1e-8);
    EXPECT_DOUBLE_EQ(result.d[2], 1e-3);
  }
}

TEST(ActiveSetSolver, TakesDuplicateRowsForOne) {
  std::vector<SolverRow> rows(64, SolverRow{unit({0, 0, 1, 0, 0, 0}), 1e-4, false});
  const SolverResult result = nearestFeasible(rows, {1e-3, 0, -3e-3, 0, 0, 0});
  EXPECT_EQ(result.status, SolverStatus::kSolved);
  EXPECT_EQ(result.active_count, 1u);
  EXPECT_NEAR(result.d[2], -1e-4, 1e-9);
  EXPECT_DOUBLE_EQ(result.d[0], 1e-3);
}

TEST(ActiveSetSolver, SolvesFacetsWithinADegree) {
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<SolverRow> rows(64);
    for (SolverRow& row : rows) {
      row = {unit({random.uniform(-0.017, 0.017), random.uniform(-0.017, 0.017), 1, 0, 0, 0}),
             random.uniform(0.0, 1e-4), false};
    }
    const Vector6 d0 = random.motion(5e-3);
    const SolverResult result = nearestFeasible(rows, d0);
    EXPECT_EQ(result.status, SolverStatus::kSolved);
    expectOptimal(rows, d0, result);
  }
}

TEST(ActiveSetSolver, StaysInAnAcuteCorner) {
  // Two walls four degrees apart: their corner is far along the bisector, where the motion pushes.
  const double half = 2.0 * std::numbers::pi / 180.0;
  const std::vector<SolverRow> rows{{unit({-std::sin(half), std::cos(half), 0, 0, 0, 0}), 1e-4, false},
                                    {unit({-std::sin(half), -std::cos(half), 0, 0, 0, 0}), 1e-4, false}};
  const Vector6 d0{1e-2, 1e-3, 0, 0, 0, 0};
  const SolverResult result = nearestFeasible(rows, d0);
  expectOptimal(rows, d0, result);
  EXPECT_NEAR(result.d[0], 1e-4 / std::sin(half), 1e-6);
  EXPECT_NEAR(result.d[1], 0.0, 1e-6);
}

TEST(ActiveSetSolver, AnswersAnInfeasibleSlotWithItsMiddle) {
  const std::vector<SolverRow> rows{{unit({0, 0, 1, 0, 0, 0}), -1e-3, false},      // z >= 1 mm
                                    {unit({0, 0, -1, 0, 0, 0}), -0.5e-3, false}};  // z <= -0.5 mm
  const SolverResult result = nearestFeasible(rows, {2e-3, 0, -3e-3, 0, 0, 0});
  EXPECT_EQ(result.status, SolverStatus::kInfeasible);
  EXPECT_NEAR(result.d[2], 0.25e-3, 1e-6);
  EXPECT_NEAR(result.d[0], 2e-3, 1e-9);
}

RowArrays arraysOfRows(const std::vector<SolverRow>& rows) {
  RowArrays arrays;
  for (const SolverRow& row : rows) arrays.add(row);
  arrays.fillLastVector();
  return arrays;
}

TEST(ActiveSetSolver, AnswersTheSameWhateverItBeginsWith) {
  Random random;
  int solved = 0, held = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<SolverRow> rows(1 + static_cast<std::size_t>(trial % 60));
    for (SolverRow& row : rows) row = {random.direction(), random.uniform(trial % 4 == 0 ? -5e-4 : 0.0, 2e-3), false};
    if (trial % 5 == 0) rows[0].equality = true;
    if (trial % 7 == 0) rows.back() = rows.front();
    const Vector6 before = random.motion(5e-3);
    ActiveRows first = nearestFeasible(rows, before).active;
    if (trial % 3 == 0) {
      // Whatever rows, also one twice and one that is not there.
      first.count = ActiveRows::kMost;
      for (auto& row : first.row) row = static_cast<std::uint8_t>(random.uniform(0.0, 65.9));
    }
    Vector6 d0 = before;
    for (double& number : d0) number += random.uniform(-2e-4, 2e-4);
    for (SolverRow& row : rows) row.slack += random.uniform(-1e-4, 1e-4);
    const SolverResult cold = nearestFeasible(rows, d0), warm = nearestFeasible(arraysOfRows(rows), d0, first);
    ASSERT_EQ(warm.status, cold.status) << trial;
    if (cold.status != SolverStatus::kSolved) {
      EXPECT_EQ(warm.d, cold.d) << trial;
      EXPECT_EQ(warm.active.count, 0u);
      continue;
    }
    ++solved;
    held += static_cast<int>(warm.active.count);
    EXPECT_LT((toEigen(warm.d) - toEigen(cold.d)).norm(), 1e-7) << trial;
    expectOptimal(rows, d0, warm);
  }
  EXPECT_GT(solved, 2000);
  EXPECT_GT(held, 4000);
}

TEST(ActiveSetSolver, GivesUpEarlyOnManyContradictions) {
  Random random;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<SolverRow> rows(kMaxRows);
    for (SolverRow& row : rows) row = {random.direction(), random.uniform(-1e-3, -1e-4), false};
    const Vector6 d0 = random.motion(5e-3);
    const SolverResult result = nearestFeasible(rows, d0);
    EXPECT_NE(result.status, SolverStatus::kSolved);
    for (const double number : result.d) EXPECT_TRUE(std::isfinite(number));
    EXPECT_LT(toEigen(result.d).norm(), 0.2) << "a contradiction must not throw the proxy away";
  }
}

TEST(ActiveSetSolver, EntersNothingWhereRowsContradictEachOther) {
  Random random;
  int contradictions = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    // The proxy is inside some rows already; others, one of them opposite, still hold.
    std::vector<SolverRow> rows(2 + static_cast<std::size_t>(trial % 30));
    for (SolverRow& row : rows) {
      const double slack = random.uniform(-1e-4, 1e-3);
      row = {random.direction(), trial % 3 == 0 ? slack : std::max(slack, 0.0), false};
    }
    rows[0].slack = -random.uniform(1e-4, 5e-4);
    rows[1] = {rows[0].normal, random.uniform(0.0, 5e-5), false};
    for (double& number : rows[1].normal) number = -number;
    const Vector6 d0 = random.motion(5e-3);
    contradictions += nearestFeasible(rows, d0).status != SolverStatus::kSolved ? 1 : 0;
    const SolverResult result = nearestUnentered(rows, d0);
    double deepest = 0.0;
    for (const SolverRow& row : rows) deepest = std::max(deepest, -row.slack);
    for (const SolverRow& row : rows) {
      const double after = toEigen(row.normal).dot(toEigen(result.d)) + row.slack;
      EXPECT_GE(after, (row.slack < 0.0 ? -deepest : 0.0) - 1.1e-6) << trial;
    }
    for (const double number : result.d) ASSERT_TRUE(std::isfinite(number));
  }
  EXPECT_EQ(contradictions, 2000);
}

TEST(ActiveSetSolver, AnswersLikeTheNearestFeasibleWhereThereIsOne) {
  Random random;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<SolverRow> rows(20);
    for (SolverRow& row : rows) row = {random.direction(), random.uniform(0.0, 2e-3), false};
    const Vector6 d0 = random.motion(5e-3);
    EXPECT_EQ(nearestUnentered(rows, d0).d, nearestFeasible(rows, d0).d);
  }
  const std::vector<SolverRow> slot{{unit({0, 0, 1, 0, 0, 0}), -1e-3, false},
                                    {unit({0, 0, -1, 0, 0, 0}), -0.5e-3, false}};
  EXPECT_NEAR(nearestUnentered(slot, {2e-3, 0, -3e-3, 0, 0, 0}).d[2], 0.25e-3, 1e-6) << "entered from both sides";
}

TEST(ActiveSetSolver, MeetsEqualitiesFromBothSides) {
  const std::vector<SolverRow> rows{{unit({1, 1, 0, 0, 0, 0}), 1e-4, true}, {unit({0, 0, 1, 0, 0, 0}), 1e-4, false}};
  for (const double side : {-5e-3, 5e-3}) {
    const Vector6 d0{side, side, -1e-3, 0, 0, 1e-3};
    const SolverResult result = nearestFeasible(rows, d0);
    EXPECT_EQ(result.status, SolverStatus::kSolved);
    expectOptimal(rows, d0, result);
  }
}

TEST(ActiveSetSolver, IgnoresRowsBeyondItsCapacity) {
  std::vector<SolverRow> rows(kMaxRows + 5, SolverRow{unit({0, 0, 1, 0, 0, 0}), 1.0, false});
  rows.back().slack = -1.0;
  EXPECT_EQ(nearestFeasible(rows, {}).active_count, 0u);
}

}  // namespace
}  // namespace hapticell::haptic
