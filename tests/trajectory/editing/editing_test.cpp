// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/editing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::trajectory {
namespace {

using test::gestureAt;
using test::recordedGesture;

Trajectory robotMotion() {
  Trajectory motion;
  motion.entity = "robot";
  motion.take = "take";
  motion.joint_names = {"a", "b"};
  motion.channel_names = {"force_x", "contact"};
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    const double joints[2] = {t, -2.0 * t}, channels[2] = {0.5 * t, i % 2 == 0 ? 1.0 : 0.0};
    motion.addFrame({t, gestureAt(t), i == 20, 0.0}, joints, channels);
  }
  motion.touches = {{0.5, 1.5, "robot/a", "table", 2.0}, {3.5, 3.8, "robot/b", "box", 1.0}};
  return motion;
}

void expectSamePlace(const Pose& a, const Pose& b, double tolerance) {
  const PoseDistance away = distanceBetween(a, b);
  EXPECT_LT(away.position, tolerance);
  EXPECT_LT(away.angle, tolerance);
}

TEST(Trimmed, KeepsThePartWithItsChannelsAndTouches) {
  const Trajectory motion = robotMotion();
  const auto part = trimmed(motion, 0.95, 2.05);
  ASSERT_TRUE(part.has_value());
  // 1.0 to 2.0 are recorded frames, the ends interpolated.
  ASSERT_EQ(part->size(), 13u);
  EXPECT_DOUBLE_EQ((*part)[0].t, 0.0);
  EXPECT_NEAR(part->duration(), 1.1, 1e-12);
  for (const double t : {0.0, 0.3, 0.77, 1.1}) {
    expectSamePlace(part->poseAt(t), motion.poseAt(t + 0.95), 1e-12);
    EXPECT_NEAR(part->jointsAt(t)[1], -2.0 * (t + 0.95), 1e-12);
  }
  EXPECT_EQ(part->channels(1)[1], 1.0);
  ASSERT_EQ(part->touches.size(), 1u);
  EXPECT_DOUBLE_EQ(part->touches[0].t_in, 0.0);
  EXPECT_NEAR(part->touches[0].t_out, 0.55, 1e-12);
  EXPECT_FALSE(trimmed(motion, 5.0, 6.0).has_value());
}

TEST(SplitAt, GivesTwoPartsThatMeet) {
  const Trajectory motion = robotMotion();
  const auto parts = splitAt(motion, 1.23);
  ASSERT_TRUE(parts.has_value());
  expectSamePlace(parts->first.frames().back().X_WT, parts->second[0].X_WT, 1e-12);
  EXPECT_NEAR(parts->first.duration() + parts->second.duration(), motion.duration(), 1e-12);
  for (const double t : {0.0, 4.0, 9.0, -1.0}) EXPECT_FALSE(splitAt(motion, t).has_value());
}

TEST(Joined, SplitPartsAreTheMotionAgain) {
  const Trajectory motion = robotMotion();
  const auto parts = splitAt(motion, 2.0);
  ASSERT_TRUE(parts.has_value());
  const std::vector<Trajectory> both{parts->first, parts->second};
  const auto again = joined(both, 0.1);
  ASSERT_TRUE(again.has_value());
  // The place where they meet stands twice, a millisecond apart.
  EXPECT_EQ(again->size(), motion.size() + 1);
  EXPECT_NEAR(again->duration(), motion.duration() + 1e-3, 1e-12);
  expectSamePlace(again->poseAt(3.001), motion.poseAt(3.0), 1e-9);
  EXPECT_EQ(again->touches.size(), motion.touches.size());
}

TEST(Joined, GoesFromOneToTheNextAtTheSpeed) {
  Trajectory a, b;
  a.addFrame({0.0, Pose::translation({0, 0, 0})});
  a.addFrame({1.0, Pose::translation({0.1, 0, 0})});
  b.addFrame({7.0, Pose::translation({0.4, 0, 0})});
  b.addFrame({8.0, Pose::translation({0.5, 0, 0})});
  const std::vector<Trajectory> both{a, b};
  const auto all = joined(both, 0.2);
  ASSERT_TRUE(all.has_value());
  EXPECT_NEAR((*all)[2].t, 1.0 + 0.3 / 0.2, 1e-12);
  b.entity = "other";
  const std::vector<Trajectory> strangers{a, b};
  EXPECT_FALSE(joined(strangers, 0.2).has_value());
}

