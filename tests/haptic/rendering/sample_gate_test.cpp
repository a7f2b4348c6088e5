// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/sample_gate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hapticell::haptic {
namespace {

using Verdict = SampleGate::Verdict;

Pose at(double x, double z = 0.0) {
  return Pose::translation({x, 0.0, z});
}

int refusedOf(SampleGate& gate, double (*way)(double), int ticks) {
  int refused = 0;
  for (int i = 0; i < ticks; ++i) {
    if (gate.judge(at(way(0.001 * i)), 0.001) != Verdict::kFollows) ++refused;
  }
  return refused;
}

TEST(SampleGate, WhatAHandAndItsMotorsCanDoFollows) {
  SampleGate gate;
  EXPECT_EQ(refusedOf(
                gate, [](double t) { return 0.02 * (1.0 - std::cos(50.0 * t)); }, 2000),
            0)
      << "1 m/s, 50 m/s2";
  gate.restart();
  // 6.4 N let a stylus of 45 g go, in steps of an encoder of 0.02 mm.
  EXPECT_EQ(refusedOf(
                gate, [](double t) { return 2e-5 * std::floor(0.5 * 142.0 * t * t / 2e-5); }, 60),
            0);
  gate.restart();
  // It strikes a stop at 1 m/s and bounces.
  EXPECT_EQ(refusedOf(
                gate, [](double t) { return t < 0.2 ? 2.5 * t * t : 0.1 - 0.6 * (t - 0.2); }, 250),
            0);
}

TEST(SampleGate, ADeviceThatSaysEachPlaceSeveralTimesFollows) {
  SampleGate gate;
  int refused = refusedOf(
      gate, [](double t) { return 0.3 * std::floor(250.0 * t) / 250.0; }, 1000);
  EXPECT_LE(refused, 1) << "from rest, once";
}

TEST(SampleGate, OneWrongSampleIsRefusedOfAnySize) {
  for (const double size : {0.2e-3, 1e-3, 0.02, 0.5, 1e3}) {
    SampleGate gate;
    for (int i = 0; i < 10; ++i) gate.judge(at(0.01), 0.001);
    EXPECT_EQ(gate.judge(at(0.01, size), 0.001), Verdict::kRefused) << size;
    EXPECT_EQ(gate.believed().p, at(0.01).p);
    EXPECT_EQ(gate.judge(at(0.01), 0.001), Verdict::kFollows);
  }
  SampleGate gate;
  gate.judge(at(0.0), 0.001);
  EXPECT_EQ(gate.judge({{0.0, 0.0, 0.0}, quaternionFromRotationVector({0.0, 0.02, 0.0})}, 0.001), Verdict::kRefused)
      << "a turn";
}

TEST(SampleGate, ATrueLeapCostsOneTick) {
  SampleGate gate;
  gate.judge(at(0.0), 0.001);
  EXPECT_EQ(gate.judge(at(0.001), 0.001), Verdict::kRefused);
  EXPECT_EQ(gate.judge(at(0.002), 0.001), Verdict::kFollows) << "1 m/s out of nothing: hard, but possible";
}

/// It may stay, tremble or go on there for as long as it likes: only whoever has switched the motors off believes it.
TEST(SampleGate, AJumpThatNoHandCanMakeIsNeverBelieved) {
  for (const double size : {0.005, 0.015, 0.05, 1e9}) {
    for (const double speed : {0.0, 0.3}) {
      SampleGate gate;
      for (int i = 0; i < 10; ++i) gate.judge(at(0.0), 0.001);
      for (int i = 0; i < 500; ++i) {
        ASSERT_EQ(gate.judge(at(size + 0.001 * speed * i + (i % 2 == 0 ? 1e-5 : 0.0)), 0.001), Verdict::kRefused)
            << size << ' ' << i;
      }
      EXPECT_EQ(gate.believed().p.x, 0.0);
      gate.restart();
      EXPECT_EQ(gate.judge(at(size), 0.001), Verdict::kFollows);
      EXPECT_EQ(gate.believed().p.x, size);
    }
  }
}

TEST(SampleGate, AHandThatIsSeenAgainIsBelieved) {
  SampleGate gate;
  for (int i = 0; i <= 100; ++i) gate.judge(at(3e-4 * i), 0.001);
  for (int i = 101; i <= 115; ++i) EXPECT_EQ(gate.judge(at(3e-4 * i, 0.04), 0.001), Verdict::kRefused);
  EXPECT_EQ(gate.judge(at(3e-4 * 116), 0.001), Verdict::kFollows);
}

TEST(SampleGate, SamplesThatAgreeWithNothingAreNotBelieved) {
  SampleGate gate;
  gate.judge(at(0.0), 0.001);
  for (int i = 0; i < 19; ++i) EXPECT_EQ(gate.judge(at(i % 2 == 0 ? 0.05 : -0.07), 0.001), Verdict::kRefused) << i;
  EXPECT_EQ(gate.believed().p.x, 0.0);
}

TEST(SampleGate, TicksThatWereMissedGiveRoom) {
  SampleGate gate;
  gate.judge(at(0.0), 0.001);
  EXPECT_EQ(gate.judge(at(0.01), 0.01), Verdict::kFollows);
}

}  // namespace
}  // namespace hapticell::haptic
