// SPDX-License-Identifier: Apache-2.0
#include "feel/benchmark.h"

#include <gtest/gtest.h>

#include <cmath>

#include "feel/feel_session.h"

namespace hapticell::feel {
namespace {

BenchmarkOptions only(const std::string& what) {
  BenchmarkOptions options;
  options.only = what;
  return options;
}

TEST(Figure, JudgesByItsLimit) {
  Figure most{"M1", "s", "r", "N", 0.1, 0.1};
  EXPECT_TRUE(most.pass());
  most.value = 0.1001;
  EXPECT_FALSE(most.pass());
  Figure least{"M3", "s", "r", "mJ", -0.4, -0.5, true};
  EXPECT_TRUE(least.pass());
  least.value = std::nan("");
  EXPECT_FALSE(least.pass());
  least.limit.reset();
  EXPECT_FALSE(least.pass()) << "what was not measured does not pass";
}

TEST(Benchmark, GivesTheSameTwiceAndPassesAtTheHinge) {
  const auto first = runBenchmark(only("hinge with stop"));
  const auto second = runBenchmark(only("Hinge with stop"));
  ASSERT_TRUE(first.has_value()) << first.error().message();
  ASSERT_TRUE(second.has_value());
  ASSERT_EQ(first->size(), second->size());
  ASSERT_FALSE(first->empty());
  for (std::size_t i = 0; i < first->size(); ++i) {
    EXPECT_EQ((*first)[i].value, (*second)[i].value);
    EXPECT_TRUE((*first)[i].pass()) << (*first)[i].id << " " << (*first)[i].value;
  }
}

TEST(Benchmark, ShowsWhatTheClassicWayLoses) {
  const auto figures = runBenchmark(only("corner of three planes"));
  ASSERT_TRUE(figures.has_value());
  bool seen = false;
  for (const Figure& figure : *figures) {
    if (figure.id != "M2.penetration") continue;
    seen = true;
    EXPECT_LE(figure.value, 0.05);
    ASSERT_TRUE(figure.classic.has_value());
    EXPECT_GT(*figure.classic, 1.0);
  }
  EXPECT_TRUE(seen);
}

/// Teeth whose ridges are equally high: the roof over one ridge must not be taken for the free room over another.
TEST(Benchmark, EntersNoToothOfARack) {
  const auto figures = runBenchmark(only("toothed rack"));
  ASSERT_TRUE(figures.has_value());
  int seen = 0;
  for (const Figure& figure : *figures) {
    if (!figure.limit) continue;
    ++seen;
    EXPECT_TRUE(figure.pass()) << figure.id << " " << figure.value;
  }
  EXPECT_EQ(seen, 4);
}

/// A plan that changes ten times a second, in any direction, at the greatest authority.
TEST(Benchmark, AChangingPlanIsNotFeltAsJumps) {
  for (const char* scene : {"flat wall, changing plan", "corner of three planes, changing plan",
                            "hinge with stop, changing plan"}) {
    const auto figures = runBenchmark(only(scene));
    ASSERT_TRUE(figures.has_value());
    ASSERT_EQ(figures->size(), 21U) << "M1 to M4 and the pull at three rates";
    for (const Figure& figure : *figures)
      EXPECT_TRUE(figure.pass()) << figure.id << " " << figure.rate << ": " << figure.value;
  }
}

TEST(Benchmark, ChoosesOneFigure) {
  const auto figures = runBenchmark(only("m10.released"));
  ASSERT_TRUE(figures.has_value());
  ASSERT_EQ(figures->size(), 1U);
  EXPECT_EQ(figures->front().id, "M10.released");
}

TEST(Benchmark, RefusesAnUnknownName) {
  const auto figures = runBenchmark(only("no such scene"));
  ASSERT_FALSE(figures.has_value());
  EXPECT_NE(figures.error().message().find("flat wall"), std::string::npos);
}

TEST(FeelScenes, TheRobotsJointLimitIsFelt) {
  const auto scene = jointLimitScene();
  ASSERT_TRUE(scene.has_value()) << scene.error().message();
  FeelSession session(**scene, {kRates[0]});
  touchAndSlide(session, **scene, 1.0);
  EXPECT_GT(session.figures().force_max, 1.5);
  EXPECT_LT(session.figures().penetration, 0.05e-3);
}

TEST(FeelScenes, AConveyorIsForeseenOverTheLatency) {
  const auto scene = driftingScene(cylinderScene(0.05), {0.2, 0.0, 0.0}, 0.5);
  FeelSession slow(*scene, {kRates[0]}), quick(*scene, {kRates[2]});
  touchAndSlide(slow, *scene, 0.5);
  touchAndSlide(quick, *scene, 0.5);
  EXPECT_GT(slow.figures().contact_ticks, 300);
  EXPECT_LT(slow.figures().depth_error_p95, 0.01);
  EXPECT_NEAR(slow.figures().force_max, quick.figures().force_max, 0.02);
}

TEST(FeelScenes, AScaleOfTheCellIsNotFelt) {
  const auto scaled = scaledScene(cylinderScene(0.5), cylinderScene(0.05), 10.0);
  const auto plain = cylinderScene(0.05);
  FeelSession through(*scaled, {kRates[1]}), direct(*plain, {kRates[1]});
  touchAndSlide(through, *scaled, 0.5);
  touchAndSlide(direct, *plain, 0.5);
  EXPECT_NEAR(glm::distance(through.last().force_D, direct.last().force_D), 0.0, 1e-3);
}

}  // namespace
}  // namespace hapticell::feel
