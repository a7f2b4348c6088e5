// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/methods/scored_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <tuple>

#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"

namespace hapticell::ergonomics {
namespace {

/// Calls `visit` with every combination of the sub-scores before `count`; the others stay at their least.
void forAll(const ScoredMethod& method, std::size_t count, const std::function<void(const std::vector<int>&)>& visit) {
  std::vector<int> values;
  for (const SubScore& sub_score : method.subScores()) values.push_back(sub_score.least);
  for (;;) {
    visit(values);
    std::size_t i = 0;
    while (i < count && ++values[i] > method.subScores()[i].greatest) {
      values[i] = method.subScores()[i].least;
      ++i;
    }
    if (i == count) return;
  }
}

std::map<int, int> histogram(const ScoredMethod& method, std::size_t count) {
  std::map<int, int> scores;
  forAll(method, count, [&](const std::vector<int>& values) { ++scores[method.score(values)]; });
  return scores;
}

// Counts over the whole input space: any wrong cell of a table changes them.
TEST(ScoredMethod, TablesHaveThePublishedCounts) {
  EXPECT_EQ(histogram(Rula(), 7),
            (std::map<int, int>{{1, 1}, {2, 43}, {3, 872}, {4, 992}, {5, 1397}, {6, 3525}, {7, 3538}}));
  EXPECT_EQ(histogram(Reba(), 9), (std::map<int, int>{{1, 64},
                                                      {2, 255},
                                                      {3, 952},
                                                      {4, 2841},
                                                      {5, 3964},
                                                      {6, 5874},
                                                      {7, 7952},
                                                      {8, 10607},
                                                      {9, 15217},
                                                      {10, 20432},
                                                      {11, 22344},
                                                      {12, 21112},
                                                      {13, 15315},
                                                      {14, 7999},
                                                      {15, 3312}}));
  EXPECT_EQ(histogram(Owas(), 4), (std::map<int, int>{{1, 72}, {2, 53}, {3, 55}, {4, 72}}));
}

/// The sum of all cells of each table that any input leads to.
std::map<std::string, int> cellSums(const ScoredMethod& method, std::size_t count) {
  std::map<std::tuple<std::string, int, int, int, int>, int> cells;
  forAll(method, count, [&](const std::vector<int>& values) {
    for (const TableEntry& entry : method.evaluate(values).entries) {
      const auto [cell, is_new] = cells.try_emplace(
          {std::string(entry.table), entry.row, entry.row_part, entry.column, entry.column_part}, entry.value);
      EXPECT_EQ(cell->second, entry.value) << "one cell, one value";
    }
  });
  std::map<std::string, int> sums;
  for (const auto& [cell, value] : cells) sums[std::get<0>(cell)] += value;
  return sums;
}

TEST(ScoredMethod, TablesHaveTheKnownChecksums) {
  EXPECT_EQ(cellSums(Rula(), 7), (std::map<std::string, int>{{"A", 705}, {"B", 438}, {"C", 269}}));
  EXPECT_EQ(cellSums(Reba(), 9), (std::map<std::string, int>{{"A", 321}, {"B", 177}, {"C", 1192}}));
  int owas = 0;
  forAll(Owas(), 4, [&](const std::vector<int>& values) { owas += Owas().score(values); });
  EXPECT_EQ(owas, 631);
}

TEST(ScoredMethod, NoRaisedSubScoreLowersTheScore) {
  const Rula rula;
  const Reba reba;
  for (const ScoredMethod* method :
       {static_cast<const ScoredMethod*>(&rula), static_cast<const ScoredMethod*>(&reba)}) {
    int falls = 0;
    // RULA's muscle use and force only add to table C's row and column, which its posture sub-scores go through too.
    const std::size_t count = method == &rula ? 7 : 9;
    forAll(*method, count, [&](std::vector<int> values) {
      const int score = method->score(values);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] == method->subScores()[i].greatest) continue;
        ++values[i];
        falls += method->score(values) < score ? 1 : 0;
        --values[i];
      }
    });
    EXPECT_EQ(falls, 0) << method->name();
  }
}

TEST(ScoredMethod, EvaluationAgreesWithScoreAndNamesItsCells) {
  const Rula rula;
  const std::vector<int> values{4, 2, 3, 1, 3, 4, 2, 1, 1, 0, 2};
  const Evaluation evaluation = rula.evaluate(values);
  EXPECT_EQ(evaluation.score, rula.score(values));
  ASSERT_EQ(evaluation.entries.size(), 3u);
  EXPECT_EQ(evaluation.entries[0].table, "A");
  EXPECT_EQ(evaluation.entries[0].row, 4);
  EXPECT_EQ(evaluation.entries[0].row_part, 2);
  EXPECT_EQ(evaluation.entries[0].value, 4);
  EXPECT_EQ(evaluation.entries[1].value, 6);  // neck 3, trunk 4, legs 2
  EXPECT_EQ(evaluation.entries[2].row, 6);
  EXPECT_EQ(evaluation.entries[2].column, 7);
  EXPECT_EQ(evaluation.entries[2].value, 7);
}

TEST(ScoredMethod, MissingInputsAreNeverCountedAsNothing) {
  const Rula rula;
  std::vector<std::optional<int>> values{2, 1, 1, 1, 1, 2, 1, 0, 0, 0, 0};
  const Assessment whole = assess(rula, values);
  EXPECT_FALSE(whole.isPartial());
  EXPECT_EQ(whole.least_score, whole.greatest_score);
  values[Rula::kTrunk].reset();
  const Assessment without_trunk = assess(rula, values);
  EXPECT_TRUE(without_trunk.isPartial());
  EXPECT_FALSE(without_trunk.score.has_value());
  EXPECT_LT(without_trunk.least_score, without_trunk.greatest_score);
  values[Rula::kTrunk] = 2;
  values[Rula::kForceArm].reset();
  const Assessment without_force = assess(rula, values);
  ASSERT_TRUE(without_force.score.has_value());
  EXPECT_EQ(*without_force.score, without_force.least_score);
  EXPECT_GT(without_force.greatest_score, without_force.least_score);
  EXPECT_EQ(without_force.missing, std::vector<std::string_view>{"force_arm"});
}

TEST(ScoredMethod, DriversLowerTheScoreAndNextLevelIsTheSmallestChange) {
  const Reba reba;
  const std::vector<std::optional<int>> values{2, 4, 2, 3, 2, 2, 1, 1, 1};
  const Assessment assessment = assess(reba, values);
  ASSERT_FALSE(assessment.drivers.empty());
  for (const Driver& driver : assessment.drivers) EXPECT_LT(driver.score, *assessment.score);
  ASSERT_TRUE(assessment.next_level.has_value());
  EXPECT_LT(assessment.next_level->level, *assessment.level);
  // No single change by one step does it unless that is what was found.
  int smallest = 1000;
  forAll(reba, reba.subScores().size(), [&](const std::vector<int>& other) {
    int changed = 0;
    for (std::size_t i = 0; i < other.size(); ++i) {
      if (other[i] > *values[i]) return;
      changed += other[i] != *values[i] ? 1 : 0;
    }
    if (reba.levelOf(reba.score(other)) < *assessment.level) smallest = std::min(smallest, changed);
  });
  EXPECT_EQ(static_cast<int>(assessment.next_level->changes.size()), smallest);
}

}  // namespace
}  // namespace hapticell::ergonomics
