// SPDX-License-Identifier: Apache-2.0
#include "planning/standing_figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/system/scratch_folder.h"
#include "manipulation/checks/motion_replay.h"
#include "mannequin/shape/figure_model.h"
#include "planning/plan.h"
#include "planning/space_plan.h"
#include "planning/timed_plan.h"
#include "planning/written_plan.h"
#include "tests/planning/planning_cells.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::planning {
namespace {

using mannequin::Side;
using test::gripOf;
using test::linkPose;

/// A standing worker (1) on a floor (2), before a bench (3) that is in the way of a hand that goes up.
const std::shared_ptr<const manipulation::PreparedScene>& workerCell() {
  static const auto scene = [] {
    std::vector<workcell::Entity> entities{
        test::loaded("mannequin:female:50", 1, "worker", {}),
        test::loaded("box:3.0,3.0,0.1", 2, "floor", Pose::translation({0.0, 0.0, -0.05})),
        test::loaded("box:0.75,1.5,0.04", 3, "bench", Pose::translation({0.62, 0.0, 0.93}))};
    return manipulation::PreparedScene::prepare(std::move(entities), {}, {});
  }();
  return scene;
}

Problem problemTo(const Pose& X_WG, Side hand = Side::kRight) {
  Problem problem;
  problem.scene = workerCell();
  problem.entity = 1;
  problem.hand = hand;
  problem.goal = goal::ToPose{X_WG};
  problem.leaves_contact = true;
  problem.time_limit_s = 1000.0;
  return problem;
}

void expectOnItsFeet(const workcell::Entity& worker, const EntityConfiguration& at, double most) {
  const EntityConfiguration stands{worker.X_WE, worker.joints()};
  for (const char* foot : {"l_hindfoot", "r_hindfoot"}) {
    const Twist off = difference(linkPose(worker, at, foot), linkPose(worker, stands, foot));
    EXPECT_LT(glm::length(off.linear) + 0.1 * glm::length(off.angular), most) << foot;
  }
}

/// Bent forward to something low: the pelvis moves too.
Pose lowPlace(const workcell::Entity& worker) {
  Pose X_WG = gripOf(worker, {worker.X_WE, worker.joints()});
  X_WG.p += dvec3(0.25, 0.0, -0.35);
  return X_WG;
}

TEST(StandingFigure, BringsTheGripExactlyToAPoseOnItsFeet) {
  const auto scene = workerCell();
  const workcell::Entity& worker = *scene->find(1);
  const auto space = FreeSpace::create(scene, 1, {}, {}, Side::kRight);
  ASSERT_TRUE(space) << space.error().message();
  ASSERT_NE(space->figure(), nullptr);
  EXPECT_FALSE(space->figure()->pelvisStays()) << english(space->note());
  const Pose X_WG = lowPlace(worker);
  const auto postures = space->posturesAt(X_WG, space->present());
  ASSERT_FALSE(postures.empty());
  for (const EntityConfiguration& at : postures) {
    EXPECT_LT(glm::length(gripOf(worker, at).p - X_WG.p), 1e-6);
    expectOnItsFeet(worker, at, 1e-5);
  }
  // At places between the knots of a crouch, by straight motions of all joints.
  StandingFigure::Numbers low = space->figure()->numbersOf(space->present());
  low[0] -= 0.02;
  low[2] -= 0.03;
  const auto knots = space->figure()->knots(space->present(), space->figure()->configurationOf(low));
  ASSERT_GT(knots.size(), 3u);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    expectOnItsFeet(worker, knots[i], 1e-5);
    for (const double s : {0.25, 0.5, 0.75}) {
      const auto a = mannequin::toPosture(*worker.figure(), {knots[i - 1].X_WE, knots[i - 1].joints});
      const auto b = mannequin::toPosture(*worker.figure(), {knots[i].X_WE, knots[i].joints});
      const auto between = mannequin::toModel(*worker.figure(), mannequin::interpolate(a, b, s));
      expectOnItsFeet(worker, {between.X_WE, between.joints}, 2e-4);
    }
  }
}

TEST(SpacePlan, LeavesOutOnlyWhatStands) {
  const auto made = SpacePlan::create(workerCell(), 1, {}, {}, {.hand = Side::kLeft});
  ASSERT_TRUE(made) << made.error().message();
  const SpacePlan& plan = **made;
  std::size_t calves = 0;
  for (const CheckedPair& pair : plan.pairs()) {
    EXPECT_EQ(pair.words.moved.find("hindfoot"), std::string::npos) << pair.words.moved;
    EXPECT_EQ(pair.words.moved.find("forefoot"), std::string::npos) << pair.words.moved;
    if (pair.words.moved.find("calf") != std::string::npos && pair.words.met == "floor") ++calves;
  }
  EXPECT_EQ(calves, 2u);
  EXPECT_EQ(plan.obstacles().size(), 2u);
  EXPECT_FALSE(plan.ownPairs().empty()) << "its hands with its own body";
  EXPECT_EQ(english(plan.note()), "worker stands on floor: these feet are not checked against it");
}

