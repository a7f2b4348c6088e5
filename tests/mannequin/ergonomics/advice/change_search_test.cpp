// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/change_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace hapticell::ergonomics {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two angles and a flag; the score adds 1 for each 10 degrees and 3 for the flag.
const std::vector<ChangeField> kFields = {
    {.name = "trunk", .from = 60.0, .values = {40.0, 20.0, 0.0}},
    {.name = "neck", .from = 20.0, .values = {10.0, 0.0}},
    {.name = "twisted", .is_flag = true, .unit = 1.0, .from = 1.0, .values = {0.0}}};

std::optional<double> sumOf(std::span<const double> values) {
  return values[0] / 10.0 + values[1] / 10.0 + 3.0 * values[2];
}

int levelOf(double score) {
  return static_cast<int>(std::ceil(score / 4.0));
}

TEST(ChangeSearch, ValuesAreSortedByTheirDistance) {
  EXPECT_THAT(nearestFirst({0.0, 10.0, 20.0, 45.0}, 20.0), ElementsAre(10.0, 0.0, 45.0));
  EXPECT_THAT(nearestFirst({5.0}, 5.0), IsEmpty());
}

TEST(ChangeSearch, SingleChangesComeByTheirEffectThenByTheirSize) {
  const std::vector<PostureDriver> found = singleChanges(kFields, sumOf);
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].change.field, "trunk");
  EXPECT_EQ(found[0].change.to, 0.0);
  EXPECT_EQ(found[0].score, 5.0);
  EXPECT_EQ(found[1].change.field, "twisted");
  EXPECT_EQ(found[1].score, 8.0);
  EXPECT_EQ(found[2].change.field, "neck");
  const std::vector<PostureDriver> steps = singleChanges(
      kFields, [](std::span<const double> values) { return std::optional<double>(values[0] < 50.0 ? 1.0 : 2.0); });
  ASSERT_THAT(steps, SizeIs(1)) << "a change without effect is none";
  EXPECT_EQ(steps[0].change.to, 40.0) << "of equal ones the nearest";
  EXPECT_THAT(singleChanges(kFields, [](std::span<const double>) { return std::optional<double>(); }), IsEmpty());
}

/// All combinations: fewest fields, then the smallest sum of changes.
std::optional<std::pair<std::size_t, double>> searchAll(const std::vector<ChangeField>& fields, int level) {
  std::optional<std::pair<std::size_t, double>> best;
  std::vector<std::vector<double>> choices;
  for (const ChangeField& field : fields) {
    choices.push_back({field.from});
    choices.back().insert(choices.back().end(), field.values.begin(), field.values.end());
  }
  for (const double a : choices[0]) {
    for (const double b : choices[1]) {
      for (const double c : choices[2]) {
        const std::vector<double> values = {a, b, c};
        if (levelOf(*sumOf(values)) >= level) continue;
        std::pair<std::size_t, double> found{0, 0.0};
        for (std::size_t i = 0; i < 3; ++i) {
          found.first += values[i] != fields[i].from ? 1u : 0u;
          found.second += std::abs(values[i] - fields[i].from) / fields[i].unit;
        }
        if (!best || found < *best) best = found;
      }
    }
  }
  return best;
}

TEST(ChangeSearch, TheNearestLowerLevelIsTheOneOfAllCombinations) {
  for (double trunk = 0.0; trunk <= 60.0; trunk += 5.0) {
    for (const double neck : {0.0, 15.0, 30.0}) {
      std::vector<ChangeField> fields = kFields;
      fields[0].from = trunk;
      fields[0].values = nearestFirst({0.0, 20.0, 40.0, 60.0}, trunk);
      fields[1].from = neck;
      fields[1].values = nearestFirst({0.0, 10.0, 20.0}, neck);
      const int level = levelOf(*sumOf(std::vector<double>{trunk, neck, 1.0}));
      const auto goal = nearestLowerLevel(fields, sumOf, levelOf);
      const auto expected = searchAll(fields, level);
      ASSERT_EQ(goal.has_value(), expected.has_value()) << trunk << ", " << neck;
      if (!goal) continue;
      double cost = 0.0;
      for (const FieldChange& change : goal->changes)
        cost += std::abs(change.to - change.from) / (change.is_flag ? 1.0 : 10.0);
      EXPECT_EQ(goal->changes.size(), expected->first) << trunk << ", " << neck;
      EXPECT_NEAR(cost, expected->second, 1e-12) << trunk << ", " << neck;
      EXPECT_LT(levelOf(goal->score), level);
    }
  }
}

TEST(ChangeSearch, GivesNothingWhereNoChangeLowersTheLevel) {
  EXPECT_FALSE(nearestLowerLevel(kFields, sumOf, [](double) { return 1; }).has_value());
  EXPECT_FALSE(nearestLowerLevel(
      {}, [](std::span<const double>) { return std::optional<double>(1.0); }, levelOf));
  // From 11 to 8 or less needs the flag (3) or the trunk; to 4 or less needs two: not with one.
  const LevelOf low = [](double score) { return score <= 2.0 ? 0 : 1; };
  EXPECT_FALSE(nearestLowerLevel(kFields, sumOf, low, 1).has_value());
  const auto both = nearestLowerLevel(kFields, sumOf, low, 2);
  ASSERT_TRUE(both.has_value());
  EXPECT_THAT(both->changes, SizeIs(2));
}

}  // namespace
}  // namespace hapticell::ergonomics
