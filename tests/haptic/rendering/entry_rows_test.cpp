// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/entry_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "haptic/rendering/entry_rows_body.h"
#include "haptic/rendering/proxy_metric.h"
#include "haptic/rendering/violated_rows.h"
#include "haptic/rendering/violated_rows_body.h"

namespace hapticell::haptic {
namespace {

class Entries {
 public:
  explicit Entries(unsigned seed) : random_(seed) {
    set.count = 1 + seed % kMaxConstraints;
    for (std::size_t i = 0; i < set.count; ++i) {
      Constraint& c = set.constraints[i];
      c.gap = 0.01 * unit();
      for (double& x : c.gradient) x = i % 13 == 12 ? 0.0 : unit();
      for (double& x : c.curvature) x = i % 3 == 0 ? 0.0 : 20.0 * unit();
      if (i % 13 == 12) c.curvature = {};
      c.has_trim = i % 4 == 1;
      c.trim_gap = 0.01 * unit();
      for (double& x : c.trim_gradient) x = i % 8 == 5 ? 0.0 : unit();
      c.velocity_D = 0.1 * dvec3(unit(), unit(), unit());
      if (i % 7 == 3) c.kind = ConstraintKind::kEquality;
    }
    for (std::size_t i = 0; i < 6; ++i) xi[i] = (i < 3 ? 0.05 : 0.5) * unit();
  }
  void dropTrims() {
    for (Constraint& c : set.constraints) c.has_trim = false;
  }
  double unit() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  ConstraintSet set;
  Vector6 xi{};
  double age = 0.02;

