// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/free_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kinematics/model/link_pose.h"
#include "mannequin/body/body_request_text.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::mannequin {
namespace {

const Figure& figure() {
  static const Figure made = *makeFigure(*parseBodyRequest("mannequin:male:50"));
  return made;
}

dvec3 tipOf(const kinematics::RobotModel& hand, const std::vector<double>& joints, const char* link) {
  const int at = hand.findLink(link);
  EXPECT_GE(at, 0) << link;
  return kinematics::linkPose(hand, joints, at) * dvec3(0.0);
}

TEST(FreeHand, StandsOpenAsTheHandOfTheWholeFigure) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto hand = freeHandModel(figure(), side);
    const auto body = figureModel(figure());
    ASSERT_TRUE(isFreeHand(*hand));
    EXPECT_FALSE(isFreeHand(*body));
    EXPECT_EQ(sideOf(*hand), side);
    const std::string prefix = side == Side::kLeft ? "l_" : "r_";
    const std::vector<double> open(kFreeHandJoints, 0.0);
    const std::vector<double> straight(body->dof(), 0.0);
    const Pose X_EH = kinematics::linkPose(*body, straight, body->findLink(prefix + "hand"));
    std::size_t dressed = 0;
    for (const kinematics::Link& link : hand->links) {
      if (link.collisions.empty()) continue;
      ++dressed;
      const int own = body->findLink(link.name);
      ASSERT_GE(own, 0) << link.name;
      const dvec3 p_HL = X_EH.inverse() * kinematics::linkPose(*body, straight, own).p;
      EXPECT_LT(glm::length(tipOf(*hand, open, link.name.c_str()) - p_HL), 1e-9) << link.name;
    }
    EXPECT_EQ(dressed, 16u);  // The hand and fifteen bones.
  }
}

TEST(FreeHand, BendsAsTheFigureCurlsItsFingers) {
  const auto hand = freeHandModel(figure(), Side::kRight);
  const auto body = figureModel(figure());
  std::vector<double> curled(body->dof(), 0.0), bent(kFreeHandJoints, 0.0);
  curled[indexOf(Dof::kRightFingersCurl)] = 0.6;
  for (std::size_t finger = 1; finger < 5; ++finger)
    for (std::size_t k = 1; k < 4; ++k) bent[4 * finger + k] = 0.6;
  const Pose X_EH = kinematics::linkPose(*body, curled, body->findLink("r_hand"));
  for (const char* tip : {"r_index3", "r_middle3", "r_ring3", "r_pinky3"}) {
    const dvec3 p_HT = X_EH.inverse() * kinematics::linkPose(*body, curled, body->findLink(tip)).p;
    EXPECT_LT(glm::length(tipOf(*hand, bent, tip) - p_HT), 1e-9) << tip;
  }
}

TEST(FreeHand, FingersSpreadAwayFromTheMiddleOne) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto hand = freeHandModel(figure(), side);
    const std::string prefix = side == Side::kLeft ? "l_" : "r_";
    std::vector<double> spread(kFreeHandJoints, 0.0);
    const std::vector<double> open = spread;
    for (const std::size_t finger : {1u, 3u, 4u}) spread[4 * finger] = 0.3;
    const auto gap = [&](const std::vector<double>& joints, const char* a, const char* b) {
      return glm::length(tipOf(*hand, joints, (prefix + a).c_str()) - tipOf(*hand, joints, (prefix + b).c_str()));
    };
    EXPECT_GT(gap(spread, "index3", "middle3"), gap(open, "index3", "middle3") + 0.01);
    EXPECT_GT(gap(spread, "ring3", "middle3"), gap(open, "ring3", "middle3") + 0.01);
    EXPECT_GT(gap(spread, "pinky3", "middle3"), gap(open, "pinky3", "middle3") + 0.01);
  }
}

TEST(FreeHand, TheThumbComesRoundBeforeThePalm) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto hand = freeHandModel(figure(), side);
    const std::string prefix = side == Side::kLeft ? "l_" : "r_";
    const auto tip = [&](const std::vector<double>& joints) {
      return tipOf(*hand, joints, (prefix + "thumb3").c_str());
    };
    const std::vector<double> open(kFreeHandJoints, 0.0);
    // The palm looks where the fingers bend to.
    std::vector<double> bent = open;
    bent[9] = 0.8;
    const std::string middle = prefix + "middle3";
    const double palm = tipOf(*hand, bent, middle.c_str()).y > tipOf(*hand, open, middle.c_str()).y ? 1.0 : -1.0;
    std::vector<double> rolled = open, under = open;
    rolled[1] = under[1] = 1.0;
    under[2] = under[3] = 0.9;
    EXPECT_GT(palm * tip(rolled).y, palm * tip(open).y + 0.02) << "it rolls to the palm's side";
    EXPECT_LT(tip(under).x, tip(rolled).x - 0.01) << "and bends across, to the little finger";
    EXPECT_GT(palm * tip(under).y, 0.01) << "before the palm, not through it";
    const dvec3 little = tipOf(*hand, open, (prefix + "pinky1").c_str());
    EXPECT_LT(glm::length(tip(under) - little), glm::length(tip(open) - little) - 0.01);
  }
}

TEST(FreeHand, TakesEachSensorToItsJointWithinItsLimits) {
  const auto hand = freeHandModel(figure(), Side::kLeft);
  GloveReadings angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = 0.01 * static_cast<double>(i);
  const std::vector<double> joints = freeHandFromGlove(angles, *hand);
  ASSERT_EQ(joints.size(), kFreeHandJoints);
  EXPECT_DOUBLE_EQ(joints[0], 0.03);   // Thumb abduction,
  EXPECT_DOUBLE_EQ(joints[3], 0.02);   // its outer joint,
  EXPECT_DOUBLE_EQ(joints[5], 0.04);   // the index finger's knuckle,
  EXPECT_DOUBLE_EQ(joints[19], 0.17);  // the little finger's last.
  EXPECT_DOUBLE_EQ(joints[16], 0.14 + 0.18);
  angles.fill(100.0);
  angles[4] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> bounded = freeHandFromGlove(angles, *hand);
  for (std::size_t i = 0; i < bounded.size(); ++i) {
    const auto& joint = hand->joints[static_cast<std::size_t>(hand->moving[i])];
    EXPECT_GE(bounded[i], joint.lower);
    EXPECT_LE(bounded[i], joint.upper);
  }
  EXPECT_EQ(bounded[5], 0.0);
}

}  // namespace
}  // namespace hapticell::mannequin
