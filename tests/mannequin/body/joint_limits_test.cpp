// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/joint_limits.h"

#include <gtest/gtest.h>

#include <random>

#include "mannequin/posture/forward_kinematics.h"
#include "tests/mannequin/posture/random_postures.h"

namespace hapticell::mannequin {
namespace {

dmat3 turned(const dvec3& rotation_vector, const dmat3& R) {
  return glm::mat3_cast(quaternionFromRotationVector(rotation_vector)) * R;
}

TEST(JointLimits, StateAndRotationAreInverses) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const BallJoint joint : {BallJoint::kShoulder, BallJoint::kHip}) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      for (int n = 0; n < 200; ++n) {
        const double rho = 0.05 + 2.0 * unit(random), psi = 6.0 * unit(random) - 3.0, twist = 2.0 * unit(random) - 1.0;
        const BallState state = ballState(joint, side, ballRotation(joint, side, rho, psi, twist));
        EXPECT_NEAR(state.rho, rho, 1e-9);
        EXPECT_NEAR(state.psi, psi, 1e-9);
        EXPECT_NEAR(state.twist, twist, 1e-9);
      }
    }
  }
}

TEST(JointLimits, AnglesOfTheTablesLieOnTheBoundary) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto shoulder = [&](double flexion, double abduction) {
      Posture posture;
      posture[armDof(side, Dof::kLeftShoulderFlexion)] = flexion * kDegree;
      posture[armDof(side, Dof::kLeftShoulderAbduction)] = abduction * kDegree;
      return ballState(BallJoint::kShoulder, side, ballRotationOf(posture, armDof(side, Dof::kLeftShoulderFlexion)));
    };
    EXPECT_NEAR(shoulder(130, 0).excess(), 0.0, 1e-6);
    EXPECT_NEAR(shoulder(0, 130).excess(), 0.0, 1e-6);
    EXPECT_NEAR(shoulder(-55, 0).excess(), 0.0, 1e-6);
    EXPECT_NEAR(shoulder(0, -25).excess(), 0.0, 1e-6);
    EXPECT_LT(shoulder(0, 0).excess(), 0.0);
    EXPECT_NEAR(shoulder(0, 0).twist, 0.0, 1e-9);
    const auto hip = [&](double flexion) {
      Posture posture;
      posture[legDof(side, Dof::kLeftHipFlexion)] = flexion * kDegree;
      posture[legDof(side, Dof::kLeftHipAbduction)] = 7.5 * kDegree;
      return ballState(BallJoint::kHip, side, ballRotationOf(posture, legDof(side, Dof::kLeftHipFlexion)));
    };
    EXPECT_NEAR(hip(120).excess(), 0.0, 0.01);
    EXPECT_NEAR(hip(-30).excess(), 0.0, 0.01);
  }
}

TEST(JointLimits, InTheGivenAxesTheLimitsArePlainBounds) {
  std::mt19937_64 random(2);
  const double h = 1e-5;
  for (const BallJoint joint : {BallJoint::kShoulder, BallJoint::kHip}) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      for (int n = 0; n < 200; ++n) {
        const dmat3 R = randomBall(random, joint, side, 0.95);
        const BallAxes axes = ballAxes(joint, side, R);
        if (axes.state.rho < 0.15) continue;
        const auto rate = [&](const dvec3& axis) {
          const BallState a = ballState(joint, side, turned(h * axis, R)),
                          b = ballState(joint, side, turned(-h * axis, R));
          return std::pair((a.excess() - b.excess()) / (2 * h), (a.twist - b.twist) / (2 * h));
        };
        EXPECT_NEAR(rate(axes.cone).second, 0.0, 1e-4);
        EXPECT_NEAR(rate(axes.free).second, 0.0, 1e-4);
        EXPECT_NEAR(rate(axes.bone).second, 1.0, 1e-4);
        EXPECT_NEAR(rate(axes.bone).first, 0.0, 1e-4);
        // The boundary is linear between knots: at a knot the rate is that of one side.
        if (std::abs(rate(axes.cone).first - axes.cone_rate) > 1e-3) continue;
        EXPECT_NEAR(rate(axes.free).first, 0.0, 1e-3);
      }
    }
  }
}

TEST(JointLimits, ClampingBringsInsideAndKeepsWhatIsInside) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(-2.0, 2.0);
  for (int n = 0; n < 500; ++n) {
    const dmat3 R = glm::mat3_cast(quaternionFromRotationVector({unit(random), unit(random), unit(random)}));
    const dmat3 inside = clampBall(BallJoint::kShoulder, Side::kRight, R);
    EXPECT_LT(ballViolation(BallJoint::kShoulder, Side::kRight, inside), 1e-9);
    if (ballViolation(BallJoint::kShoulder, Side::kRight, R) == 0.0) {
      EXPECT_EQ(inside, R);
    }
  }
}

}  // namespace
}  // namespace hapticell::mannequin
