// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/path_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision/queries/proximity_query.h"
#include "manipulation/checks/collision_track.h"
#include "manipulation/checks/joint_track.h"
#include "manipulation/checks/path_finding.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using test::solid;
using trajectory::Trajectory;

/// A thin wall across x = 0 and a small box to be moved through it.
std::shared_ptr<const PreparedScene> wallAndBox() {
  return PreparedScene::prepare({solid(1, "wall", geometry::makeBox({0.001, 1.0, 1.0})),
                                 solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({-0.3, 0, 0}))},
                                {}, {});
}

Trajectory along(const std::vector<std::pair<double, dvec3>>& points) {
  Trajectory trajectory;
  for (const auto& [t, p] : points) trajectory.addFrame({t, Pose::translation(p)});
  return trajectory;
}

TEST(PathCheck, FindsAThinWallBetweenTwoFramesWithItsTime) {
  const auto result =
      checkPath(wallAndBox(), "box", along({{0.0, {-0.3, 0, 0}}, {1.0, {0.3, 0, 0}}, {2.0, {0.5, 0, 0}}}), {}, {});
  ASSERT_TRUE(result.has_value()) << result.error().message();
  ASSERT_EQ(result->findings.size(), 1u);
  const PathFinding& found = result->findings.front();
  EXPECT_EQ(found.kind, PathFinding::Kind::kCollision);
  EXPECT_EQ(found.first, "box");
  EXPECT_EQ(found.second, "wall");
  // The box's front, 10 mm before its middle, meets the wall's face at -0.5 mm.
  EXPECT_NEAR(found.t_in, (0.3 - 0.0105) / 0.6, 1e-3);
  EXPECT_NEAR(found.p_W.x, -0.0005, 1e-4);
}

TEST(PathCheck, AFreePathIsFreeAndItsClearanceIsTheLeastAtItsFrames) {
  const auto result = checkPath(wallAndBox(), "box",
                                along({{0.0, {-0.3, 0, 0}}, {1.0, {-0.0305, 0, 0}}, {2.0, {-0.2, 0.1, 0}}}), {}, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->findings.empty());
  EXPECT_NEAR(result->least_clearance, 0.02, 1e-9);
  EXPECT_EQ(result->t_nearest, 1.0);
  EXPECT_EQ(result->nearest_second, "wall");
}

TEST(PathCheck, WhatTouchesAtTheStartIsToldApart) {
  const auto scene =
      PreparedScene::prepare({solid(1, "table", geometry::makeBox({1.0, 1.0, 0.1}), Pose::translation({0, 0, -0.05})),
                              solid(2, "box", geometry::makeBox(dvec3(0.06)), Pose::translation({0, 0, 0.03}))},
                             {}, {});
  const auto result =
      checkPath(scene, "box", along({{0.0, {0, 0, 0.03}}, {1.0, {0, 0, 0.2}}, {2.0, {0, 0, 0.02}}}), {}, {});
  ASSERT_TRUE(result.has_value());
  ASSERT_EQ(result->touching_at_start.size(), 1u);
  EXPECT_EQ(result->touching_at_start.front().t_in, 0.0);
  ASSERT_EQ(result->findings.size(), 1u);  // and again when it comes back
  EXPECT_NEAR(result->findings.front().t_in, 1.0 + 0.17 / 0.18, 1e-3);
}

TEST(PathCheck, EveryPairOfAStepIsFound) {
  const auto scene =
      PreparedScene::prepare({solid(1, "left", geometry::makeBox({0.001, 1.0, 1.0})),
                              solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({-0.3, 0, 0})),
                              solid(3, "right", geometry::makeBox({0.001, 1.0, 1.0}), Pose::translation({0.1, 0, 0}))},
                             {}, {});
  const auto result = checkPath(scene, "box", along({{0.0, {-0.3, 0, 0}}, {1.0, {0.3, 0, 0}}}), {}, {});
  ASSERT_TRUE(result.has_value());
  ASSERT_EQ(result->findings.size(), 2u);
  EXPECT_EQ(result->findings[0].second, "left");
  EXPECT_EQ(result->findings[1].second, "right");
}

