// SPDX-License-Identifier: Apache-2.0
// Boxes along the axes, whose gaps are plain differences; and a robot, by the check of joint positions.
#include "planning/leaving.h"

#include <gtest/gtest.h>

#include "manipulation/checks/joint_check.h"
#include "planning/problem.h"
#include "planning/written_leaving.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

using manipulation::PreparedScene;
using Entities = std::vector<workcell::Entity>;

constexpr double kKept = 0.005;  ///< m: the clearance.

/// A bar (1) of 0.2 x 0.04 x 0.04 m, its under side `height` (m) above a plate (2).
Entities barOverPlate(double height) {
  return {test::loaded("box:0.2,0.04,0.04", 1, "bar", Pose::translation({0.0, 0.0, 0.02 + height})),
          test::loaded("box:1.0,1.0,0.1", 2, "plate", Pose::translation({0.0, 0.0, -0.05}))};
}

FreeSpace spaceOf(Entities entities) {
  auto space = FreeSpace::create(PreparedScene::prepare(std::move(entities), {}, {}), 1, {});
  EXPECT_TRUE(space);
  space->setClearance(kKept);
  return std::move(*space);
}

TEST(WayOut, LeavesAPlateStraightUp) {
  for (const double height : {0.0, 0.002, -8e-4}) {
    FreeSpace space = spaceOf(barOverPlate(height));
    const EntityConfiguration at = space.present();
    const auto end = wayOut(space, at);
    ASSERT_TRUE(end) << height;
    EXPECT_GT(end->X_WE.p.z - 0.02, kKept);
    EXPECT_LT(end->X_WE.p.z - 0.02, 2.0 * kKept) << "no farther than it has to";
    EXPECT_NEAR(end->X_WE.p.x, 0.0, 1e-3);
    EXPECT_NEAR(end->X_WE.p.y, 0.0, 1e-3);
    EXPECT_GT(std::abs(glm::dot(end->X_WE.q, at.X_WE.q)), 1.0 - 1e-9) << "without turning";
    EXPECT_TRUE(space.isFree(*end));
  }
}

TEST(WayOut, LeavesACornerObliquely) {
  Entities entities = barOverPlate(0.0);
  entities.push_back(test::loaded("box:0.02,1.0,0.3", 3, "wall", Pose::translation({0.11, 0.0, 0.15})));
  FreeSpace space = spaceOf(std::move(entities));
  const auto end = wayOut(space, space.present());
  ASSERT_TRUE(end);
  EXPECT_GT(end->X_WE.p.z - 0.02, kKept);
  EXPECT_LT(end->X_WE.p.x, -kKept);
  EXPECT_LT(glm::length(end->X_WE.p - dvec3(0.0, 0.0, 0.02)), LeavingRule::nearness(kKept));
  EXPECT_TRUE(space.isFree(*end));
}

TEST(WayOut, IsNoneBetweenTwoPlates) {
  Entities entities = barOverPlate(0.0);
  entities.push_back(test::loaded("box:1.0,1.0,0.1", 3, "ceiling", Pose::translation({0.0, 0.0, 0.041 + 0.05})));
  FreeSpace space = spaceOf(std::move(entities));
  EXPECT_FALSE(wayOut(space, space.present()));
  const std::string why = english(whyNoWayOut(space, space.present(), "at the start bar would touch plate"));
  EXPECT_TRUE(why.starts_with("at the start bar would touch plate, and no straight way of up to ")) << why;
}

TEST(WayOut, IsNoneFromTooDeep) {
  FreeSpace space = spaceOf(barOverPlate(-0.002));
  EXPECT_FALSE(wayOut(space, space.present()));
  const std::string why = english(whyNoWayOut(space, space.present(), "somewhere"));
  EXPECT_NE(why.find("bar is 2.0 mm deep in plate"), std::string::npos) << why;
  EXPECT_NE(why.find("move bar out of it"), std::string::npos) << why;
  FreeSpace away = spaceOf(barOverPlate(0.1));
  EXPECT_EQ(english(whyNoWayOut(away, away.present(), "somewhere")), "somewhere") << "nothing is near";
}

