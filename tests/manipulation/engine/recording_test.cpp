// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>
#include "manipulation/engine/take_recorder.h"
#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

using test::handThrough;
using test::solid;
using trajectory::RecordingMode;
using trajectory::Trajectory;

TakeRecorder::Sample sampleOf(double t, const workcell::Entity& entity, const EntityConfiguration& at,
                              const Pose& X_WM) {
  TakeRecorder::Sample sample;
  sample.t = t;
  sample.entity = &entity;
  sample.at = &at;
  sample.X_WM = X_WM;
  return sample;
}

TEST(TakeRecorder, SeveralEntitiesShareOneClock) {
  const auto a = solid(1, "a", geometry::makeBox(dvec3(0.1))), b = solid(2, "b", geometry::makeBox(dvec3(0.1)));
  trajectory::RecordingOptions options;
  options.mode = RecordingMode::kEveryStep;
  TakeRecorder recorder(options, "take 1");
  for (int i = 0; i <= 200; ++i) {
    const double t = 50.0 + 0.01 * i;
    // a moves from 0.5 s on, b from 1 s on.
    const EntityConfiguration at_a{Pose::translation({std::max(0, i - 50) * 0.001, 0, 0}), {}};
    const EntityConfiguration at_b{Pose::translation({0, std::max(0, i - 100) * 0.001, 0}), {}};
    recorder.add(sampleOf(t, a, at_a, at_a.X_WE));
    recorder.add(sampleOf(t, b, at_b, at_b.X_WE));
  }
  const auto takes = recorder.finish();
  ASSERT_EQ(takes.size(), 2u);
  EXPECT_EQ(takes[0].entity, "a");
  EXPECT_EQ(takes[1].take, "take 1");
  EXPECT_EQ(takes[0][0].t, 0.0);
  // Half a second apart, whatever either was cut off at its soft start.
  EXPECT_NEAR(takes[1][0].t, 0.5, 0.011);
  EXPECT_NEAR(takes[0].frames().back().t, takes[1].frames().back().t, 1e-12);
  // At the same time of the clock both are where they were at the same time.
  const double t = 1.2 - 0.02;
  EXPECT_NEAR(takes[0].poseAt(t).p.x - takes[1].poseAt(t).p.y, 0.05, 1e-3);
}

TEST(TakeRecorder, TouchesAndForcesStandBesideTheFrames) {
  const auto box = solid(1, "box", geometry::makeBox(dvec3(0.1)));
  trajectory::RecordingOptions options;
  options.mode = RecordingMode::kEveryStep;
  TakeRecorder recorder(options);
  for (int i = 0; i <= 100; ++i) {
    const EntityConfiguration at{Pose::translation({0.001 * i, 0, 0}), {}};
    auto sample = sampleOf(0.01 * i, box, at, at.X_WE);
    sample.force_W = {0, 0, i > 40 ? 0.1 * (i - 40) : 0.0};
    // An interruption of 20 ms is none.
    if (i > 40 && i < 80 && i != 60 && i != 61) sample.touching = {{"box", "wall"}};
    recorder.add(sample);
  }
  const auto takes = recorder.finish();
  ASSERT_EQ(takes.size(), 1u);
  const Trajectory& take = takes.front();
  ASSERT_EQ(take.touches.size(), 1u);
  EXPECT_NEAR(take.touches[0].t_out - take.touches[0].t_in, 0.38, 1e-9);
  EXPECT_NEAR(take.touches[0].max_force, 3.9, 1e-9);
  const auto z = take.findChannel("force_z"), contact = take.findChannel("contact");
  ASSERT_TRUE(z && contact);
  EXPECT_NEAR(take.channels(take.size() - 1)[*z], 6.0, 1e-12);
  EXPECT_EQ(take.channels(50)[*contact], 1.0);
}

TEST(TakeRecorder, NothingMovedIsNothing) {
  const auto box = solid(1, "box", geometry::makeBox(dvec3(0.1)));
  TakeRecorder recorder({});
  for (int i = 0; i < 100; ++i) {
    const EntityConfiguration at{};
    recorder.add(sampleOf(0.01 * i, box, at, {}));
  }
  EXPECT_TRUE(recorder.finish().empty());
}

/// Sessions record through the same recorder; frames by hand come with the stylus's second button.
TEST(Recording, TheSecondButtonAddsFramesByHand) {
  auto options =
      test::sessionOf(test::boxOverTable(0.05), "box",
                      handThrough({{0.0, {0, 0, 0}}, {1.0, {0.02, 0, 0}}, {2.0, {0.04, 0, 0.01}}}), 200, 0.005);
  options.recording = trajectory::RecordingOptions{RecordingMode::kByTime, 0.02};
  const auto by_time = runSession(options);
  ASSERT_TRUE(by_time.has_value());
  EXPECT_GT(by_time->recording.size(), 60u);
  EXPECT_EQ(by_time->recording[0].t, 0.0);
  EXPECT_EQ(by_time->recording.entity, "box");
  EXPECT_TRUE(by_time->recording.findChannel("force_z").has_value());

  std::vector<haptic::HandSample> hand = options.hand.samples();
  for (haptic::HandSample& sample : hand) {
    for (const double press : {0.6, 1.2, 1.8}) {
      if (sample.t >= press && sample.t < press + 0.08) sample.buttons |= 2u;
    }
  }
  options.hand = haptic::HandPath(hand);
  options.recording->mode = RecordingMode::kByHand;
  options.mark_by_button = true;
  options.device.buttons = 2;
  const auto by_hand = runSession(options);
  ASSERT_TRUE(by_hand.has_value());
  ASSERT_EQ(by_hand->recording.size(), 3u);
  EXPECT_TRUE(by_hand->recording[1].by_hand);
  // On the way, a step and a message behind the hand; no clutch held the box back.
  const Pose X_DH0 = options.hand.at(0.05).X_DH;
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = 0.6 * static_cast<double>(i + 1);
    const double way = glm::distance(by_hand->recording[i].X_WT.p, by_time->recording[0].X_WT.p);
    EXPECT_NEAR(way, glm::distance(options.hand.at(t).X_DH.p, X_DH0.p) * 1.0, 0.006) << i;
  }
}

}  // namespace
}  // namespace hapticell::manipulation
