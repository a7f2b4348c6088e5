// SPDX-License-Identifier: Apache-2.0
// Angles in anatomical planes: none leaks into another, none jumps.
#include "mannequin/ergonomics/methods/view_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mannequin/ergonomics/advice/motion_scores.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"
#include "mannequin/ergonomics/methods/static_posture.h"
#include "mannequin/ergonomics/scores/figure_measurement.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/motion_writer.h"
#include "tests/mannequin/body/median_man.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::Posture;
using mannequin::Side;

constexpr double kViewRadians = std::numbers::pi / 180.0;
using Angles = std::vector<std::pair<Dof, double>>;

Posture bent(const Angles& degrees) {
  Posture posture;
  for (const auto& [dof, angle] : degrees) posture[dof] = angle * kViewRadians;
  return posture;
}

MeasuredPosture viewedFrom(const Figure& figure, const Posture& posture, Side side = Side::kRight) {
  return measure(figure, posture, mannequin::forwardKinematics(figure, posture), side);
}

dvec3 armDirection(double flexion, double sideways) {
  const double f = flexion * kViewRadians, s = sideways * kViewRadians;
  return {std::cos(s) * std::sin(f), std::sin(s), -std::cos(s) * std::cos(f)};
}

TEST(ViewPlanes, AnArmIsSeenFromTheSideWhereTheViewIsLongEnough) {
  for (double flexion = -60.0; flexion <= 90.0; flexion += 7.5) {
    for (double out = -30.0; out <= 70.0; out += 5.0) {
      if (flexion == 90.0 && out != 0.0) continue;  // Level: the view goes over to the elevation.
      const dvec3 arm = armDirection(flexion, out);
      if (-arm.z < 0.2 * std::abs(arm.y)) continue;
      const PlaneAngles angles = upperArmAngles({}, 0.3 * arm);
      EXPECT_NEAR(angles.flexion, flexion, 1e-9);
      EXPECT_NEAR(angles.sideways, out, 1e-9);
      EXPECT_NEAR(angles.elevation, armElevation(flexion, out), 1e-6);
    }
  }
}

TEST(ViewPlanes, AnArmAboveTheShoulderCountsByItsElevation) {
  for (double elevation = 105.0; elevation <= 180.0; elevation += 5.0) {
    for (double azimuth = -90.0; azimuth <= 180.0; azimuth += 15.0) {
      const double e = elevation * kViewRadians, a = azimuth * kViewRadians;
      const PlaneAngles angles =
          upperArmAngles({}, {std::sin(e) * std::cos(a), std::sin(e) * std::sin(a), -std::cos(e)});
      EXPECT_NEAR(angles.flexion, elevation, 1e-6) << azimuth;
    }
  }
  EXPECT_NEAR(upperArmAngles({}, armDirection(130.0, 0.0)).flexion, 130.0, 1e-9);
  EXPECT_NEAR(upperArmAngles({}, armDirection(96.0, 0.0)).flexion, 96.0, 1e-9);
}

// By many short steps over the sphere: nowhere does it jump.
TEST(ViewPlanes, AnArmsFlexionIsContinuousInAllDirections) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> any;
  constexpr double kStep = 0.01;
  for (int i = 0; i < 200000; ++i) {
    const dvec3 d = glm::normalize(dvec3(any(random), any(random), any(random)));
    const dvec3 near =
        glm::normalize(d + kStep * kViewRadians * glm::normalize(dvec3(any(random), any(random), any(random))));
    EXPECT_LT(std::abs(upperArmAngles({}, d).flexion - upperArmAngles({}, near).flexion), 20.0 * kStep)
        << d.x << " " << d.y << " " << d.z;
  }
}