/// Against a brute force: the same path in 10 000 small steps, each asked for a collision.
TEST(PathCheck, MissesNothingThatTenThousandStepsFind) {
  const auto scene =
      PreparedScene::prepare({solid(1, "post", geometry::makeCylinder(0.01, 1.0, 24)),
                              solid(2, "bar", geometry::makeBox({0.3, 0.01, 0.01}), Pose::translation({-0.4, 0, 0}))},
                             {}, {});
  Trajectory trajectory;
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    trajectory.addFrame({t, Pose{{0.25 * std::cos(3.0 * t), 0.1 * std::sin(t), 0.0},
                                 quaternionFromRotationVector({0.0, 0.0, 2.0 * t})}});
  }
  const auto result = checkPath(scene, "bar", trajectory, {}, {});
  ASSERT_TRUE(result.has_value());
  collision::ProximityQuery query(scene->parts()[1].mesh.collider, scene->parts()[0].mesh.collider);
  int hits = 0;
  for (int i = 0; i <= 10000; ++i) {
    const double t = 2.0 * i / 10000.0;
    if (!query.collides(trajectory.poseAt(t), Pose::identity())) continue;
    ++hits;
    bool is_found = false;
    for (const auto& finding : result->findings)
      is_found = is_found || (finding.t_in <= t + 1e-3 && t <= finding.t_out + 1e-9);
    EXPECT_TRUE(is_found) << "at " << t;
  }
  EXPECT_GT(hits, 100);
}

workcell::Entity slide() {
  auto model = std::make_shared<kinematics::RobotModel>();
  model->name = "slide";
  model->links = {{"base", -1, {}, {}}, {"carriage", 0, {}, {}}};
  kinematics::Joint joint;
  joint.name = "x";
  joint.type = kinematics::JointType::kPrismatic;
  joint.parent_link = 0;
  joint.child_link = 1;
  joint.axis_J = {1, 0, 0};
  joint.lower = 0.0;
  joint.upper = 0.5;
  joint.velocity = 1.0;
  joint.variable = 0;
  model->joints = {joint};
  model->moving = {0};
  workcell::Entity entity;
  entity.id = 1;
  entity.name = "slide";
  entity.body = workcell::Robot{{.model = model, .joints = {0.0}, .tip_link = "carriage"}};
  return entity;
}

TEST(FindingList, KeepsOneIntervalAsLongAsItGoesOn) {
  FindingList list;
  PathCheckResult result;
  for (const auto& [t, worst] : {std::pair(0.0, 0.1), std::pair(1.0, 0.3), std::pair(2.0, 0.2)}) {
    list.add(PathFinding::Kind::kJointLimit, "a1", t, worst);
    list.endFrame(result);
    EXPECT_TRUE(result.findings.empty());
  }
  list.endFrame(result);  // A frame without it.
  list.add(PathFinding::Kind::kJointLimit, "a1", 4.0, 0.05);
  list.endFrame(result);
  list.endFrame(result);
  ASSERT_EQ(result.findings.size(), 2u);
  EXPECT_EQ(result.findings[0].t_in, 0.0);
  EXPECT_EQ(result.findings[0].t_out, 2.0);
  EXPECT_EQ(result.findings[0].worst, 0.3);
  EXPECT_EQ(result.findings[1].t_in, 4.0);
}

TEST(JointTrack, ALimitIsFoundBeyondItOnly) {
  const workcell::Entity robot = slide();
  JointTrack track(robot);
  FindingList list;
  PathCheckResult result;
  track.look({Pose(), {0.5}}, nullptr, 0.0, 0.1, list);
  list.endFrame(result);
  const EntityConfiguration before{Pose(), {0.5}};
  track.look({Pose(), {0.52}}, &before, 0.1, 0.1, list);  // 0.2 m/s, of 1.
  list.endFrame(result);
  list.endFrame(result);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_STREQ(toString(result.findings[0].kind), "joint_limit");
  EXPECT_EQ(result.findings[0].t_in, 0.1);
  EXPECT_NEAR(result.findings[0].worst, 0.02, 1e-12);
}

