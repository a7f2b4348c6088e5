// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/glove_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace hapticell::mannequin {
namespace {

GloveCalibrationPoses poses() {
  GloveCalibrationPoses p;
  p.flat.fill(60.0);
  p.fist.fill(200.0);
  p.spread.fill(120.0);
  p.thumb_under.fill(150.0);
  return p;
}

TEST(Glove, TheCalibrationPosesGiveTheirOwnAnglesBack) {
  const GloveCalibrationPoses p = poses();
  const auto calibration = calibrateGlove(p);
  ASSERT_TRUE(calibration.has_value());
  EXPECT_NEAR(gloveAngles(*calibration, p.flat)[4], 0.0, 1e-12);
  EXPECT_NEAR(gloveAngles(*calibration, p.fist)[4], std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(gloveAngles(*calibration, p.spread)[10], 20.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_NEAR(gloveAngles(*calibration, p.thumb_under)[0], std::numbers::pi / 3, 1e-12);
  Posture posture;
  setHandFromGlove(gloveAngles(*calibration, p.fist), Side::kRight, posture);
  EXPECT_NEAR(posture[Dof::kRightFingersCurl], std::numbers::pi / 2, 1e-9);
  EXPECT_EQ(posture[Dof::kLeftFingersCurl], 0.0);
  setHandFromGlove(gloveAngles(*calibration, p.flat), Side::kRight, posture);
  EXPECT_NEAR(posture[Dof::kRightFingersCurl], 0.0, 1e-9);
  EXPECT_TRUE(limitViolations(posture).empty());
}

TEST(Glove, ADeadSensorIsNamedAndWildReadingsStayInside) {
  GloveCalibrationPoses p = poses();
  p.fist[8] = p.flat[8] + 1.0;
  std::size_t bad = 99;
  EXPECT_FALSE(calibrateGlove(p, &bad).has_value());
  EXPECT_EQ(bad, 8u);
  GloveReadings wild;
  wild.fill(NAN);
  Posture posture;
  setHandFromGlove(wild, Side::kLeft, posture);
  EXPECT_TRUE(limitViolations(posture).empty());
  wild.fill(1e9);
  setHandFromGlove(wild, Side::kLeft, posture);
  EXPECT_TRUE(limitViolations(posture).empty());
}

TEST(Glove, AnEighteenSensorGloveLacksTheOuterJoints) {
  std::vector<double> few(18);
  for (std::size_t i = 0; i < few.size(); ++i) few[i] = static_cast<double>(i);
  const auto all = gloveReadings(few);
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ((*all)[5], 5.0);    // index, middle joint
  EXPECT_EQ((*all)[6], 5.0);    // its outer joint follows
  EXPECT_EQ((*all)[7], 6.0);    // middle finger, knuckle
  EXPECT_EQ((*all)[21], 17.0);  // wrist yaw is the last of both
  EXPECT_FALSE(gloveReadings(std::vector<double>(20)).has_value());
}

}  // namespace
}  // namespace hapticell::mannequin
