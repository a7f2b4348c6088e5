// SPDX-License-Identifier: Apache-2.0
#include "kinematics/kernels/kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/closed_form/inverse_factory.h"
#include "kinematics/closed_form/trigonometric_roots.h"
#include "kinematics/kernels/lane_math.h"
#include "kinematics/model/turns.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

using namespace kernels;

TEST(LaneMath, ArcTangentMatchesTheLibrary) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::pow(10.0, 3.0 * normal(random));
    const double y[4] = {normal(random), size * normal(random), 0.0, normal(random)};
    const double x[4] = {normal(random), normal(random), normal(random), 0.0};
    const Lanes angle = arcTangent(load(y), load(x));
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(angle[k], std::atan2(y[k], x[k]), 1e-15) << y[k] << " " << x[k];
  }
}

TEST(LaneMath, SineAndCosineMatchTheLibrary) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-20.0, 20.0);
  for (int i = 0; i < 20000; ++i) {
    const double angle[4] = {uniform(random), uniform(random), 1e-3 * uniform(random), 1e-9 * uniform(random)};
    Lanes s, c;
    sineCosine(load(angle), s, c);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(s[k], std::sin(angle[k]), 6e-16) << angle[k];
      EXPECT_NEAR(c[k], std::cos(angle[k]), 6e-16) << angle[k];
    }
  }
}

TEST(LaneMath, MasksAndRounding) {
  const Lanes a(-1.5, 0.25, 2.5, 1e6 + 0.75), zero(0.0);
  EXPECT_EQ(bitsOf(a > zero), 0b1110u);
  EXPECT_EQ(select(a > zero, a, -a)[0], 1.5);
  EXPECT_EQ(nearestWhole(a)[3], 1e6 + 1);
  EXPECT_EQ(absolute(a)[0], 1.5);
  EXPECT_EQ(withSignOf(Lanes(2.0), a)[0], -2.0);
  EXPECT_EQ(squareRoot(Lanes(4.0))[2], 2.0);
}

class BothBuilds : public testing::Test {
 protected:
  void TearDown() override { usePlain(false); }
};

TEST_F(BothBuilds, GiveTheSameSolutions) {
  if (avx2Table() == nullptr) GTEST_SKIP() << "this processor has no AVX2";
  for (const auto& make : {test::kr120, test::ur5e, test::iiwa, test::panda, test::offsetWrist}) {
    const RobotModel model = make();
    const auto inverse = createInverse(model, model.defaultTip());
    std::mt19937_64 random(3);
    for (int i = 0; i < 30; ++i) {
      const std::vector<double> q = test::randomJoints(model, random);
      const Pose X_BT = test::tipPose(model, q, model.defaultTip());
      usePlain(false);
      const auto best = (*inverse)->solveAll(X_BT, q);
      usePlain(true);
      const auto plain = (*inverse)->solveAll(X_BT, q);
      ASSERT_EQ(best.size(), plain.size());
      for (const AlternativeSolution& one : best) {
        EXPECT_TRUE(std::any_of(plain.begin(), plain.end(), [&](const AlternativeSolution& other) {
          ChainPositions a{}, b{};  // a half turn is as near either way
          std::copy(one.q.begin(), one.q.end(), a.begin());
          std::copy(other.q.begin(), other.q.end(), b.begin());
          return sameButForTurns(*(*inverse)->chain(), a, b, 1e-6);
        }));
      }
    }
  }
}

TEST(TrigonometricRoots, AreAllFound) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const TrigonometricPolynomial f{uniform(random), uniform(random), uniform(random),
                                    i % 3 == 0 ? 0.0 : uniform(random), i % 3 == 0 ? 0.0 : uniform(random)};
    std::array<double, 4> roots{};
    const int count = realRoots(f, roots);
    int crossings = 0;
    constexpr int kSteps = 400;
    for (int k = 0; k < kSteps; ++k) {
      const double a = -std::numbers::pi + 2.0 * std::numbers::pi * k / kSteps, b = a + 2.0 * std::numbers::pi / kSteps;
      if (f(a) * f(b) >= 0.0) continue;
      ++crossings;
      bool inside = false;
      for (int r = 0; r < count; ++r)
        inside = inside ||
                 (roots[static_cast<std::size_t>(r)] >= a - 1e-9 && roots[static_cast<std::size_t>(r)] <= b + 1e-9);
      EXPECT_TRUE(inside) << i;
    }
    EXPECT_GE(count, crossings);
  }
  std::array<double, 4> roots{};
  EXPECT_EQ(realRoots({}, roots), 0);
  EXPECT_EQ(realRoots({2.0, 1.0, 0.0, 0.0, 0.0}, roots), 0);
}

}  // namespace
}  // namespace hapticell::kinematics