TEST(CollisionTrack, FollowsAPairFromItsBeginToItsEnd) {
  const auto held = HeldEntity::take(wallAndBox(), 2, {}, {}, {});
  ASSERT_TRUE(held) << held.error().message();
  const MeetingBodies bodies(**held);
  ASSERT_EQ(bodies.pairs.size(), 1u);
  EXPECT_TRUE(bodies.pairs[0].blocks);
  EXPECT_EQ(bodies.first(0), "box");
  EXPECT_EQ(bodies.second(0), "wall");
  CollisionTrack track(bodies, (*held)->manipulator(), 0.05);
  PathCheckResult result;
  result.least_clearance = 1.0;
  const auto at = [](double x) { return EntityConfiguration{Pose::translation({x, 0, 0}), {}}; };
  track.start(at(-0.0305), 0.0, result);
  EXPECT_NEAR(result.least_clearance, 0.02, 1e-9) << "20 mm from face to face";
  EXPECT_EQ(result.nearest_second, "wall");
  track.step(at(-0.0305), at(0.0), 0.0, 1.0, result);
  EXPECT_TRUE(result.findings.empty()) << "it goes on";
  track.step(at(0.0), at(0.3), 1.0, 2.0, result);
  track.finish(result);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_NEAR(result.findings[0].t_in, 0.02 / 0.0305, 1e-3);
  EXPECT_EQ(result.findings[0].t_out, 2.0);
}

TEST(PathCheck, NamesJointsBeyondTheirEndsAndSpeeds) {
  Trajectory trajectory;
  trajectory.joint_names = {"x"};
  const std::pair<double, double> frames[] = {{0.0, 0.0}, {1.0, 0.3}, {1.1, 0.6}, {2.0, 0.4}};
  for (const auto& [t, x] : frames) trajectory.addFrame({t, Pose::translation({x, 0, 0})}, std::span(&x, 1));
  const auto result = checkPath(PreparedScene::prepare({slide()}, {}, {}), "slide", trajectory, {}, {});
  ASSERT_TRUE(result.has_value()) << result.error().message();
  ASSERT_EQ(result->findings.size(), 2u);
  for (const PathFinding& finding : result->findings) {
    EXPECT_EQ(finding.first, "x");
    EXPECT_EQ(finding.t_in, 1.1);
    EXPECT_NEAR(finding.worst, finding.kind == PathFinding::Kind::kJointLimit ? 0.1 : 2.0, 1e-9);
  }
  trajectory.joint_names = {"y"};
  EXPECT_FALSE(checkPath(PreparedScene::prepare({slide()}, {}, {}), "slide", trajectory, {}, {}).has_value());
  EXPECT_FALSE(checkPath(PreparedScene::prepare({slide()}, {}, {}), "other", trajectory, {}, {}).has_value());
}

kinematics::LinkShape boxShape(const dvec3& size, const dvec3& p_L) {
  kinematics::LinkShape shape;
  shape.mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size));
  shape.X_LS = Pose::translation(p_L);
  return shape;
}

/// A carriage of 0.1 m that slides along x between 0 and 0.5 m, a stop of 0.02 m on its base at x = -0.3; a gripper
/// hangs on the carriage, 0.4 m above it, and a part on the gripper, 0.2 m before it. A post stands where only the part
/// comes.
std::vector<workcell::Entity> carryingCell() {
  workcell::Entity robot = slide();
  auto model = std::make_shared<kinematics::RobotModel>(*robot.robot());
  model->links[0].collisions = {boxShape(dvec3(0.02), {-0.3, 0.0, 0.4})};
  model->links[1].collisions = {boxShape(dvec3(0.1), dvec3(0.0))};
  robot.editJointed().model = model;
  workcell::Entity gripper =
      solid(2, "gripper", geometry::makeBox({0.1, 0.1, 0.75}), Pose::translation({0.0, 0.0, 0.4}));
  gripper.attachment = {"slide", "carriage", gripper.X_WE};  // It reaches into the carriage it is screwed to.
  workcell::Entity part = solid(3, "part", geometry::makeBox(dvec3(0.04)), Pose::translation({-0.2, 0.0, 0.4}));
  part.attachment = {"gripper", "", gripper.X_WE.inverse() * part.X_WE};
  return {robot, gripper, part,
          solid(4, "post", geometry::makeBox({0.01, 0.01, 0.2}), Pose::translation({0.1, 0.0, 0.4}))};
}

Trajectory sliding(const std::vector<std::pair<double, double>>& frames) {
  Trajectory trajectory;
  trajectory.joint_names = {"x"};
  for (const auto& [t, x] : frames) trajectory.addFrame({t, Pose::translation({x, 0, 0})}, std::span(&x, 1));
  return trajectory;
}