 private:
  std::mt19937 random_;
};

/// One gradient in the metric, by vectors.
Vector6 inMetric(const Vector6& gradient, const dvec3& theta) {
  const dvec3 g = angularPart(gradient);
  const dvec3 once = glm::cross(theta, g);
  return joined(linearPart(gradient), (g + 0.5 * once + glm::cross(theta, once) / 12.0) / kRotationLever);
}

TEST(EntryRows, AreThoseOfEachEntryForItself) {
  const auto arrays = std::make_unique<EntryArrays>();
  const auto rows = std::make_unique<EntryRows>();
  int trimmed = 0, flat = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Entries entries(seed);
    if (seed % 4 == 0) entries.dropTrims();
    arrays->take(entries.set);
    EXPECT_EQ(arrays->any_trim, seed % 4 != 0);
    makeRows(*arrays, entries.xi, entries.age, *rows);
    for (std::size_t i = 0; i < entries.set.count; ++i) {
      const Constraint& c = entries.set.constraints[i];
      Vector6 xi = entries.xi;
      for (std::size_t k = 0; k < 3; ++k) xi[k] -= entries.age * c.velocity_D[static_cast<int>(k)];
      Vector6 gradient{};
      double value = evaluateWithGradient(c, xi, gradient);
      gradient = inMetric(gradient, angularPart(xi));
      double length = lengthOf(gradient);
      ASSERT_NEAR(rows->length[i], length, 1e-12 * length);
      if (length < kLeastSlope) {
        ++flat;
        continue;
      }
      double trim = c.trim_gap;
      for (std::size_t k = 0; k < 6; ++k) trim += c.trim_gradient[k] * xi[k];
      const Vector6 trim_gradient = inMetric(c.trim_gradient, angularPart(xi));
      const double trim_length = lengthOf(trim_gradient);
      const bool can_trim = c.has_trim && c.kind != ConstraintKind::kEquality && trim_length > kLeastSlope;
      if (can_trim && trim / trim_length < value / length) {
        ++trimmed;
        gradient = trim_gradient;
        length = trim_length;
        value = trim;
      }
      ASSERT_NEAR(rows->slack[i], value / length, 1e-12);
      for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(rows->normal[k][i], gradient[k] / length, 1e-12) << i << " " << k;
    }
  }
  EXPECT_GT(trimmed, 100);
  EXPECT_GT(flat, 100);
}

TEST(EntryRows, AreTheSameToTheLastBitWithoutWideInstructions) {
  const auto arrays = std::make_unique<EntryArrays>();
  const auto wide = std::make_unique<EntryRows>(), plain = std::make_unique<EntryRows>();
  for (unsigned seed = 0; seed < 200; ++seed) {
    Entries entries(seed);
    if (seed % 4 == 0) entries.dropTrims();
    arrays->take(entries.set);
    makeRows(*arrays, entries.xi, entries.age, *wide);
    makeRowsPortably(*arrays, entries.xi, entries.age, *plain);
    for (std::size_t i = 0; i < entries.set.count; ++i) {
      ASSERT_EQ(wide->length[i], plain->length[i]);
      if (wide->length[i] < kLeastSlope) continue;
      ASSERT_EQ(wide->slack[i], plain->slack[i]);
      for (std::size_t k = 0; k < 6; ++k) ASSERT_EQ(wide->normal[k][i], plain->normal[k][i]);
    }
  }
}

TEST(ViolatedRows, TheWorstIsThatOfALookAtEach) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto rows = std::make_unique<RowArrays>();
  int none = 0, equalities = 0;
  for (int turn = 0; turn < 2000; ++turn) {
    rows->count = 4 * (1 + static_cast<std::size_t>(turn) % (RowArrays::kMost / 4));
    std::array<double, RowArrays::kMost> barred{};
    Vector6 d{};
    for (double& x : d) x = turn % 50 == 0 ? 0.0 : unit(random);
    for (std::size_t i = 0; i < rows->count; ++i) {
      for (auto& numbers : rows->normal) numbers[i] = unit(random);
      rows->slack[i] = unit(random) + (turn % 3 == 0 ? 5.0 : 0.0);
      rows->both_ways[i] = turn % 3 != 0 && i % 7 == 3 ? 1.0 : 0.0;
      barred[i] = i % 5 == 4 ? std::numeric_limits<double>::infinity() : 0.0;
    }
    double worst = -1e-3;
    std::size_t expected = rows->count;
    for (std::size_t i = 0; i < rows->count; ++i) {
      double left = rows->slack[i];
      for (std::size_t k = 0; k < 6; ++k) left += rows->normal[k][i] * d[k];
      if (rows->both_ways[i] > 0.0) left = -std::abs(left);
      if (barred[i] > 0.0 || left >= worst) continue;
      worst = left;
      expected = i;
    }
    std::size_t found = rows->count, plainly = rows->count, here = rows->count;
    EXPECT_EQ(mostViolated(*rows, barred.data(), d, 1e-3, found), expected < rows->count);
    EXPECT_EQ(mostViolatedPortably(*rows, barred.data(), d, 1e-3, plainly), expected < rows->count);
    EXPECT_EQ(worstRowOf(*rows, barred.data(), d.data(), 1e-3, here), expected < rows->count);
    EXPECT_EQ(plainly, found);
    EXPECT_TRUE(expected == rows->count || here == found) << "as compiled for the test";
    EXPECT_EQ(found, expected) << turn;
    none += expected == rows->count ? 1 : 0;
    equalities += expected < rows->count && rows->both_ways[expected] > 0.0 ? 1 : 0;
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(equalities, 50);
}

/// The transposed inverse left Jacobian of SO(3) times g, in closed form: (1 - a / 2 cot(a / 2)) / a^2 for the second
/// order, a = |theta|.
dvec3 byInverseJacobian(const dvec3& theta, const dvec3& g) {
  const double a = glm::length(theta);
  const double second = (1.0 - 0.5 * a / std::tan(0.5 * a)) / (a * a);
  const dvec3 once = glm::cross(theta, g);
  return g + 0.5 * once + second * glm::cross(theta, once);
}

TEST(EntryRowsBody, EachLaneIsTheInverseJacobianToSecondOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int n = 0; n < 200; ++n) {
    dvec3 theta(unit(random), unit(random), unit(random));
    theta *= 0.5 / glm::length(theta);  // The largest turn of a set.
    Lanes g[6], at_first[6];
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t lane = 0; lane < kLanes; ++lane) at_first[i][lane] = g[i][lane] = unit(random);
    const double turned[3] = {theta.x, theta.y, theta.z};
    MetricChange(turned, 0.25).apply(g);
    const Lanes length = lengthOfAll(g);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const dvec3 before(at_first[3][lane], at_first[4][lane], at_first[5][lane]);
      const dvec3 exact = byInverseJacobian(theta, before) / 0.25;
      const dvec3 got(g[3][lane], g[4][lane], g[5][lane]);
      EXPECT_LT(glm::length(got - exact), 1e-3 * glm::length(exact));
      double squares = 0.0;
      for (std::size_t i = 0; i < 6; ++i) {
        squares += g[i][lane] * g[i][lane];
        EXPECT_TRUE(i >= 3 || g[i][lane] == at_first[i][lane]) << "the translation is as it was";
      }
      EXPECT_NEAR(length[lane], std::sqrt(squares), 1e-12);
    }
  }
}

TEST(EntryRowsBody, IsTheSameWhereverItIsCompiled) {
  const auto arrays = std::make_unique<EntryArrays>();
  const auto here = std::make_unique<EntryRows>(), plain = std::make_unique<EntryRows>();
  for (unsigned seed = 0; seed < 50; ++seed) {
    Entries entries(seed);
    arrays->take(entries.set);
    rowsOfAll(*arrays, entries.xi.data(), entries.age, *here);
    makeRowsPortably(*arrays, entries.xi, entries.age, *plain);
    for (std::size_t i = 0; i < entries.set.count; ++i) {
      ASSERT_EQ(here->length[i], plain->length[i]);
      if (here->length[i] < kLeastSlope) continue;
      ASSERT_EQ(here->slack[i], plain->slack[i]);
    }
  }
}

}  // namespace
}  // namespace hapticell::haptic