TEST(StandingFigure, TellsWhatDoesNotStand) {
  const auto scene = workerCell();
  const workcell::Entity& worker = *scene->find(1);
  const auto space = FreeSpace::create(scene, 1, {}, {}, Side::kLeft);
  ASSERT_TRUE(space);
  const StandingFigure& figure = *space->figure();
  EXPECT_TRUE(figure.stands(space->present()));
  EntityConfiguration at = space->present();
  at.X_WE.p.x += 0.01;
  EXPECT_FALSE(figure.stands(at)) << "its feet have left their places";
  StandingFigure::Numbers numbers = figure.numbersOf(space->present());
  numbers[0] += 0.3;
  numbers[2] -= 0.1;
  EXPECT_FALSE(figure.stands(figure.configurationOf(numbers))) << "it falls forward";
  numbers = figure.numbersOf(space->present());
  numbers[StandingFigure::kArm + 5] = -0.5;
  EXPECT_FALSE(figure.stands(figure.configurationOf(numbers))) << "an elbow bent backwards";
  numbers = figure.numbersOf(space->present());
  numbers[2] -= 0.03;
  const EntityConfiguration crouched = figure.configurationOf(numbers);
  expectOnItsFeet(worker, crouched, 1e-5);
  EXPECT_NEAR(figure.numbersOf(crouched)[2], numbers[2], 1e-9);
}

TEST(Plan, LeadsAHandOverABenchAndTheFileKeepsIt) {
  Problem problem = problemTo({});
  const workcell::Entity& worker = *problem.scene->find(1);
  const Pose X_WG{{0.37, -0.25, 1.2}, dquat(std::sqrt(0.5), 0.0, -std::sqrt(0.5), 0.0)};  // Fingers ahead, thumb up.
  problem.goal = goal::ToPose{X_WG};
  const auto space = FreeSpace::create(problem.scene, 1, {}, {}, problem.hand);
  ASSERT_TRUE(space);
  const auto result = plan(problem, *space);
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_TRUE(result->isSolved()) << english(result->failure->reason);
  EXPECT_NE(result->planner, "straight");
  const auto motion = timedMotion(*result->plan, *space);
  ASSERT_TRUE(motion) << motion.error().message();
  EXPECT_EQ(motion->moved, "whole");
  const auto folder = ScratchFolder::make();
  const auto file = folder->path() / "hand.htraj";
  ASSERT_TRUE(workcell::writeFileAtomically(file, trajectory::toJsonText(*motion)));
  const auto promises = writtenPlanPromises(file, *result->plan, problem.clearance, problem.scene, 1);
  ASSERT_TRUE(promises) << promises.error().message();
  EXPECT_TRUE(promises->areKept()) << promises->missed("plan").message();
  for (const char* name : {"clearance", "contacts", "limits", "feet", "balance", "pose"}) {
    EXPECT_TRUE(std::any_of(promises->list.begin(), promises->list.end(), [&](const Promise& one) {
      return one.name == name;
    })) << name;
  }
  // What plays the motion brings the hand there.
  const auto replay = manipulation::MotionReplay::create({std::make_shared<const workcell::Entity>(worker)}, "worker",
                                                         std::make_shared<const trajectory::Trajectory>(*motion));
  ASSERT_TRUE(replay) << replay.error().message();
  const EntityConfiguration end = replay->at(motion->duration());
  EXPECT_LT(glm::length(gripOf(worker, end).p - X_WG.p), 1e-4);
  expectOnItsFeet(worker, end, 1e-4);
  // A foot that slides by 2 mm, a hand that stops short: both are found on the file.
  for (const bool slides : {true, false}) {
    trajectory::Trajectory spoilt = motion->emptyCopy();
    for (std::size_t i = 0; i < motion->size(); ++i) {
      trajectory::Trajectory::Frame frame = (*motion)[i];
      if (slides) frame.X_WT.p.y += 2e-3;
      if (!slides && i + 1 == motion->size()) break;
      spoilt.addFrame(frame, motion->joints(i));
      if (!slides && i + 60 > motion->size()) break;
    }
    ASSERT_TRUE(workcell::writeFileAtomically(file, trajectory::toJsonText(spoilt)));
    const auto missed = writtenPlanPromises(file, *result->plan, problem.clearance, problem.scene, 1);
    ASSERT_TRUE(missed);
    for (const Promise& one : missed->list) {
      if (one.name != (slides ? "feet" : "pose")) continue;
      EXPECT_FALSE(one.isKept()) << one.measured;
    }
  }
}

TEST(Plan, ExplainsWhatAHandDoesNotReach) {
  const auto result = plan(problemTo({{1.6, -0.25, 1.3}, dquat(std::sqrt(0.5), 0.0, -std::sqrt(0.5), 0.0)}));
  ASSERT_TRUE(result) << result.error().message();
  ASSERT_FALSE(result->isSolved());
  EXPECT_EQ(result->failure->kind, Failure::Kind::kReach);
  const std::string why = english(result->failure->reason);
  EXPECT_NE(why.find("right hand of worker"), std::string::npos) << why;
  ASSERT_TRUE(result->failure->nearest) << why;
  EXPECT_GT(result->failure->nearest_distance, 0.3);
  const workcell::Entity& worker = *workerCell()->find(1);
  EXPECT_GT(glm::length(result->failure->X_WT_nearest->p - gripOf(worker, {worker.X_WE, worker.joints()}).p), 0.05);
}

TEST(Plan, AsksWhichHandAndRefusesHandsOfOthers) {
  Problem problem = problemTo({});
  problem.hand.reset();
  const auto without = plan(problem);
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message().find("hand"), std::string::npos);
  problem.hand = Side::kLeft;
  problem.entity = 3;
  EXPECT_FALSE(plan(problem));
  problem.entity = 1;
  problem.goal = goal::OutOfCell{};
  EXPECT_FALSE(plan(problem));
}

}  // namespace
}  // namespace hapticell::planning