TEST(PathCheck, WhatARobotCarriesAndWhatHangsOnThatIsCheckedAgainstTheCell) {
  const auto result = checkPath(PreparedScene::prepare(carryingCell(), {}, {}), "slide",
                                sliding({{0.0, 0.0}, {1.0, 0.2}, {2.0, 0.4}}), {}, {});
  ASSERT_TRUE(result.has_value()) << result.error().message();
  ASSERT_EQ(result->findings.size(), 2u) << "the gripper, then the part on it; each against the post alone";
  EXPECT_EQ(result->findings[0].first, "gripper");
  EXPECT_EQ(result->findings[1].first, "part");
  for (const PathFinding& finding : result->findings) EXPECT_EQ(finding.second, "post");
  EXPECT_NEAR(result->findings[0].t_in, (0.095 - 0.05) / 0.2, 1e-3)
      << "its front is at 50 mm, the post's face at 95 mm";
  EXPECT_NEAR(result->findings[1].t_in, (0.095 + 0.18) / 0.2, 1e-3);
  EXPECT_TRUE(result->touching_at_start.empty()) << "the gripper reaches into its own link, and that is no contact";
}

TEST(PathCheck, AFrameBetweenTheRobotAndWhatItCarriesChangesNothing) {
  auto cell = carryingCell();
  workcell::Entity frame = workcell::makeFrame("flange", Pose::translation({0.05, 0.1, 0.4}));
  frame.id = 9;
  frame.attachment = {"slide", "carriage", frame.X_WE};
  cell[1].attachment = {"flange", "", frame.X_WE.inverse() * cell[1].X_WE};
  cell.push_back(frame);
  const auto motion = sliding({{0.0, 0.0}, {1.0, 0.2}, {2.0, 0.4}});
  const auto plain = checkPath(PreparedScene::prepare(carryingCell(), {}, {}), "slide", motion, {}, {});
  const auto framed = checkPath(PreparedScene::prepare(cell, {}, {}), "slide", motion, {}, {});
  ASSERT_TRUE(plain && framed);
  ASSERT_EQ(framed->findings.size(), plain->findings.size());
  for (std::size_t k = 0; k < plain->findings.size(); ++k) {
    EXPECT_EQ(framed->findings[k].first, plain->findings[k].first);
    EXPECT_NEAR(framed->findings[k].t_in, plain->findings[k].t_in, 1e-9);
  }
}

TEST(PathCheck, WhatARobotCarriesIsCheckedAgainstItsOtherLinks) {
  auto cell = carryingCell();
  cell.pop_back();  // Without the post.
  workcell::Entity& part = cell[2];
  part.X_WE = Pose::translation({-0.2, 0.0, 0.4});
  const auto free = checkPath(PreparedScene::prepare(cell, {}, {}), "slide", sliding({{0.0, 0.0}, {1.0, 0.5}}), {}, {});
  ASSERT_TRUE(free && free->findings.empty());
  EXPECT_TRUE(std::isinf(free->least_clearance)) << "nothing stands in the cell";
  auto model = std::make_shared<kinematics::RobotModel>(*cell[0].robot());
  model->joints[0].lower = -0.5;
  cell[0].editJointed().model = model;
  const auto met = checkPath(PreparedScene::prepare(cell, {}, {}), "slide", sliding({{0.0, 0.0}, {1.0, -0.2}}), {}, {});
  ASSERT_TRUE(met && !met->findings.empty());
  EXPECT_EQ(met->findings[0].first, "part");
  EXPECT_EQ(met->findings[0].second, "slide/base");
  EXPECT_NEAR(met->findings[0].t_in, (0.29 - 0.22) / 0.2, 1e-3) << "its back is at -220 mm, the stop's face at -290 mm";
  const std::vector<workcell::PairRule> off{{.first = "slide", .second = "part", .checked = false}};
  const auto silent = checkPath(PreparedScene::prepare(cell, workcell::PairPolicy({}, off), {}), "slide",
                                sliding({{0.0, 0.0}, {1.0, -0.2}}), {}, {});
  ASSERT_TRUE(silent && silent->findings.empty()) << "the user's rule counts for a robot's own links too";
}

TEST(PathCheck, APairThatTheUserLeavesOutIsPassedThrough) {
  const std::vector<workcell::PairRule> rules{{.first = "wall", .second = "box", .checked = false}};
  const auto scene =
      PreparedScene::prepare({solid(1, "wall", geometry::makeBox({0.001, 1.0, 1.0})),
                              solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({-0.3, 0, 0}))},
                             workcell::PairPolicy({}, rules), {});
  const auto result = checkPath(scene, "box", along({{0.0, {-0.3, 0, 0}}, {1.0, {0.3, 0, 0}}}), {}, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->findings.empty());
}

}  // namespace
}  // namespace hapticell::manipulation
