// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_manipulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mannequin/shape/figure_model.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using Hands = MannequinManipulator::Hands;

workcell::Entity mannequinEntity(const char* posture, const char* body = "mannequin:male:50") {
  workcell::EntityLoader loader(".");
  Diagnostics diagnostics;
  workcell::Entity entity = *loader.load(body, 1.0, diagnostics);
  entity.id = 7;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), posture));
  entity.X_WE = model.X_WE;
  entity.setJoints(model.joints);
  return entity;
}

MannequinManipulator manipulatorOf(const workcell::Entity& entity, Hands hands, bool lock_trunk,
                                   std::vector<int>& links) {
  links.clear();
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i) {
    if (!entity.robot()->links[i].collisions.empty()) links.push_back(static_cast<int>(i));
  }
  std::vector<MannequinManipulator::Part> parts;
  for (const int link : links) parts.push_back({link, {}});
  return {entity.figure(), entity.robot(), hands, {lock_trunk, false}, {entity.X_WE, entity.joints()}, parts};
}

TEST(MannequinManipulator, TheGripFollowsAndTheBodyKeepsItsFeet) {
  const workcell::Entity entity = mannequinEntity("both_hands_forward");
  std::vector<int> links;
  for (const Hands hands : {Hands::kLeft, Hands::kRight, Hands::kBoth}) {
    const MannequinManipulator manipulator = manipulatorOf(entity, hands, false, links);
    const EntityConfiguration start{entity.X_WE, entity.joints()};
    Pose wanted = manipulator.movedFrame(start);
    wanted.p += dvec3(0.02, 0.01, -0.03);
    const EntityConfiguration moved = manipulator.propose(start, wanted, 1.0);
    EXPECT_LT(test::placeError(manipulator.movedFrame(moved), wanted), 1e-4);
    std::vector<Pose> before(links.size()), after(links.size());
    manipulator.partPoses(start, before);
    manipulator.partPoses(moved, after);
    for (std::size_t k = 0; k < links.size(); ++k) {
      const std::string& name = entity.robot()->links[static_cast<std::size_t>(links[k])].name;
      if (name.find("foot") != std::string::npos) {
        EXPECT_LT(glm::length(before[k].p - after[k].p), 3e-4) << name;
      }
    }
  }
}

TEST(MannequinManipulator, NoPointMovesFartherThanItsBound) {
  const workcell::Entity entity = mannequinEntity("reaching");
  std::vector<int> links;
  const MannequinManipulator manipulator = manipulatorOf(entity, Hands::kRight, false, links);
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  Pose wanted = manipulator.movedFrame(start);
  wanted.p += dvec3(-0.05, 0.04, 0.06);
  const EntityConfiguration end = manipulator.propose(start, wanted, 1.0);
  std::vector<PartSphere> spheres(links.size(), {dvec3(0.0, 0.0, -0.05), 0.05});
  std::vector<double> bounds(links.size());
  manipulator.pathBounds(start, end, spheres, bounds);
  std::vector<double> paths(links.size(), 0.0);
  std::vector<Pose> last(links.size()), now(links.size());
  manipulator.partPoses(start, last);
  constexpr int kSteps = 50;
  for (int i = 1; i <= kSteps; ++i) {
    manipulator.partPoses(manipulator.between(start, end, static_cast<double>(i) / kSteps), now);
    for (std::size_t k = 0; k < links.size(); ++k) {
      const dvec3 point(0.03, 0.0, -0.09);
      paths[k] += glm::length(now[k] * point - last[k] * point);
    }
    last = now;
  }
  for (std::size_t k = 0; k < links.size(); ++k) EXPECT_LE(paths[k], bounds[k] + 1e-9) << k;
  manipulator.partPoses(end, last);
  for (std::size_t k = 0; k < links.size(); ++k) EXPECT_LT(glm::length(last[k].p - now[k].p), 1e-9);
}

TEST(MannequinManipulator, TheEndOfTheReachIsALimitAndNamesTheMillimetres) {
  const workcell::Entity entity = mannequinEntity("both_hands_forward");
  std::vector<int> links;
  const MannequinManipulator manipulator = manipulatorOf(entity, Hands::kRight, true, links);
  EntityConfiguration configuration{entity.X_WE, entity.joints()};
  EXPECT_TRUE(manipulator.limits(configuration, 0.05, 0.05).empty());
  Pose wanted = manipulator.movedFrame(configuration);
  for (int i = 0; i < 200; ++i) {
    wanted.p.x += 0.004;
    configuration = manipulator.propose(configuration, wanted, 1.0);
  }
  EXPECT_GT(glm::length(manipulator.movedFrame(configuration).p - wanted.p), 0.2);
  const auto limits = manipulator.limits(configuration, 0.05, 0.05);
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_LT(limits[0].constraint_W.gap, 0.02);
  EXPECT_LT(limits[0].constraint_W.gradient[0], -0.5);
  EXPECT_EQ(limits[0].text.id(), "The right hand is %1 from the end of its reach");
}

TEST(MannequinManipulator, HangingArmsAreNotAtTheEndOfTheReachWhateverTheScaleOfTheZone) {
  const workcell::Entity entity = mannequinEntity("standing", "mannequin:female:5");
  std::vector<int> links;
  for (const Hands hands : {Hands::kLeft, Hands::kRight, Hands::kBoth, Hands::kBothApart}) {
    for (const double way : {-0.001, 0.001}) {  // Down and up: the trunk bends, the arms do.
      const MannequinManipulator manipulator = manipulatorOf(entity, hands, false, links);
      EntityConfiguration configuration{entity.X_WE, entity.joints()};
      Pose wanted = manipulator.movedFrame(configuration);
      for (int i = 0; i <= 60; ++i) {
        configuration = manipulator.propose(configuration, wanted, 1.0);
        ASSERT_LT(test::placeError(manipulator.movedFrame(configuration), wanted), 1e-4);
        for (const double zone : {0.01, 0.12, 0.6}) {
          EXPECT_TRUE(manipulator.limits(configuration, zone, 0.05).empty()) << static_cast<int>(hands) << " " << i;
        }
        wanted.p.z += way;
      }
    }
  }
}

