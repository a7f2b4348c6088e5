// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/phantom_arm.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace hapticell::haptic {
namespace {

dvec3 randomPoint(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  return dvec3(0.160, 0.130, 0.130) * dvec3(unit(random), unit(random), unit(random));
}

TEST(PhantomArm, ReachesTheWholeWorkspaceOfTheDesktop) {
  const PhantomArm arm(0.160, 0.160);
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 p(corner & 1 ? 0.08 : -0.08, corner & 2 ? 0.065 : -0.065, corner & 4 ? 0.065 : -0.065);
    EXPECT_LT(glm::length(p - arm.shoulder()), 0.97 * arm.reach()) << corner;
    EXPECT_LT(glm::length(arm.tip(arm.joints(p)) - p), 1e-12) << corner;
  }
}

TEST(PhantomArm, JointsInvertTip) {
  const PhantomArm arm(0.160, 0.140);
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p = randomPoint(random);
    EXPECT_LT(glm::length(arm.tip(arm.joints(p)) - p), 1e-12);
  }
}

TEST(PhantomArm, JacobianIsTheDerivativeOfTip) {
  const PhantomArm arm(0.215, 0.170);
  std::mt19937 random(2);
  const double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const dvec3 q = arm.joints(randomPoint(random));
    const dmat3 J = arm.jacobian(q);
    for (int k = 0; k < 3; ++k) {
      dvec3 step(0.0);
      step[k] = h;
      const dvec3 slope = (arm.tip(q + step) - arm.tip(q - step)) / (2.0 * h);
      EXPECT_LT(glm::length(slope - J[k]), 1e-9);
    }
  }
}

/// J^T F by virtual work along differences of the tip, and back by F = J^-T tau.
TEST(PhantomArm, TorquesDoTheForcesWork) {
  const PhantomArm arm(0.215, 0.170);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> newton(-8.0, 8.0);
  const double h = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const dvec3 q = arm.joints(randomPoint(random));
    const dvec3 force(newton(random), newton(random), newton(random));
    const dmat3 J = arm.jacobian(q);
    const dvec3 torques = glm::transpose(J) * force;
    for (int k = 0; k < 3; ++k) {
      dvec3 step(0.0);
      step[k] = h;
      EXPECT_NEAR(torques[k], glm::dot(force, arm.tip(q + step) - arm.tip(q - step)) / (2.0 * h), 1e-7);
    }
    EXPECT_LT(glm::length(glm::inverse(glm::transpose(J)) * torques - force), 1e-9);
  }
}

TEST(PhantomArm, KeepsTheRayOfATipOutOfReach) {
  const PhantomArm arm(0.160, 0.160);
  const dvec3 far(0.0, -2.0, 0.5);
  const dvec3 reached = arm.tip(arm.joints(far)) - arm.shoulder();
  EXPECT_NEAR(glm::length(reached), arm.reach(), 1e-5);
  EXPECT_LT(glm::length(glm::cross(glm::normalize(reached), glm::normalize(far - arm.shoulder()))), 1e-6);
}

}  // namespace
}  // namespace hapticell::haptic
