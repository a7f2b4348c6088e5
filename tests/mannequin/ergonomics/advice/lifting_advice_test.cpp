// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/lifting_advice.h"

#include <gtest/gtest.h>

#include <map>

namespace hapticell::ergonomics {
namespace {

/// The task with a change in it.
LiftingTask with(LiftingTask task, const LiftingChange& change) {
  const std::map<std::string_view, double LiftingTask::*> fields{{"h_cm", &LiftingTask::h_cm},
                                                                 {"v_cm", &LiftingTask::v_cm},
                                                                 {"d_cm", &LiftingTask::d_cm},
                                                                 {"asymmetry_deg", &LiftingTask::asymmetry_deg},
                                                                 {"frequency_per_min", &LiftingTask::frequency_per_min},
                                                                 {"load_kg", &LiftingTask::load_kg}};
  if (change.field == "coupling") {
    task.coupling = static_cast<Coupling>(change.to);
  } else {
    task.*fields.at(change.field) = change.to;
  }
  return task;
}

LiftingAdvice adviceOf(const LiftingTask& task) {
  return adviseLift(task, *lift(task));
}

double indexOf(const LiftingTask& task) {
  return lift(task)->lifting_index.value_or(1e9);
}

// 10 kg at H 40, V 30, D 70, A 30, 2 a minute, up to 2 h, poor: limit 7.515 kg, index 1.331.
constexpr LiftingTask kTwisted{10, 40, 30, 70, 30, 2, 2, Coupling::kPoor};

TEST(LiftingAdvice, TheMultipliersThatCostMostComeFirst) {
  const LiftingAdvice advice = adviceOf(kTwisted);
  EXPECT_EQ(advice.level, 2);
  EXPECT_EQ(advice.target, 1.0);
  ASSERT_EQ(advice.drivers.size(), 6u);
  EXPECT_EQ(advice.drivers[0].multiplier, "HM");
  EXPECT_NEAR(advice.drivers[0].value, 0.625, 1e-12);
  EXPECT_NEAR(*advice.drivers[0].index, 1.3307 * 0.625, 1e-3);
  for (std::size_t i = 1; i < advice.drivers.size(); ++i)
    EXPECT_GE(advice.drivers[i].value, advice.drivers[i - 1].value);
}

TEST(LiftingAdvice, EachChangeAloneIsEnoughAndNoLargerThanNeeded) {
  const LiftingAdvice advice = adviceOf(kTwisted);
  ASSERT_EQ(advice.alone.size(), 2u) << "only the hands nearer, or less weight: no other multiplier is under 0.751";
  EXPECT_EQ(advice.alone[0].field, "h_cm");
  EXPECT_NEAR(advice.alone[0].to, 30.0, 0.11) << "25 / (0.625 * 1.3307) cm";
  EXPECT_EQ(advice.alone[1].field, "load_kg");
  EXPECT_NEAR(advice.alone[1].to, 7.5, 1e-9);
  for (const LiftingChange& change : advice.alone) {
    EXPECT_LE(indexOf(with(kTwisted, change)), 1.0);
    EXPECT_NEAR(indexOf(with(kTwisted, change)), *change.index, 1e-12);
    LiftingChange less = change;
    less.to += 0.2;
    EXPECT_GT(indexOf(with(kTwisted, less)), 1.0) << change.field;
  }
  EXPECT_TRUE(advice.together.empty());
}

TEST(LiftingAdvice, WhereNoneIsEnoughSeveralGoTogether) {
  LiftingTask heavy = kTwisted;
  heavy.load_kg = 20.0;
  heavy.frequency_per_min = 0.2;
  const LiftingAdvice advice = adviceOf(heavy);
  EXPECT_EQ(advice.level, 2);
  ASSERT_EQ(advice.alone.size(), 1u);
  EXPECT_EQ(advice.alone[0].field, "load_kg");
  ASSERT_GE(advice.together.size(), 2u);
  LiftingTask changed = heavy;
  for (const LiftingChange& change : advice.together) {
    EXPECT_GT(indexOf(changed), 1.0) << "the one before was not enough";
    changed = with(changed, change);
  }
  EXPECT_LE(indexOf(changed), 1.0);
}

TEST(LiftingAdvice, WhatNobodyMayLiftComesBackIntoTheEquationsReach) {
  LiftingTask far = kTwisted;
  far.h_cm = 70.0;
  const LiftingAdvice advice = adviceOf(far);
  EXPECT_EQ(advice.level, 3);
  EXPECT_EQ(advice.target, 3.0);
  ASSERT_FALSE(advice.alone.empty());
  EXPECT_EQ(advice.alone[0].field, "h_cm");
  EXPECT_LE(advice.alone[0].to, 63.0);
  EXPECT_LE(indexOf(with(far, advice.alone[0])), 3.0);
}

TEST(LiftingAdvice, AnEasyLiftNeedsNothing) {
  const LiftingAdvice advice = adviceOf({5, 25, 75, 25, 0, 0.2, 1, Coupling::kGood});
  EXPECT_EQ(advice.level, 1);
  EXPECT_TRUE(advice.drivers.empty() && advice.alone.empty() && advice.together.empty());
}

TEST(LiftingAdvice, OneOfSeveralTasksIsChangedForTheWhole) {
  const std::vector<LiftingTask> tasks{kTwisted, {8, 30, 75, 25, 0, 2, 2, Coupling::kGood}};
  const LiftingIndex whole = [&](const LiftingTask& changed) -> std::optional<double> {
    return compositeLift(std::vector<LiftingTask>{changed, tasks[1]})->index;
  };
  const LiftingAdvice advice = adviseLift(tasks[0], *lift(tasks[0]), whole);
  EXPECT_EQ(advice.level, 2);
  for (const LiftingChange& change : advice.alone) EXPECT_LE(*whole(with(tasks[0], change)), 1.0) << change.field;
  EXPECT_GT(*whole(tasks[0]), *lift(tasks[0])->lifting_index);
}

}  // namespace
}  // namespace hapticell::ergonomics
