// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/hand_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Segment;
using mannequin::Side;

constexpr double kGravity = 9.80665;

mannequin::Figure measuredMan() {
  return *mannequin::makeFigure({mannequin::Sex::kMale, 1.755});
}

/// Potential energy of all above a posture's pelvis with a load in the right hand.
double energy(const mannequin::Figure& figure, const mannequin::Posture& posture, double load_kg) {
  const auto pose = mannequin::forwardKinematics(figure, posture);
  const dvec3 com = mannequin::centerOfMass(figure, pose);
  const auto right = static_cast<std::size_t>(Side::kRight);
  const dvec3 grip = mannequin::handPose(pose, Side::kRight) * figure.p_HandGrip[right];
  return kGravity * (figure.totalMass() * com.z + load_kg * grip.z);
}

TEST(HandForces, MomentsAreTheChangeOfPotentialEnergy) {
  const mannequin::Figure figure = measuredMan();
  mannequin::Posture posture = *mannequin::libraryPosture(figure, "both_hands_forward");
  WorkTask task;
  task.load_kg[static_cast<std::size_t>(Side::kRight)] = 6.0;
  const auto forces = handForces(figure, mannequin::forwardKinematics(figure, posture), task);
  // Elbow flexion turns about one axis; where that lies level, its change of energy is the whole moment.
  const Dof elbow = armDof(Side::kRight, Dof::kLeftElbowFlexion);
  mannequin::Posture up = posture, down = posture;
  constexpr double kStep = 1e-5;
  up.angles[mannequin::indexOf(elbow)] += kStep;
  down.angles[mannequin::indexOf(elbow)] -= kStep;
  const double by_energy = (energy(figure, up, 6.0) - energy(figure, down, 6.0)) / (2.0 * kStep);
  const double moment = forces.elbow_nm[static_cast<std::size_t>(Side::kRight)];
  EXPECT_GE(moment, std::abs(by_energy) - 1e-6);
  EXPECT_GT(moment, 6.0 * kGravity * 0.1);
  EXPECT_LT(std::abs(by_energy), moment + 1e-6);
  EXPECT_GT(std::abs(by_energy), 0.5 * moment) << "the axis lies nearly level here";
  EXPECT_GT(forces.shoulder_nm[1], forces.shoulder_nm[0]) << "the loaded side";
}

TEST(HandForces, AHangingArmTurnsNothingAndAStretchedOneTheMost) {
  const mannequin::Figure figure = measuredMan();
  mannequin::Posture hanging = *mannequin::libraryPosture(figure, "zero");
  WorkTask task;
  task.load_kg = {0.0, 10.0};
  const auto low = handForces(figure, mannequin::forwardKinematics(figure, hanging), task);
  mannequin::Posture level = hanging;
  level.angles[mannequin::indexOf(armDof(Side::kRight, Dof::kLeftShoulderFlexion))] = 0.5 * std::numbers::pi;
  const auto pose = mannequin::forwardKinematics(figure, level);
  const auto high = handForces(figure, pose, task);
  const dvec3 grip = mannequin::handPose(pose, Side::kRight) * figure.p_HandGrip[1];
  const dvec3 shoulder = pose[armSegment(Side::kRight, Segment::kLeftUpperArm)].p_WS;
  const double of_load = 10.0 * kGravity * std::hypot(grip.x - shoulder.x, grip.y - shoulder.y);
  EXPECT_LT(low.shoulder_nm[1], 0.15 * high.shoulder_nm[1]);
  EXPECT_GT(high.shoulder_nm[1], of_load);
  EXPECT_LT(high.shoulder_nm[1], of_load + 20.0) << "an arm weighs about 4 kg";
  EXPECT_GT(high.lumbar_nm, low.lumbar_nm);
}

TEST(HandForces, LimitsAreTheMethodsOwnClassesAndNothingIsInvented) {
  const mannequin::Figure figure = measuredMan();
  const auto pose = mannequin::forwardKinematics(figure, *mannequin::libraryPosture(figure, "standing"));
  WorkTask task;
  EXPECT_TRUE(handForces(figure, pose, task).limits.empty());
  task.load_kg = {std::nullopt, 3.0};
  const auto forces = handForces(figure, pose, task);
  EXPECT_FALSE(forces.force_n[0]);
  ASSERT_EQ(forces.limits.size(), 3u);
  EXPECT_EQ(forces.limits[0].method, "RULA");
  EXPECT_EQ(forces.limits[0].hand, 1);
  EXPECT_EQ(forces.limits[0].band, 1);
  EXPECT_NEAR(*forces.limits[0].limit_n, 98.0665, 1e-9);
  EXPECT_NEAR(*forces.limits[1].limit_n, 5.0 * kGravity, 1e-9);
  EXPECT_EQ(forces.limits[2].band, 0);
  EXPECT_NEAR(*forces.limits[0].lower_n, 2.0 * kGravity, 1e-9) << "what brings it down a class";
  EXPECT_FALSE(forces.limits[2].lower_n);
  task.load_kg = {12.0, 12.0};
  for (const ForceLimit& limit : handForces(figure, pose, task).limits) {
    EXPECT_FALSE(limit.limit_n);
    EXPECT_EQ(limit.band, 3);
  }
}

TEST(HandForces, OwnLimitsAreThoseOfTheGripsPlaceAndWithoutThemItIsPartial) {
  const mannequin::Figure figure = measuredMan();
  const auto pose = mannequin::forwardKinematics(figure, *mannequin::libraryPosture(figure, "overhead"));
  WorkTask task;
  EXPECT_EQ(handForces(figure, pose, task).missing.size(), 3u) << "both loads and the limits";
  task.load_kg = {0.0, 4.0};
  EXPECT_EQ(handForces(figure, pose, task).missing, std::vector<std::string_view>{"force_limits"});
  ForceTable own{
      "a test",
      {{-1, {0.0, 1.4}, {0.0, 9.0}, 60.0}, {-1, {1.4, 3.0}, {0.0, 9.0}, 50.0}, {1, {1.4, 3.0}, {0.0, 9.0}, 40.0}}};
  const auto forces = handForces(figure, pose, task, own);
  EXPECT_TRUE(forces.missing.empty());
  int found = 0;
  for (const ForceLimit& limit : forces.limits) {
    if (limit.method != "own") continue;
    ++found;
    EXPECT_EQ(*limit.limit_n, limit.hand == 1 ? 40.0 : 50.0);
    EXPECT_EQ(limit.band, limit.hand == 1 ? 2 : 0) << "39.2 of 40 N";
    EXPECT_NEAR(limit.lower_n.value_or(0.0), limit.hand == 1 ? 28.0 : 0.0, 1e-9);
  }
  EXPECT_EQ(found, 2);
  own.rows.pop_back();
  own.rows.pop_back();
  EXPECT_EQ(handForces(figure, pose, task, own).missing.size(), 1u) << "none holds overhead";
}

}  // namespace
}  // namespace hapticell::ergonomics