RC_GTEST_PROP(Reversed, TwiceIsTheSame, (std::uint8_t count)) {
  const Trajectory motion = recordedGesture(0.1 + 0.02 * count, 50, 0.001);
  const Trajectory twice = reversed(reversed(motion));
  RC_ASSERT(twice.size() == motion.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    RC_ASSERT(std::abs(twice[i].t - motion[i].t) < 1e-12);
    RC_ASSERT(twice[i].X_WT.p == motion[i].X_WT.p);
  }
}

TEST(Reversed, TurnsTouchesRoundToo) {
  const Trajectory back = reversed(robotMotion());
  ASSERT_EQ(back.touches.size(), 2u);
  EXPECT_NEAR(back.touches[0].t_in, 0.2, 1e-12);
  EXPECT_NEAR(back.touches[1].t_out, 3.5, 1e-12);
  EXPECT_NEAR(back.joints(0)[0], 4.0, 1e-12);
}

TEST(Mirrored, ReflectsPointsAndStaysARotation) {
  const Trajectory motion = recordedGesture(2.0, 50, 0.0);
  const dvec3 p_W(0.1, 0.2, 0.3), n = glm::normalize(dvec3(1, 2, -1));
  const Trajectory other = mirrored(motion, p_W, n);
  ASSERT_EQ(other.size(), motion.size());
  for (std::size_t i = 0; i < motion.size(); i += 7) {
    // A second method: the middle of a point and its image lies on the plane, their difference along the normal.
    for (const dvec3& own : {dvec3(0, 0, 0), dvec3(0, 0.05, 0), dvec3(0, 0, 0.07), dvec3(0.1, 0, 0)}) {
      const dvec3 a = motion[i].X_WT * own, b = other[i].X_WT * dvec3(-own.x, own.y, own.z);
      EXPECT_NEAR(glm::dot(0.5 * (a + b) - p_W, n), 0.0, 1e-12);
      EXPECT_LT(glm::length(glm::cross(a - b, n)), 1e-12);
    }
    EXPECT_NEAR(glm::length(other[i].X_WT.q), 1.0, 1e-12);
  }
  const Trajectory back = mirrored(other, p_W, n);
  expectSamePlace(back[20].X_WT, motion[20].X_WT, 1e-9);
  EXPECT_FALSE(mirrored(robotMotion(), p_W, n).hasJoints());
}

TEST(WithFrame, PutsItBetweenItsNeighbours) {
  const Trajectory motion = recordedGesture(1.0, 10, 0.0);
  const auto more = withFrame(motion, 0.55, Pose::translation({1, 2, 3}));
  ASSERT_TRUE(more.has_value());
  EXPECT_EQ(more->size(), motion.size() + 1);
  EXPECT_TRUE((*more)[6].by_hand);
  EXPECT_EQ((*more)[6].X_WT.p, dvec3(1, 2, 3));
  EXPECT_FALSE(withFrame(motion, 0.5, {}).has_value());
  const auto after = withFrame(motion, 3.0, {});
  ASSERT_TRUE(after.has_value());
  EXPECT_DOUBLE_EQ(after->duration(), 3.0);
}