/// A table 4 mm under what the robot has lowest.
TEST(WayOut, TakesARobotsToolOff) {
  Entities entities{test::loaded("library:ur5e", 1, "robot", {})};
  workcell::Entity& robot = entities.front();
  robot.setJoints({0.6, -1.2, 1.2, -1.5, -1.5, 0.0});
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
  const dvec3 tip = X_BL[static_cast<std::size_t>(robot.robot()->defaultTip())].p;
  const auto tableAt = [&](double top) {
    Entities all = entities;
    all.push_back(test::loaded("box:0.3,0.3,0.02", 2, "table", Pose::translation({tip.x, tip.y, top - 0.01})));
    return PreparedScene::prepare(std::move(all), {}, {});
  };
  const auto gapOver = [&](double top) {
    auto check = manipulation::JointCheck::create(tableAt(top), 1, {});
    EXPECT_TRUE(check);
    return check->clearance(entities.front().joints(), 1.0);
  };
  const double low = tip.z - 0.3, top = low + gapOver(low) - 0.004;
  ASSERT_NEAR(gapOver(top), 0.004, 1e-6);
  const auto scene = tableAt(top);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space);
  space->setClearance(kKept);
  const EntityConfiguration at = space->present();
  ASSERT_FALSE(space->isFree(at));
  const auto end = wayOut(*space, at);
  ASSERT_TRUE(end);
  auto check = manipulation::JointCheck::create(scene, 1, {});
  EXPECT_GT(check->clearance(end->joints, 0.1), kKept);
  double best = 0.004;
  for (int k = 1; k <= 100; ++k) {
    const double gap = check->clearance(space->between(at, *end, 0.01 * k).joints, 0.1);
    EXPECT_GT(gap, best - LeavingRule::kMayClose) << k << ": it only opens";
    best = std::max(best, gap);
  }
  EXPECT_LE(space->pathBound(at, *end), LeavingRule::nearness(kKept));
}

/// A motion of the bar: places of its under side (mm above the plate) and along x (m), a second each.
trajectory::Trajectory barMotion(const std::vector<std::pair<double, double>>& places) {
  trajectory::Trajectory motion;
  motion.entity = "bar";
  for (const auto& [height_mm, x] : places) {
    trajectory::Trajectory::Frame frame;
    frame.t = static_cast<double>(motion.size());
    frame.X_WT = Pose::translation({x, 0.0, 0.02 + 1e-3 * height_mm});
    motion.addFrame(frame);
  }
  return motion;
}

Leaving leavingOf(const trajectory::Trajectory& motion, double from_mm) {
  Entities entities = barOverPlate(1e-3 * from_mm);
  entities.push_back(test::loaded("box:0.02,1.0,0.3", 3, "wall", Pose::translation({0.25, 0.0, 0.15})));
  const workcell::Entity bar = entities.front();
  const auto measured = measuredLeaving(motion, {}, PreparedScene::prepare(std::move(entities), {}, {}), bar, {kKept, 0.05}, {});
  EXPECT_TRUE(measured) << measured.error().message();
  return measured ? *measured : Leaving();
}

