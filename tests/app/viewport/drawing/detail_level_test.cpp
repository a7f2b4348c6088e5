// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/detail_level.h"

#include <gtest/gtest.h>

namespace hapticell::app {
namespace {

/// A machine on which a frame of each level takes so long.
double cost(DetailLevel level, double full) {
  const double shares[]{1.0, 0.5, 0.4, 0.25, 0.1, 0.05};
  return full * shares[static_cast<int>(level)];
}

TEST(DetailGovernor, KeepsTheFullPictureWhereItFits) {
  DetailGovernor governor(0.05);
  for (int i = 0; i < 200; ++i) governor.frameTook(0.02);
  EXPECT_EQ(governor.level(), DetailLevel::kFull);
}

TEST(DetailGovernor, ComesBelowTheBudgetWithinAFewFramesHoweverHeavyTheScene) {
  for (const double full : {0.06, 0.1, 0.3, 0.9}) {
    DetailGovernor governor(0.05);
    int slow = 0;
    for (int i = 0; i < 300; ++i) {
      const double took = cost(governor.level(), full);
      if (took > 0.05) ++slow;
      governor.frameTook(took);
    }
    EXPECT_LE(slow, 12) << "full frame " << full;
    EXPECT_LE(cost(governor.level(), full), 0.05) << "full frame " << full;
  }
}

TEST(DetailGovernor, GivesDetailBackWhenTheLoadIsGone) {
  DetailGovernor governor(0.05);
  for (int i = 0; i < 10; ++i) governor.frameTook(0.4);
  EXPECT_EQ(governor.level(), DetailLevel::kCoarse);
  for (int i = 0; i < 2000; ++i) governor.frameTook(0.005);
  EXPECT_EQ(governor.level(), DetailLevel::kFull);
}

TEST(DetailGovernor, BeginsLowOnAnUnknownMachineAndClimbsAsFarAsItFits) {
  DetailGovernor quick(0.05, DetailLevel::kHalfSize);
  for (int i = 0; i < 10; ++i) quick.frameTook(0.004);
  EXPECT_EQ(quick.level(), DetailLevel::kFull);
  DetailGovernor slow(0.05, DetailLevel::kHalfSize);
  int over = 0;
  for (int i = 0; i < 200; ++i) {
    const double took = cost(slow.level(), 0.2);
    if (took > 0.05) ++over;
    slow.frameTook(took);
  }
  EXPECT_LE(over, 4);
  EXPECT_EQ(slow.level(), DetailLevel::kNoEdges);
}

TEST(DetailGovernor, NeverDrawsSoManyTrianglesThatAFrameIsLongOnceItKnowsTheMachine) {
  // A renderer of 4 million triangles a second, without other costs, and a cell of 20 million; then one of 10 thousand.
  DetailGovernor governor(0.05, DetailLevel::kHalfSize);
  const auto frame = [&governor](double triangles) {
    const double shares[]{1.0, 0.9, 0.8, 0.6, 0.5, 0.2};
    const double wanted = shares[static_cast<int>(governor.level())] * triangles;
    const double drawn = std::min(wanted, static_cast<double>(governor.mostTriangles()));
    governor.frameTook(drawn / 4e6, static_cast<std::size_t>(drawn));
    return drawn / 4e6;
  };
  for (int i = 0; i < 1000; ++i) EXPECT_LE(frame(2e7), 0.1) << i;
  EXPECT_GT(governor.mostTriangles(), 50000u);
  for (int i = 0; i < 2000; ++i) EXPECT_LE(frame(1e4), 0.05);
  EXPECT_EQ(governor.level(), DetailLevel::kFull);
  // A graphics card: nothing is left out for long.
  DetailGovernor quick(0.05, DetailLevel::kHalfSize);
  for (int i = 0; i < 60; ++i) {
    const double drawn = std::min(2e6, static_cast<double>(quick.mostTriangles()));
    quick.frameTook(drawn / 1e9, static_cast<std::size_t>(drawn));
  }
  EXPECT_GE(quick.mostTriangles(), 2000000u);
  EXPECT_EQ(quick.level(), DetailLevel::kFull);
}

TEST(DetailGovernor, AnotherBudgetCountsFromTheNextFrameOn) {
  DetailGovernor governor(0.05);
  governor.frameTook(0.03);
  EXPECT_EQ(governor.level(), DetailLevel::kFull);
  governor.setBudget(0.02);
  governor.frameTook(0.03);
  EXPECT_EQ(governor.level(), DetailLevel::kNoOcclusion);
}

TEST(FrameMeter, CountsTheFramesOfTheLastSecond) {
  FrameMeter meter;
  for (int i = 0; i < 100; ++i) meter.frame(0.05 * i, 0.01 + 0.001 * (i % 5));
  EXPECT_NEAR(meter.rate(0.05 * 99), 20.0, 1.5);
  EXPECT_EQ(meter.rate(100.0), 0.0);
  EXPECT_DOUBLE_EQ(meter.worstSeconds(), 0.014);
}

TEST(DetailGovernor, LeavesAFigureItsShapeHoweverSlowTheMachine) {
  DetailGovernor governor(0.05);
  for (int i = 0; i < 200; ++i) governor.frameTook(1.0, governor.mostTriangles());
  EXPECT_GE(governor.mostTriangles(), 90u * 100u) << "ninety bodies of a hundred triangles";
}

TEST(DetailGovernor, WhatWasFarTooSlowIsNotTriedAgainSoon) {
  DetailGovernor governor(0.05);
  governor.frameTook(1.0);
  governor.frameTook(1.0);
  ASSERT_EQ(governor.level(), DetailLevel::kHalfSize);
  governor.frameTook(0.4);
  ASSERT_EQ(governor.level(), DetailLevel::kCoarse);
  for (int i = 0; i < 200; ++i) governor.frameTook(0.005);
  EXPECT_EQ(governor.level(), DetailLevel::kCoarse);
  for (int i = 0; i < 200; ++i) governor.frameTook(0.005);
  EXPECT_LT(governor.level(), DetailLevel::kCoarse) << "but tried it is";
}

}  // namespace
}  // namespace hapticell::app