TEST(WithFrameAt, TakesItsNeighboursAlongAndNobodyElse) {
  const Trajectory motion = recordedGesture(2.0, 100, 0.0);
  const Pose X_WT{motion[100].X_WT.p + dvec3(0, 0, 0.02),
                  quaternionFromRotationVector({0.1, 0, 0}) * motion[100].X_WT.q};
  const auto moved = withFrameAt(motion, 100, X_WT, 0.3);
  ASSERT_TRUE(moved.has_value());
  expectSamePlace((*moved)[100].X_WT, X_WT, 1e-12);
  EXPECT_TRUE((*moved)[100].by_hand);
  for (const std::size_t i : {0u, 60u, 69u, 131u, 200u}) expectSamePlace((*moved)[i].X_WT, motion[i].X_WT, 1e-12);
  // Halfway: the bell is (1 - 1/4)^2.
  EXPECT_NEAR((*moved)[115].X_WT.p.z - motion[115].X_WT.p.z, 0.02 * 0.5625, 1e-12);
  const auto alone = withFrameAt(motion, 100, X_WT, 0.0);
  ASSERT_TRUE(alone.has_value());
  expectSamePlace((*alone)[99].X_WT, motion[99].X_WT, 1e-12);
  EXPECT_FALSE(withFrameAt(motion, 201, X_WT, 0.1).has_value());
}

TEST(WithoutFrames, LeavesAtLeastOne) {
  const Trajectory motion = robotMotion();
  const auto few = withoutFrames(motion, 10, 29);
  ASSERT_TRUE(few.has_value());
  EXPECT_EQ(few->size(), 21u);
  EXPECT_EQ(few->channels(10)[0], motion.channels(30)[0]);
  EXPECT_FALSE(withoutFrames(motion, 0, 40).has_value());
  EXPECT_FALSE(withoutFrames(motion, 30, 41).has_value());
  EXPECT_FALSE(withoutFrames(motion, 3, 2).has_value());
}

TEST(WithDwell, IsAProcessPointThatProgramsWaitAt) {
  const auto waits = withDwell(robotMotion(), 7, 1.5);
  ASSERT_TRUE(waits.has_value());
  EXPECT_DOUBLE_EQ((*waits)[7].dwell, 1.5);
  EXPECT_TRUE((*waits)[7].by_hand);
  EXPECT_FALSE(withDwell(robotMotion(), 7, -1.0).has_value());
}

TEST(WithApproach, ComesStraightAlongTheToolsAxis) {
  const Trajectory motion = recordedGesture(1.0, 50, 0.0);
  const StraightWay way{0.08, {0, 0, -2}, 0.04};
  const auto longer = withApproach(motion, way);
  ASSERT_TRUE(longer.has_value());
  EXPECT_NEAR(longer->duration(), motion.duration() + 2.0, 1e-12);
  const dvec3 from_T = motion[0].X_WT.inverse() * (*longer)[0].X_WT.p;
  EXPECT_LT(glm::distance(from_T, dvec3(0, 0, -0.08)), 1e-12);
  const auto away = withRetract(*longer, way);
  ASSERT_TRUE(away.has_value());
  EXPECT_NEAR(glm::distance(away->frames().back().X_WT.p, motion.frames().back().X_WT.p), 0.08, 1e-12);
  EXPECT_FALSE(withApproach(motion, {0.0, {0, 0, 1}, 0.1}).has_value());
  EXPECT_FALSE(withRetract(motion, {0.1, {0, 0, 0}, 0.1}).has_value());
}

TEST(Resampled, KeepsTimesAndFramesByHand) {
  const auto few = resampled(robotMotion(), 0.3);
  ASSERT_TRUE(few.has_value());
  // 0, 0.3 ... 3.9, that by hand at 2.0, and the end.
  EXPECT_EQ(few->size(), 16u);
  for (const auto& frame : few->frames()) expectSamePlace(frame.X_WT, robotMotion().poseAt(frame.t), 1e-12);
  EXPECT_FALSE(resampled(robotMotion(), 0.0).has_value());
}

TEST(Edits, LeaveTheRecordingAsItWas) {
  const Trajectory motion = robotMotion();
  const std::string before = toJsonText(motion);
  (void)trimmed(motion, 1, 2);
  (void)reversed(motion);
  (void)withFrameAt(motion, 3, {}, 1.0);
  (void)withDwell(motion, 3, 1.0);
  EXPECT_EQ(toJsonText(motion), before);
}