TEST(MeasuredLeaving, FindsWhereContactsAreLeftAndReached) {
  // Down by 0.4 mm again at 3 s; the wall, at x = 0.24 m, is 7 mm away at 8 s.
  const Leaving leaving = leavingOf(barMotion({{0, 0}, {0.5, 0}, {1, 0}, {0.6, 0}, {2, 0}, {4, 0}, {5.5, 0}, {20, 0.1},
                                               {20, 0.133}, {20, 0.1}, {6, 0}, {3, 0}, {1, 0}, {0, 0}}),
                                    0.0);
  ASSERT_EQ(leaving.tight.size(), 2u);
  const TightPair &left = leaving.tight[0], &reached = leaving.tight[1];
  for (const TightPair& pair : leaving.tight) {
    EXPECT_EQ(pair.moved + " " + pair.met, "bar plate");
    EXPECT_NEAR(pair.gap, 0.0, 1e-5);
  }
  EXPECT_FALSE(left.is_reached);
  EXPECT_EQ(left.t, 6.0);
  EXPECT_TRUE(reached.is_reached);
  EXPECT_EQ(reached.t, 10.0);
  EXPECT_NEAR(leaving.least, 5.5e-3, 1e-9) << "of what is neither being left nor reached";
  EXPECT_EQ(leaving.t_least, 6.0);
  EXPECT_NEAR(leaving.closing, 4e-4, 1e-5);
  EXPECT_EQ(english(leaving.where_closing), "bar and plate");
  EXPECT_NEAR(leaving.deepest, 0.0, 1e-5);
}

TEST(MeasuredLeaving, MeasuresDepthsAndWhatIsMetOnTheWay) {
  const Leaving leaving = leavingOf(barMotion({{-0.8, 0}, {-0.3, 0}, {2, 0}, {8, 0}, {20, 0.1}, {20, 0.137}, {20, 0.1}}), -0.8);
  ASSERT_EQ(leaving.tight.size(), 1u);
  EXPECT_EQ(leaving.tight[0].t, 3.0);
  EXPECT_NEAR(leaving.tight[0].gap, -8e-4, 2e-6);
  EXPECT_NEAR(leaving.deepest, 8e-4, 2e-6);
  EXPECT_EQ(english(leaving.where_deepest), "bar and plate");
  EXPECT_NEAR(leaving.closing, 0.0, 2e-6);
  EXPECT_NEAR(leaving.least, 3e-3, 1e-9) << "the wall, which is no contact of an end";
  EXPECT_EQ(leaving.t_least, 5.0);
  const Leaving again = leavingOf(barMotion({{0, 0}, {8, 0}, {1, 0}, {8, 0}}), 0.0);
  EXPECT_NEAR(again.least, 1e-3, 1e-9) << "what has been left keeps the clearance";
  EXPECT_EQ(again.t_least, 2.0);
}

TEST(MeasuredLeaving, OfARobotIsThatOfTheJointCheck) {
  const auto scene = test::robotCell();
  const workcell::Entity& robot = *scene->find(1);
  auto check = manipulation::JointCheck::create(scene, 1, {}, manipulation::RestContacts::kLeaveOutLasting);
  ASSERT_TRUE(check);
  trajectory::Trajectory motion;
  motion.entity = "robot";
  motion.joint_names = {"1", "2", "3", "4", "5", "6"};
  double least = 0.2, t_least = 0.0;
  for (int k = 0; k <= 40; ++k) {
    std::vector<double> joints = robot.joints();
    joints[0] -= 0.005 * k;
    joints[1] += 0.1 * std::sin(0.1 * k);
    motion.addFrame({.t = 0.1 * k, .X_WT = {}}, joints);
    const double gap = check->clearance(joints, 0.2);
    if (gap < least) t_least = 0.1 * k;
    least = std::min(least, gap);
  }
  const auto measured = measuredLeaving(motion, {0, 1, 2, 3, 4, 5}, scene, robot, {1e-3, 0.2}, {});
  ASSERT_TRUE(measured) << measured.error().message();
  EXPECT_TRUE(measured->tight.empty());
  EXPECT_LT(least, 0.2);
  EXPECT_GT(least, 1e-3);
  EXPECT_NEAR(measured->least, least, 1e-9);
  EXPECT_EQ(measured->t_least, t_least);
  workcell::Entity unknown = robot;
  unknown.id = 99;
  EXPECT_FALSE(measuredLeaving(motion, {0, 1, 2, 3, 4, 5}, scene, unknown, {1e-3, 0.2}, {}));
}

}  // namespace
}  // namespace hapticell::planning
