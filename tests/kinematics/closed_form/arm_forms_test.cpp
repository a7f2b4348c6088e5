// SPDX-License-Identifier: Apache-2.0
// The closed forms one by one, each made from axes alone and compared with the chain that the axes came from.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

#include "kinematics/closed_form/offset_wrist.h"
#include "kinematics/closed_form/opw_geometry.h"
#include "kinematics/closed_form/scara.h"
#include "kinematics/closed_form/spherical_arm.h"
#include "kinematics/closed_form/trigonometric_roots.h"
#include "kinematics/closures/arm_builder.h"
#include "tests/kinematics/model/test_robots.h"

namespace hapticell::kinematics {
namespace {

using FormMaker = std::function<std::unique_ptr<const ClosedForm>(const ArmAxes&)>;

/// Makes poses by joint positions; all solutions must reach them, and the joints that made them be among the solutions.
void expectRoundTrip(const RobotModel& model, const FormMaker& make, double tolerance, int most_solutions) {
  const auto chain = Chain::create(model, model.defaultTip(), {});
  ASSERT_TRUE(chain);
  const auto form = make(armAxes(*chain));
  ASSERT_TRUE(form);
  EXPECT_EQ(form->redundancy(), 0);
  std::mt19937_64 random(21);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> q = test::randomJoints(model, random);
    ChainPositions x{};
    std::copy(q.begin(), q.end(), x.begin());
    ChainState wanted, reached;
    chain->evaluate(x, wanted);
    kernels::Solutions solutions;
    form->solve(wanted.R_BT, wanted.p_BT, 0.0, x.data(), solutions);
    int valid = 0;
    bool is_found = false;
    for (int k = 0; k < 4 * form->groups(); ++k) {
      if ((solutions.valid >> k & 1u) == 0) continue;
      ++valid;
      ChainPositions found{};
      for (std::size_t j = 0; j < chain->size(); ++j) found[j] = solutions.q[j][k];
      chain->evaluate(found, reached);
      double error = glm::distance(reached.p_BT, wanted.p_BT);
      for (int c = 0; c < 3; ++c) error = std::max(error, glm::distance(reached.R_BT[c], wanted.R_BT[c]));
      EXPECT_LT(error, tolerance) << "pose " << i << ", solution " << k;
      double apart = 0.0;
      for (std::size_t j = 0; j < chain->size(); ++j) {
        const double change = found[j] - x[j];
        apart = std::max(
            apart, std::abs(chain->elements()[j].prismatic ? change : std::remainder(change, 2.0 * std::numbers::pi)));
      }
      is_found = is_found || apart < 1e-5;
    }
    EXPECT_TRUE(is_found) << "pose " << i;
    EXPECT_LE(valid, most_solutions);
  }
}

TEST(Scara, ReachesEveryPoseWhereverItsSlideIs) {
  for (const std::size_t slide : {0U, 1U, 2U, 3U}) {
    RobotModel model = test::emptyModel();
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec3 axis(0, 0, i % 2 == 0 ? 1 : -1);
      test::addJoint(model, static_cast<int>(i), test::numbered("j", i + 1),
                     i == slide ? JointType::kPrismatic : JointType::kRevolute, axis,
                     Pose::translation({0.3 + 0.1 * static_cast<double>(i), 0.05, 0.1}));
    }
    expectRoundTrip(model, makeScara, 1e-12, 2);
  }
}

TEST(Scara, ATiltedTipIsSolvedAsIfItWereUpright) {
  const RobotModel model = test::scara();
  const auto chain = Chain::create(model, model.defaultTip(), {});
  const auto form = makeScara(armAxes(*chain));
  ChainState state;
  chain->evaluate({0.4, -0.9, 0.1, 0.7}, state);
  const dmat3 tilt = glm::mat3_cast(glm::angleAxis(0.05, glm::normalize(dvec3(state.R_BT[0]))));
  const std::array<double, 4> previous{0.4, -0.9, 0.1, 0.7};
  kernels::Solutions upright, tilted;
  form->solve(state.R_BT, state.p_BT, 0.0, previous.data(), upright);
  form->solve(tilt * state.R_BT, state.p_BT, 0.0, previous.data(), tilted);
  EXPECT_EQ(upright.valid, 3u);
  EXPECT_EQ(tilted.valid, 3u);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(tilted.q[j][0], upright.q[j][0], 0.02);
}

TEST(Scara, StretchedItIsSolvedBeyondThatNothing) {
  const RobotModel model = test::scara();
  const auto form = makeScara(armAxes(*Chain::create(model, model.defaultTip(), {})));
  const std::array<double, 4> rest{};
  kernels::Solutions solutions;
  form->solve(dmat3(1.0), {0.65, 0.0, 0.1}, 0.0, rest.data(), solutions);
  EXPECT_EQ(solutions.valid, 3u);
  EXPECT_NEAR(solutions.q[1][0], 0.0, 1e-6);
  EXPECT_NEAR(solutions.q[2][0], 0.1, 1e-15);
  form->solve(dmat3(1.0), {0.651, 0.0, 0.1}, 0.0, rest.data(), solutions);
  EXPECT_EQ(solutions.valid, 0u);
  form->solve(dmat3(1.0), {0.099, 0.0, 0.1}, 0.0, rest.data(), solutions);
  EXPECT_EQ(solutions.valid, 0u) << "nearer than 375 - 275 mm";
}

TEST(SphericalArm, ReachesEveryPoseByItsWristOrItsBase) {
  expectRoundTrip(
      test::sphericalWrist(), [](const ArmAxes& axes) { return makeSphericalArm(axes, false); }, 1e-8, 8);
  expectRoundTrip(
      test::sphericalBase(), [](const ArmAxes& axes) { return makeSphericalArm(axes, true); }, 1e-8, 8);
}