TEST(ViewPlanes, ASideBendHasNoFlexionAndATurnHasNeither) {
  const Figure figure = mannequin::medianMan();
  for (const double share : {-1.0, -0.4, 0.3, 1.0}) {
    const MeasuredPosture side = viewedFrom(
        figure,
        bent({{Dof::kVl5RightBend, 11 * share}, {Dof::kVl1RightBend, 12 * share}, {Dof::kVt6RightBend, 9 * share}}));
    EXPECT_EQ(side.trunk_flexion, 0.0);
    EXPECT_EQ(side.trunk_twist, 0.0);
    EXPECT_GT(std::abs(side.trunk_side_bend), 15.0 * std::abs(share));
    const MeasuredPosture turn = viewedFrom(
        figure,
        bent({{Dof::kVt6LeftTurn, 25 * share}, {Dof::kVl1LeftTurn, 8 * share}, {Dof::kVl5LeftTurn, 2 * share}}));
    EXPECT_EQ(turn.trunk_flexion, 0.0);
    EXPECT_EQ(turn.trunk_side_bend, 0.0);
    EXPECT_NEAR(turn.trunk_twist, 35.0 * share, 1e-9);
    EXPECT_NEAR(turn.upper_arm_flexion, viewedFrom(figure, Posture{}).upper_arm_flexion, 1e-6);
    const MeasuredPosture forward =
        viewedFrom(figure, bent({{Dof::kVl5Flexion, 20 * share}, {Dof::kVl1Flexion, 8 * share}}));
    EXPECT_EQ(forward.trunk_side_bend, 0.0);
    EXPECT_EQ(forward.trunk_twist, 0.0);
    EXPECT_GT(forward.trunk_flexion * share, 0.0);
    const MeasuredPosture neck_side = viewedFrom(figure, bent({{Dof::kVc7RightBend, 14 * share},
                                                               {Dof::kVc4RightBend, 15 * share},
                                                               {Dof::kSkullbaseRightBend, 9 * share}}));
    EXPECT_EQ(neck_side.neck_flexion, 0.0);
    EXPECT_EQ(neck_side.neck_twist, 0.0);
    EXPECT_NEAR(neck_side.neck_side_bend, 38.0 * share, 1e-9);
    const MeasuredPosture neck_turn = viewedFrom(figure, bent({{Dof::kVc7LeftTurn, 14 * share},
                                                               {Dof::kVc4LeftTurn, 24 * share},
                                                               {Dof::kSkullbaseLeftTurn, 40 * share}}));
    EXPECT_EQ(neck_turn.neck_flexion, 0.0);
    EXPECT_EQ(neck_turn.neck_side_bend, 0.0);
    EXPECT_NEAR(neck_turn.neck_twist, 78.0 * share, 1e-9);
  }
}

TEST(ViewPlanes, OneJointBentAllThreeWaysGivesItsOwnThreeAngles) {
  const Figure figure = mannequin::medianMan();
  for (const double flexion : {-20.0, 5.0, 14.0}) {
    for (const double bend : {-18.0, 12.0}) {
      for (const double turn : {-30.0, 24.0}) {
        const MeasuredPosture neck = viewedFrom(figure, bent({{Dof::kSkullbaseFlexion, flexion},
                                                              {Dof::kSkullbaseRightBend, bend},
                                                              {Dof::kSkullbaseLeftTurn, turn}}));
        EXPECT_NEAR(neck.neck_flexion, flexion, 1e-9);
        EXPECT_NEAR(neck.neck_side_bend, bend, 1e-9);
        EXPECT_NEAR(neck.neck_twist, turn, 1e-9);
        const MeasuredPosture trunk = viewedFrom(
            figure, bent({{Dof::kVl1Flexion, flexion}, {Dof::kVl1RightBend, bend}, {Dof::kVl1LeftTurn, turn}}));
        EXPECT_NEAR(trunk.trunk_twist, turn, 1e-9);
      }
    }
  }
}

TEST(ViewPlanes, AnArmBehindTheBodyIsBehindIt) {
  const Figure figure = mannequin::medianMan();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (double back = 0.0; back <= 55.0; back += 1.0) {
      const MeasuredPosture m = viewedFrom(figure, bent({{armDof(side, Dof::kLeftShoulderFlexion), -back}}), side);
      EXPECT_FALSE(*postureAngles(m).lower_arm_across_midline) << back;
      EXPECT_NEAR(m.upper_arm_flexion - viewedFrom(figure, Posture{}, side).upper_arm_flexion, -back, 1.0);
    }
    // A forearm that goes straight out is out to the side, one across the chest is past the midline.
    const MeasuredPosture out = viewedFrom(
        figure,
        bent({{armDof(side, Dof::kLeftElbowFlexion), 90}, {armDof(side, Dof::kLeftShoulderInternalRotation), -80}}),
        side);
    EXPECT_TRUE(*postureAngles(out).lower_arm_across_midline);
    const MeasuredPosture across = viewedFrom(
        figure,
        bent({{armDof(side, Dof::kLeftElbowFlexion), 90}, {armDof(side, Dof::kLeftShoulderInternalRotation), 70}}),
        side);
    EXPECT_TRUE(across.wrist_past_midline);
  }
}