/// Four points on a line, 0.1 m and 1 s apart, set by hand; the second waits.
Trajectory program() {
  Trajectory motion;
  motion.entity = "robot";
  motion.joint_names = {"a"};
  for (int i = 0; i < 4; ++i) {
    const double joint = 10.0 * i;
    motion.addFrame({1.0 * i, Pose::translation({0.1 * i, 0, 0}), true, i == 1 ? 2.0 : 0.0}, std::span(&joint, 1));
  }
  return motion;
}

TEST(WithName, NamesOnePointAndIsKeptByEveryEdit) {
  auto named = withName(program(), 2, "above the clamp");
  ASSERT_TRUE(named.has_value());
  EXPECT_EQ((*named)[2].nameText(), "above the clamp");
  EXPECT_EQ((*named)[1].nameText(), "");
  EXPECT_EQ(named->joints(2)[0], 20.0);
  EXPECT_TRUE(named->isTaught());
  EXPECT_EQ(reversed(*named)[1].nameText(), "above the clamp");
  EXPECT_EQ((*withoutFrames(*named, 0, 0))[1].nameText(), "above the clamp");
  EXPECT_EQ(transformed(*named, Pose::translation({1, 0, 0}))[2].nameText(), "above the clamp");
  // A point that is named is never thinned out, on however straight a way it lies.
  Trajectory samples;
  for (int i = 0; i <= 100; ++i) samples.addFrame({0.01 * i, Pose::translation({0.01 * i, 0, 0})});
  EXPECT_EQ(simplified(*withName(samples, 37, "gate"), {}).size(), 3u);
  EXPECT_FALSE(samples.isTaught());
  EXPECT_FALSE(withName(*named, 1, "above the clamp").has_value()) << "taken";
  EXPECT_FALSE(withName(*named, 4, "x").has_value());
  EXPECT_FALSE(withName(*named, 0, "two\nlines").has_value());
  const auto cleared = withName(*named, 2, "");
  ASSERT_TRUE(cleared.has_value());
  EXPECT_EQ((*cleared)[2].name, nullptr);
}

TEST(WithFrameMoved, KeepsThePointsAndTakesTheTimeThatTheNewWaysNeed) {
  const Trajectory motion = program();  // 0.1 m/s on average.
  const auto moved = withFrameMoved(motion, 3, 1);
  ASSERT_TRUE(moved.has_value());
  ASSERT_EQ(moved->size(), 4u);
  const double x[]{0.0, 0.3, 0.1, 0.2}, t[]{0.0, 3.0, 5.0, 6.0};  // 0.3 m and 0.2 m are new, 0.1 m was there.
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR((*moved)[i].X_WT.p.x, x[i], 1e-15);
    EXPECT_NEAR((*moved)[i].t, t[i], 1e-12) << i;
    EXPECT_NEAR(moved->joints(i)[0], 100.0 * x[i], 1e-12) << "a point keeps its joints";
  }
  EXPECT_EQ((*moved)[2].dwell, 2.0) << "and its wait";
  // Back again: the same points in the same order.
  const auto back = withFrameMoved(*moved, 1, 3);
  ASSERT_TRUE(back.has_value());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ((*back)[i].X_WT.p, motion[i].X_WT.p);
  // Neighbours that change places keep the time between them.
  const auto swapped = withFrameMoved(motion, 1, 2);
  ASSERT_TRUE(swapped.has_value());
  EXPECT_NEAR((*swapped)[2].t - (*swapped)[1].t, 1.0, 1e-12);
  EXPECT_FALSE(withFrameMoved(motion, 0, 4).has_value());
  EXPECT_FALSE(withFrameMoved(motion, 4, 0).has_value());
}

TEST(WithFrameMoved, PointsThatLieTogetherStillComeOneAfterTheOther) {
  Trajectory still;
  for (int i = 0; i < 3; ++i) still.addFrame({0.5 * i, Pose::identity(), true});
  const auto moved = withFrameMoved(still, 0, 2);
  ASSERT_TRUE(moved.has_value());
  for (std::size_t i = 1; i < 3; ++i) EXPECT_GE((*moved)[i].t - (*moved)[i - 1].t, 1e-3);
}

}  // namespace
}  // namespace hapticell::trajectory