TEST(MannequinManipulator, TheDifferentialTellsWhatTheProposalDoes) {
  const workcell::Entity entity = mannequinEntity("both_hands_forward");
  std::vector<int> links;
  const MannequinManipulator manipulator = manipulatorOf(entity, Hands::kRight, true, links);
  const EntityConfiguration start{entity.X_WE, entity.joints()};
  const auto parts = manipulator.differentiate(start);
  Pose wanted = manipulator.movedFrame(start);
  wanted.p.z += 2e-4;
  std::vector<Pose> before(links.size()), after(links.size());
  manipulator.partPoses(start, before);
  manipulator.partPoses(manipulator.propose(start, wanted, 1.0), after);
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::string& name = entity.robot()->links[static_cast<std::size_t>(links[k])].name;
    if (name != "r_hand" && name != "r_index2") continue;
    EXPECT_LT(glm::length(after[k].p - before[k].p - 2e-4 * parts[k].velocity[2].linear), 2e-5) << name;
  }
}

TEST(MannequinManipulator, WhatTheHandHoldsGoesWithIt) {
  workcell::Entity worker = mannequinEntity("both_hands_forward");
  const int hand = worker.robot()->findLink("r_hand");
  ASSERT_GE(hand, 0);
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*worker.robot(), worker.joints(), X_EL);
  const Pose X_WHand = worker.X_WE * X_EL[static_cast<std::size_t>(hand)];
  const Pose X_LP = Pose::translation({0.05, -0.02, -0.1});
  workcell::Entity bar = test::solid(3, "bar", geometry::makeBox({0.02, 0.02, 0.3}), X_WHand * X_LP);
  bar.attachment = {"worker", "r_hand", X_LP};
  // A plate below the bar's end that the hand itself never comes near.
  const double lowest = (X_WHand * X_LP).p.z - 0.3;
  const auto scene = PreparedScene::prepare({worker, bar,
                                             test::solid(1, "plate", geometry::makeBox({1.0, 1.0, 0.02}),
                                                         Pose::translation({X_WHand.p.x + 0.2, X_WHand.p.y, lowest}))},
                                            {}, {});
  HoldOptions options;
  options.moved_by = by::Hand{mannequin::Side::kRight};
  auto held = HeldEntity::take(scene, worker.id, {}, options, config::Configuration{});
  ASSERT_TRUE(held) << held.error().message();
  const auto met = [](const HeldPair& pair) { return pair.owner == 3 && pair.other == 1; };
  EXPECT_TRUE(std::any_of((*held)->pairs().begin(), (*held)->pairs().end(), met));
  MotionMapping mapping;
  mapping.anchor((*held)->movedFrame(), (*held)->movedFrame());
  Pose X_DP = (*held)->movedFrame();
  bool blocked = false;
  for (int i = 0; i < 60; ++i) {
    X_DP.p.z -= 0.005;
    blocked = (*held)->follow(X_DP, mapping, nullptr).blocked || blocked;
    const auto carried = (*held)->carried();
    ASSERT_EQ(carried.size(), 1u);
    std::vector<Pose> X_EL2;
    kinematics::forwardKinematics(*worker.robot(), (*held)->accepted().joints, X_EL2);
    const Pose there = (*held)->accepted().X_WE * X_EL2[static_cast<std::size_t>(hand)] * X_LP;
    EXPECT_LT(test::placeError(carried[0].second.X_WE, there), 1e-9) << "it stays in the hand";
  }
  EXPECT_TRUE(blocked) << "the bar stands on the plate";
}

constexpr double kRate = 50.0;

TEST(MannequinSession, AHandLaidOnATableIsStoppedAndFelt) {
  workcell::Entity worker = mannequinEntity("both_hands_forward");
  mannequin::Posture posture = mannequin::toPosture(*worker.figure(), {worker.X_WE, worker.joints()});
  const Pose hand =
      mannequin::handPose(mannequin::forwardKinematics(*worker.figure(), posture), mannequin::Side::kRight);
  std::vector<workcell::Entity> cell = {test::solid(1, "table", geometry::makeBox({0.5, 0.6, 0.04}),
                                                    Pose::translation({hand.p.x + 0.15, hand.p.y, hand.p.z - 0.11})),
                                        worker};
  SessionOptions options = test::sessionOf(
      cell, "worker",
      test::handThrough(
          {{0.0, {0, 0, 0.0}}, {0.5, {0, 0, 0.0}}, {1.5, {0, 0, -0.09}}, {2.2, {0, 0, -0.02}}, {2.4, {0, 0, -0.02}}}),
      kRate, 0.002);
  options.moved_by = by::Hand{mannequin::Side::kRight};
  options.scale = {ScaleLevel::kNumber, 1.0};
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_TRUE(report->end.held);
  EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  EXPECT_GT(report->forces.force_max_n, 0.5);
  ASSERT_GE(report->contacts.size(), 1u);
  EXPECT_EQ(report->contacts[0].other, 1u);
  std::printf(
      "mannequin session: force %.2f N, step %.1f N/ms, step median %.2f p99 %.2f ms, machine %.2f s for 2.4 s\n",
      report->forces.force_max_n, report->forces.force_max_step_n_per_ms, report->delays.step_median_ms,
      report->delays.step_p99_ms, report->machine_time_s);
}

}  // namespace
}  // namespace hapticell::manipulation