TEST(ViewPlanes, AMeasuredNeckWithinTheBandIsNeutralAndATypedOneIsNot) {
  std::vector<std::string_view> unknown;
  const auto neckOf = [&](double flexion, bool is_measured) {
    PostureAngles angles;
    angles.neck_flexion = flexion;
    angles.measured = is_measured;
    return std::pair(*rulaValues(angles, unknown)[Rula::kNeck], *rebaValues(angles, unknown)[Reba::kNeck]);
  };
  EXPECT_EQ(neckOf(-0.6, false), std::pair(4, 2));
  EXPECT_EQ(neckOf(-0.6, true), std::pair(1, 1));
  EXPECT_EQ(neckOf(-5.0, true), std::pair(1, 1));
  EXPECT_EQ(neckOf(-6.0, true), std::pair(2, 2));
  EXPECT_EQ(neckOf(-7.0, true), std::pair(3, 2));
  EXPECT_EQ(neckOf(-9.0, true), std::pair(4, 2));
  MeasuredPosture measured;
  measured.neck_flexion = -0.57;
  EXPECT_EQ(rulaValues(postureAngles(measured), unknown)[Rula::kNeck], 1);
  measured.trunk_flexion = -1.5;
  const ZonePosture zones = settledZones({measured, -2.0, -2.0, {}});
  EXPECT_EQ(en1005(zones.measured, zones.gaze_below_horizontal, zones.use).worst, Zone::kAcceptable);
  EXPECT_EQ(iso11226(zones.measured, zones.head_inclination, zones.use).worst, Zone::kAcceptable);
}

// The same of a recording, by where its joints are: leaning back is not forward, nor to a side.
TEST(ViewPlanes, ARecordedTrunkHasADirection) {
  const Figure figure = mannequin::medianMan();
  const std::vector<Angles> bends{{},
                                  {{Dof::kVl5RightBend, 11}, {Dof::kVl1RightBend, 12}, {Dof::kVt6RightBend, 9}},
                                  {{Dof::kVt6LeftTurn, 25}, {Dof::kVl1LeftTurn, 8}, {Dof::kVl5LeftTurn, 2}},
                                  {{Dof::kVl5Flexion, 30}, {Dof::kVl1Flexion, 25}},
                                  {{Dof::kVl5Flexion, -12}, {Dof::kVl1Flexion, -8}, {Dof::kVt6Flexion, -5}},
                                  {{Dof::kVl5Flexion, 20}, {Dof::kVl1RightBend, -13}}};
  std::vector<Posture> postures;
  for (const Angles& angles : bends) {
    for (const double heading : {0.0, 2.0}) {
      postures.push_back(bent(angles));
      postures.back().X_WR.q = quaternionFromRotationVector({0.0, 0.0, heading});
    }
  }
  const auto clip = mannequin::readBvh(mannequin::bvhText(figure, postures, 0.1), "written");
  ASSERT_TRUE(clip) << clip.error().message();
  const auto rula = scoreMotion(*clip, figure, MotionMethod::kRula, {});
  ASSERT_TRUE(rula) << rula.error().message();
  for (std::size_t i = 0; i < postures.size(); ++i) {
    const MeasuredPosture own = viewedFrom(figure, postures[i]);
    EXPECT_NEAR(rula->frames[i].trunk_flexion, own.trunk_flexion, 1.0) << i;
    EXPECT_NEAR(rula->frames[i].trunk_side_bend, own.trunk_side_bend, 1.5) << i;
  }
  // Alone a side bend, alone a turn: one class more than upright, of RULA and of REBA, and of OWAS no bent back.
  for (const std::size_t i : {std::size_t{2}, std::size_t{4}}) {
    mannequin::MotionClip one = *clip;
    one.frames = {clip->frames[i]};
    EXPECT_EQ(scoreMotion(one, figure, MotionMethod::kRula, {})->worst_values[Rula::kTrunk], 2);
    EXPECT_EQ(scoreMotion(one, figure, MotionMethod::kReba, {})->worst_values[Reba::kTrunk], 2);
    EXPECT_EQ(*scoreMotion(one, figure, MotionMethod::kOwas, {})->worst_values[Owas::kBack] % 2, 1);
  }
}

}  // namespace
}  // namespace hapticell::ergonomics