TEST(OffsetWrist, ReachesEveryPose) {
  for (const RobotModel& model :
       {test::offsetWrist(), test::offsetWristAlongAxisFive(), test::offsetWristWithShoulder()}) {
    expectRoundTrip(model, makeOffsetWrist, 1e-8, 16);
  }
}

TEST(OpwGeometry, FindsTheParametersThatAnArmWasBuiltWith) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (int i = 0; i < 50; ++i) {
    const OpwParameters made{uniform(random),
                             uniform(random),
                             uniform(random),
                             0.4 + uniform(random),
                             0.6 + uniform(random),
                             0.7 + uniform(random),
                             0.1 + 0.4 * uniform(random),
                             {},
                             {1, 1, 1, 1, 1, 1}};
    std::vector<JointData> joints;
    for (int j = 0; j < 6; ++j) joints.push_back({test::numbered("j", static_cast<std::size_t>(j)), -3.0, 3.0, 2.0});
    const RobotModel model = buildOpw("arm", made, joints);
    const auto chain = Chain::create(model, model.defaultTip(), {});
    ASSERT_TRUE(chain);
    const OpwGeometry found(armAxes(*chain));
    EXPECT_NEAR(std::abs(found.arm.a1), std::abs(made.a1), 1e-12);
    EXPECT_NEAR(std::abs(found.arm.b), std::abs(made.b), 1e-12);
    EXPECT_NEAR(found.arm.c2, std::abs(made.c2), 1e-12);
    EXPECT_NEAR(found.arm.k, std::hypot(made.a2, made.c3), 1e-12);
    EXPECT_NEAR(found.arm.sin_psi, std::sin(found.arm.psi), 1e-15);
    EXPECT_NEAR(found.arm.cos_psi, std::cos(found.arm.psi), 1e-15);
    const dvec3 wrist(made.a1 + made.a2, made.b, made.c1 + made.c2 + made.c3);
    EXPECT_LT(glm::distance(found.wrist_B, wrist), 1e-12) << "straight up at zero";
    EXPECT_NEAR(glm::determinant(found.R_B0), 1.0, 1e-12);
    EXPECT_NEAR(std::abs(found.R_B0[2].z), 1.0, 1e-12) << "axis 1 is upright";
  }
}

/// Coefficients of f sampled round the circle, by the discrete Fourier transform.
TrigonometricPolynomial interpolated(const std::function<double(double)>& f) {
  constexpr int kSamples = 8;
  std::complex<double> c0, c1, c2;
  for (int i = 0; i < kSamples; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kSamples;
    c0 += f(t) / kSamples;
    c1 += f(t) * std::polar(2.0 / kSamples, t);
    c2 += f(t) * std::polar(2.0 / kSamples, 2.0 * t);
  }
  return {c0.real(), c1.real(), c1.imag(), c2.real(), c2.imag()};
}

double angleApart(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

RC_GTEST_PROP(TrigonometricRoots, ThoseThatAPolynomialWasMadeOfAreFound, ()) {
  const auto angle = [](int most) { return *rc::gen::inRange(-most, most + 1) * 1e-3; };
  const double m1 = angle(3141), h1 = 0.05 + std::abs(angle(2900)), m2 = angle(3141), h2 = 0.05 + std::abs(angle(2900));
  const auto f = [&](double t) { return (std::cos(t - m1) - std::cos(h1)) * (std::cos(t - m2) - std::cos(h2)); };
  const std::array<double, 4> made{m1 + h1, m1 - h1, m2 + h2, m2 - h2};
  double nearest = 7.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, angleApart(made[i], made[j]));
  }
  RC_PRE(nearest > 1e-2);
  std::array<double, 4> roots{};
  RC_ASSERT(realRoots(interpolated(f), roots) == 4);
  for (const double wanted : made) {
    RC_ASSERT(std::any_of(roots.begin(), roots.end(), [&](double root) { return angleApart(root, wanted) < 1e-9; }));
  }
  for (const double root : roots) RC_ASSERT(root > -std::numbers::pi - 1e-15 && root <= std::numbers::pi + 1e-15);
}

TEST(TrigonometricRoots, PlainEquationsHaveTheirTextbookRoots) {
  std::array<double, 4> roots{};
  ASSERT_EQ(realRoots({0.0, 0.0, 1.0, 0.0, 0.0}, roots), 2);  // sin t
  std::sort(roots.begin(), roots.begin() + 2, [](double a, double b) { return std::abs(a) < std::abs(b); });
  EXPECT_NEAR(roots[0], 0.0, 1e-12);
  EXPECT_NEAR(std::abs(roots[1]), std::numbers::pi, 1e-12);
  ASSERT_EQ(realRoots({-0.5, 1.0, 0.0, 0.0, 0.0}, roots), 2);  // cos t = 1/2
  EXPECT_NEAR(std::abs(roots[0]), std::numbers::pi / 3.0, 1e-12);
  EXPECT_NEAR(roots[0], -roots[1], 1e-12);
  ASSERT_EQ(realRoots({0.0, 0.0, 0.0, 1.0, 0.0}, roots), 4);  // cos 2t
  for (const double root : roots)
    EXPECT_NEAR(std::abs(std::remainder(root, std::numbers::pi / 2.0)), std::numbers::pi / 4.0, 1e-12);
  const int count = realRoots({1.0, 1.0, 0.0, 0.0, 0.0}, roots);  // 1 + cos t: a double root at pi
  ASSERT_GE(count, 1);
  for (int k = 0; k < count; ++k) EXPECT_NEAR(std::abs(roots[static_cast<std::size_t>(k)]), std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace hapticell::kinematics
