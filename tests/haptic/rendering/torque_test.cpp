// SPDX-License-Identifier: Apache-2.0
// Devices of six driven axes: what turns is felt as a torque.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptic/rendering/energy_account.h"
#include "haptic/rendering/safety_chain.h"
#include "tests/haptic/rendering/rendered_floor.h"

namespace hapticell::haptic {
namespace {

RendererOptions turning(double peak_torque = 1.0) {
  RendererOptions options;
  options.peak_torque = peak_torque;
  return options;
}

Pose turned(double z, double angle) {
  return {dvec3(0, 0, z), quaternionFromRotationVector(dvec3(0, angle, 0))};
}

/// A floor under the end of a lever of 100 mm along x.
ConstraintSet leverSet() {
  ConstraintSet set = floorSet(1);
  set.constraints[0] = feel::bodyPointConstraint(dvec3(0.1, 0, 0), 0.0, dvec3(0, 0, 1), set.X_DR);
  return set;
}

TEST(Torque, IsTheLeverTimesTheForce) {
  ForceRenderer renderer(turning());
  renderer.reset(turned(0.001, 0.0));
  renderer.adopt(leverSet());
  RenderResult result;
  for (int i = 1; i <= 800; ++i) result = renderer.tick(turned(0.001, 0.05 * std::min(1.0, i / 500.0)), kTick);
  ASSERT_GT(result.force_D.z, 0.1);
  // rho x F about the stylus; the lever itself is turned a little.
  const dvec3 rho = glm::mat3_cast(result.X_DP.q) * dvec3(0.1, 0, 0);
  const dvec3 expected = glm::cross(rho, result.force_D);
  EXPECT_NEAR(glm::distance(result.torque_D, expected), 0.0, 0.02 * glm::length(expected));
  // The stylus gives way in both: springs K and K l^2 in series, where the end is pushed up by its depth.
  const double depth = 0.1 * std::sin(0.05) - 0.001, l = kRotationLever;
  EXPECT_NEAR(result.force_D.z, 1000.0 * depth / (1.0 + 0.01 / (l * l)), 0.03 * result.force_D.z);
}

TEST(Torque, IsZeroInFreeMotionAndOnDevicesThatDriveNone) {
  ForceRenderer free(turning());
  free.reset(turned(0.05, 0.0));
  free.adopt(leverSet());
  ForceRenderer three;
  three.reset(turned(0.001, 0.0));
  three.adopt(leverSet());
  for (int i = 0; i < 500; ++i) {
    const RenderResult far = free.tick(turned(0.05, 0.2 * std::sin(0.02 * i)), kTick);
    EXPECT_EQ(far.torque_D, dvec3(0.0));
    EXPECT_EQ(far.force_D, dvec3(0.0));
    EXPECT_EQ(three.tick(turned(0.001, 1e-4 * i), kTick).torque_D, dvec3(0.0));
  }
}

TEST(Torque, YieldsAtWhatTheMotorsBear) {
  ForceRenderer renderer(turning(0.05));
  renderer.reset(turned(0.001, 0.0));
  renderer.adopt(leverSet());
  double most = 0.0;
  for (int i = 1; i <= 1500; ++i) {
    const RenderResult result = renderer.tick(turned(0.001, 0.3 * std::min(1.0, i / 1000.0)), kTick);
    most = std::max(most, glm::length(result.spring_torque_D));
  }
  EXPECT_LE(most, 0.05 + 1e-9);
  EXPECT_GT(most, 0.045);
}

/// A wrist that turns the lever into the floor and out again, slowly and fast.
TEST(Torque, MakesNoEnergy) {
  for (const double rate : {2.0, 6.0}) {
    ForceRenderer renderer(turning());
    Pose last = turned(0.001, 0.0);
    renderer.reset(last);
    renderer.adopt(leverSet());
    EnergyAccount account(1);
    WorstLoss loss;
    MetricVector commanded;
    double most = 0.0;
    for (int i = 1; i <= 4000; ++i) {
      const Pose X_DS = turned(0.001, 0.03 - 0.03 * std::cos(rate * kTick * i));
      const RenderResult result = renderer.tick(X_DS, kTick);
      account.add(renderer.way(X_DS, last), commanded, result.stiffness);
      loss.add(kTick * i, account.balance());
      commanded = {result.force_D, result.torque_D / kRotationLever};
      most = std::max(most, glm::length(result.torque_D));
      last = X_DS;
    }
    EXPECT_GT(most, 0.05);
    EXPECT_GE(loss.value(), -0.5e-3) << rate;
  }
}

TEST(Torque, KeepsItsPeakAndSlewWhateverIsWanted) {
  SafetyOptions options;
  options.peak_torque = 0.188;
  SafetyChain chain(options);
  SafetyInput input;
  input.enabled = true;
  for (int i = 0; i < 1100; ++i) chain.tick(input);
  std::mt19937_64 random(4);
  std::normal_distribution<double> any(0.0, 1.0);
  dvec3 last(0.0);
  for (int i = 0; i < 5000; ++i) {
    input.torque_D = std::pow(10.0, 3.0 * any(random)) * dvec3(any(random), any(random), any(random));
    if (i % 97 == 0) input.torque_D.x = kNan;
    const SafetyResult result = chain.tick(input);
    ASSERT_LE(glm::length(result.torque_D), 0.188 * (1.0 + 1e-12));
    ASSERT_LE(glm::distance(result.torque_D, last), kRotationLever * (1.0 + 1e-9)) << "1 N at the lever";
    last = result.torque_D;
  }
  SafetyChain none;
  for (int i = 0; i < 1100; ++i) EXPECT_EQ(none.tick(input).torque_D, dvec3(0.0));
}

}  // namespace
}  // namespace hapticell::haptic
