// SPDX-License-Identifier: Apache-2.0
// Two styluses in one cell.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/manipulation/engine/two_stations.h"

namespace hapticell::manipulation {
namespace {

TEST(SecondStylus, EachDrawsAHandOfTheSameMannequin) {
  TwoStations two({worker("both_hands_forward")});
  two.takeBothHands();
  const workcell::Entity& figure = two.cell[0];
  const EntityConfiguration start = two.first->placement(kWorker);
  const Pose left = gripOf(figure, start, mannequin::Side::kLeft),
             right = gripOf(figure, start, mannequin::Side::kRight);
  for (int ms = 1; ms <= 300; ++ms) {
    two.a.hold({1e-4 * ms, 0.0, 0.0});
    two.b.hold({0.0, 0.0, 1e-4 * ms});
    two.run(2);
  }
  two.run(600);
  const EntityConfiguration end = two.first->placement(kWorker);
  const EntityConfiguration seen = two.second->holder().placement(kWorker);
  for (std::size_t i = 0; i < end.joints.size(); ++i) EXPECT_NEAR(end.joints[i], seen.joints[i], 1e-9) << i;
  const double scale = two.configuration.scale.medium;
  const dvec3 right_way = gripOf(figure, end, mannequin::Side::kRight).p - right.p;
  const dvec3 left_way = gripOf(figure, end, mannequin::Side::kLeft).p - left.p;
  EXPECT_LT(glm::length(right_way - scale * dvec3(0.03, 0.0, 0.0)), 0.002 * scale);
  EXPECT_LT(glm::length(left_way - scale * dvec3(0.0, 0.0, 0.03)), 0.002 * scale);

  SceneSnapshot picture;
  two.first->fillSnapshot(picture);
  two.second->addTo(picture);
  ASSERT_TRUE(picture.second);
  EXPECT_EQ(picture.second->held, kWorker);
  EXPECT_EQ(
      std::count_if(picture.entities.begin(), picture.entities.end(), [](const auto& e) { return e.id == kWorker; }),
      1);
}

TEST(SecondStylus, WhatOneHandTouchesIsFeltByThatHandAlone) {
  const workcell::Entity figure = worker("both_hands_forward");
  const Pose left = gripOf(figure, {figure.X_WE, figure.joints()}, mannequin::Side::kLeft);
  workcell::Entity shelf = test::solid(kShelf, "shelf", geometry::makeBox({0.4, 0.2, 0.02}), {});
  shelf.X_WE.p = left.p + dvec3(0.0, 0.05, 0.08);
  TwoStations two({figure, shelf});
  two.takeBothHands();
  for (int ms = 1; ms <= 600; ++ms) {
    two.a.hold({0.0, 0.0, -5e-5 * ms});
    two.b.hold({0.0, 0.0, 1e-4 * ms});
    two.run(2);
  }
  two.run(600);
  EXPECT_GT(two.b.force(), 0.5);
  EXPECT_LT(two.a.force(), 0.2);
  SceneSnapshot picture;
  two.first->fillSnapshot(picture);
  two.second->addTo(picture);
  EXPECT_GT(picture.second->force_n, 0.5);
  EXPECT_TRUE(std::any_of(picture.pairs.begin(), picture.pairs.end(), [](const PairState& pair) {
    return pair.contact && pair.other == kShelf && pair.moved_part.substr(0, 2) == "l_";
  }));
}

/// What one holds stands in the other's way.
TEST(SecondStylus, TheyMeetEachOther) {
  std::vector<workcell::Entity> cell{test::solid(kShelf, "left", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(kBox, "right", geometry::makeBox({0.1, 0.4, 0.4}), {})};
  cell[0].X_WE.p = {-0.10, 0.0, 0.0};
  cell[1].X_WE.p = {0.10, 0.0, 0.0};
  TwoStations two(cell);
  two.first->apply(command::SetScale{{ScaleLevel::kNumber, 1.0}});
  two.second->holder().apply(command::SetScale{{ScaleLevel::kNumber, 1.0}});
  two.first->apply(command::Grab{kShelf});
  two.second->holder().apply(command::Grab{kBox});
  two.run(50);
  double nearest = 1.0;
  for (int ms = 1; ms <= 600; ++ms) {
    two.a.hold({1.2e-4 * ms, 0.0, 0.0});
    two.b.hold({-1.2e-4 * ms, 0.0, 0.0});
    two.run(2);
    const double gap = two.second->holder().placement(kBox).X_WE.p.x - two.first->placement(kShelf).X_WE.p.x - 0.1;
    nearest = std::min(nearest, gap);
  }
  two.run(1500);
  EXPECT_GT(nearest, 0.0) << "they never enter each other";
  EXPECT_LT(nearest, 0.005);
  EXPECT_GT(two.a.force(), 0.5);
  EXPECT_GT(two.b.force(), 0.5);
}

template <typename Holder>
std::string noticesOf(Holder& holder) {
  std::string all;
  for (const Result& one : holder.takeResults()) {
    if (const auto* notice = std::get_if<result::Notice>(&one)) all += english(notice->sentence) + "\n";
  }
  return all;
}

/// Two boxes apart from each other, and a lid that goes with the left one.
std::vector<workcell::Entity> twoBoxesAndLid() {
  std::vector<workcell::Entity> cell{test::solid(kShelf, "left", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(kBox, "right", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(10, "lid", geometry::makeBox({0.1, 0.1, 0.01}), {})};
  cell[0].X_WE.p = {-0.3, 0.0, 0.0};
  cell[1].X_WE.p = {0.3, 0.0, 0.0};
  cell[2].X_WE.p = {-0.3, 0.0, 0.2};
  cell[2].attachment.to = "left";
  return cell;
}

TEST(SecondStylus, WhatTheOneHoldsTheOtherDoesNotTake) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.run(20);
  two.second->holder().apply(command::Grab{kShelf});
  EXPECT_EQ(two.second->holder().held(), nullptr);
  EXPECT_EQ(noticesOf(two.second->holder()), "left is held by the other stylus\n");
  two.second->holder().apply(command::Grab{10});
  EXPECT_EQ(two.second->holder().held(), nullptr);
  EXPECT_EQ(noticesOf(two.second->holder()), "lid moves with left, which the other stylus holds: release it there first\n");
  // The other way round, and what is free again.
  two.first->apply(command::Release{});
  two.run(20);
  two.second->holder().apply(command::Grab{10});
  two.run(20);
  ASSERT_NE(two.second->holder().held(), nullptr);
  two.first->apply(command::Grab{kShelf});
  EXPECT_EQ(two.first->held(), nullptr);
  EXPECT_EQ(noticesOf(*two.first), "left carries lid, which the other stylus holds: release it there first\n");
  two.first->apply(command::Grab{kBox});
  EXPECT_NE(two.first->held(), nullptr) << "what is free may be taken";
}

/// Both asked between two steps: the second one lets go, and whatever is held is held once.
TEST(SecondStylus, TakenByBothAtOnceItIsTheFirstOnes) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.second->holder().apply(command::Grab{kShelf});
  two.run(20);
  EXPECT_NE(two.first->held(), nullptr);
  EXPECT_EQ(two.second->holder().held(), nullptr);
  EXPECT_NE(noticesOf(two.second->holder()).find("left is held by the other stylus"), std::string::npos);
}

/// A mannequin's hand each, until the first one wants the whole figure.
TEST(SecondStylus, TheWholeFigureIsNotDrawnByAHandToo) {
  TwoStations two({worker("both_hands_forward")});
  two.takeBothHands();
  two.first->apply(command::SetMovedBy{by::Whole{}});
  two.run(20);
  EXPECT_NE(two.first->held(), nullptr);
  EXPECT_EQ(two.second->holder().held(), nullptr);
}

/// One belt for both, and what the second one holds gives way to it as what the first one holds does.
TEST(SecondStylus, WhatGoesByItselfIsInOnePlaceForBoth) {
  std::vector<workcell::Entity> cell = twoBoxesAndLid();
  cell[0].motion.emplace().points = {{0.0, dvec3(0.0)}, {20.0, dvec3(1.0, 0.0, 0.0)}};
  TwoStations two(cell);
  two.second->holder().apply(command::Grab{kBox});
  two.run(10000);
  const double belt = two.first->placement(kShelf).X_WE.p.x, pushed = two.first->placement(kBox).X_WE.p.x;
  EXPECT_EQ(two.second->holder().placement(kShelf).X_WE.p.x, belt);
  EXPECT_GT(belt, 0.1) << "it goes on";
  EXPECT_GE(pushed - belt, 0.1) << "and is not inside of what is held";
  EXPECT_EQ(two.second->holder().placement(kBox).X_WE.p.x, pushed);
}

TEST(SecondStylus, ATakeHasWhatBothMove) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.second->holder().apply(command::Grab{kBox});
  two.run(20);
  trajectory::RecordingOptions options;
  options.mode = trajectory::RecordingMode::kEveryStep;
  two.first->apply(command::StartRecording{.options = options, .take = "both"});
  for (int ms = 1; ms <= 400; ++ms) {
    two.a.hold({0.0, 0.0, 1e-4 * ms});
    two.b.hold({0.0, 1e-4 * std::max(0, ms - 200), 0.0});
    two.run(2);
  }
  two.run(400);
  const Pose left = two.first->placement(kShelf).X_WE, right = two.second->holder().placement(kBox).X_WE;
  two.first->takeResults();
  two.first->apply(command::StopRecording{});
  std::vector<trajectory::Trajectory> take;
  for (Result& one : two.first->takeResults()) {
    if (auto* recorded = std::get_if<result::Recorded>(&one)) take = std::move(recorded->trajectories);
  }
  ASSERT_EQ(take.size(), 2u);
  EXPECT_EQ(take[0].entity, "left");
  EXPECT_EQ(take[1].entity, "right");
  EXPECT_EQ(take[1].take, "both");
  EXPECT_LT(glm::length(take[0].frames().back().X_WT.p - left.p), 1e-4);
  EXPECT_LT(glm::length(take[1].frames().back().X_WT.p - right.p), 1e-4);
  EXPECT_GT(right.p.y, 0.015);
  EXPECT_GT(take[1].frames().front().t, 0.3) << "one clock: the second one began later";
}

/// While frames are marked by the button, either pen's second button marks one, and neither is a clutch then.
TEST(SecondStylus, ItsButtonMarksFramesOfARecordingToo) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.second->holder().apply(command::Grab{kBox});
  two.run(20);
  trajectory::RecordingOptions options;
  options.mode = trajectory::RecordingMode::kByHand;
  two.first->apply(command::StartRecording{.options = options, .take = "marked", .mark_by_button = true});
  const Pose start = two.second->holder().placement(kBox).X_WE;
  const auto press = [&](Station& station, const dvec3& p_D) {
    for (const std::uint32_t buttons : {2u, 0u}) {
      station.device.hand().hold(Pose::translation(p_D), buttons);
      two.run(200);
    }
  };
  press(two.b, {0.0, 0.01, 0.0});
  press(two.a, {0.0, 0.0, 0.01});
  press(two.b, {0.0, 0.02, 0.0});
  EXPECT_GT(two.second->holder().placement(kBox).X_WE.p.y, start.p.y + 0.01) << "it was clutched";
  two.first->takeResults();
  two.first->apply(command::StopRecording{});
  std::vector<trajectory::Trajectory> take;
  for (Result& one : two.first->takeResults()) {
    if (auto* recorded = std::get_if<result::Recorded>(&one)) take = std::move(recorded->trajectories);
  }
  ASSERT_EQ(take.size(), 2u);
  for (const trajectory::Trajectory& track : take) {
    ASSERT_EQ(track.size(), 3u) << track.entity;
    EXPECT_TRUE(track[0].by_hand && track[1].by_hand && track[2].by_hand);
  }
  // Without such a recording the button is the clutch again.
  two.b.device.hand().hold(Pose::translation({0.0, 0.02, 0.0}), 2);
  two.run(100);
  const Pose clutched = two.second->holder().placement(kBox).X_WE;
  two.b.device.hand().hold(Pose::translation({0.0, 0.0, 0.0}), 2);
  two.run(300);
  EXPECT_LT(glm::length(two.second->holder().placement(kBox).X_WE.p - clutched.p), 1e-4);
}

}  // namespace
}  // namespace hapticell::manipulation
