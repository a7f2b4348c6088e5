// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/subcommand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace hapticell::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A command "do" with whatever options a test gives it.
class SubcommandTest : public ::testing::Test {
 protected:
  /// What CLI11 has against `words` behind "do"; empty: nothing.
  std::string refusal(std::vector<std::string> words) {
    words.insert(words.begin(), "do");
    std::reverse(words.begin(), words.end());  // As CLI11 wants a vector of them.
    try {
      app_.parse(words);
    } catch (const CLI::ParseError& problem) {
      return problem.what();
    }
    return {};
  }

  CLI::App app_;
  Subcommand command_ = Subcommand(app_).add("do", "something");
};

TEST_F(SubcommandTest, ValuesAreReadAndOthersKept) {
  std::string file;
  std::optional<double> speed;
  std::optional<std::string> name;
  int count = 7;
  bool all = false;
  command_.option("file", file, "").required();
  command_.option("--speed", speed, "");
  command_.option("-n,--name", name, "");
  command_.option("--count", count, "");
  command_.flag("--all", all, "");
  EXPECT_EQ(refusal({"a.csv", "--speed", "0.25", "--all"}), "");
  EXPECT_EQ(file, "a.csv");
  EXPECT_EQ(speed, 0.25);
  EXPECT_EQ(name, std::nullopt);
  EXPECT_EQ(count, 7);
  EXPECT_TRUE(all);
}

TEST_F(SubcommandTest, WhatIsRequiredMustBeThere) {
  std::string file;
  command_.option("--file", file, "").required();
  EXPECT_THAT(refusal({}), HasSubstr("--file"));
}

TEST_F(SubcommandTest, NumbersStayWithinTheirBoundsAndAreNumbers) {
  double length = 0.0;
  command_.option("--length", length, "").within(0.5, 2.0);
  for (const char* good : {"0.5", "1e0", "2"}) EXPECT_EQ(refusal({"--length", good}), "") << good;
  EXPECT_EQ(length, 2.0);
  for (const char* bad : {"0.49", "2.01", "nan", "inf", "1,5", "one", ""})
    EXPECT_THAT(refusal({std::string("--length=") + bad}), HasSubstr("--length")) << bad;
  EXPECT_THAT(refusal({"--length", "3"}), HasSubstr("'3' found, a number from 0.5 to 2 expected"));
}

TEST_F(SubcommandTest, WholeNumbersAndWordsAreThoseThatAreNamed) {
  int score = 0;
  std::string language;
  command_.option("--score", score, "").withinWhole(0, 3);
  command_.option("--language", language, "").among({"en", "fr"});
  EXPECT_EQ(refusal({"--score", "3", "--language", "fr"}), "");
  EXPECT_EQ(score, 3);
  EXPECT_EQ(language, "fr");
  EXPECT_THAT(refusal({"--score", "4"}), HasSubstr("--score"));
  EXPECT_THAT(refusal({"--score", "1.5"}), HasSubstr("--score"));
  EXPECT_THAT(refusal({"--language", "de"}), HasSubstr("--language"));
}

TEST_F(SubcommandTest, WholeNumbersAreDecimalAndCountsAreNotNegative) {
  std::size_t first = 5;
  int shift = 0;
  std::optional<int> seed;
  command_.option("--first", first, "");
  command_.option("--shift", shift, "");
  command_.option("--seed", seed, "");
  EXPECT_EQ(refusal({"--first", "007", "--shift", "-12", "--seed=+010"}), "");
  EXPECT_EQ(first, 7U);
  EXPECT_EQ(shift, -12);
  EXPECT_EQ(seed, 10) << "not octal";
  EXPECT_EQ(refusal({"--first", "18446744073709551615"}), "");
  EXPECT_EQ(first, 18446744073709551615U);
  EXPECT_THAT(refusal({"--first", "-1"}), HasSubstr("--first: '-1' found, a whole number from 0 expected"));
  for (const char* bad : {"-1", "-0", "1.5", "0x10", " 3", "one", "+", "+-1", "18446744073709551616"})
    EXPECT_THAT(refusal({std::string("--first=") + bad}), HasSubstr("--first: '" + std::string(bad) + "'")) << bad;
  for (const char* bad : {"1.5", "0x10", "-", "+-1", "2147483648", "-2147483649"}) {
    EXPECT_THAT(refusal({std::string("--shift=") + bad}), HasSubstr("--shift: '" + std::string(bad) + "'")) << bad;
    EXPECT_THAT(refusal({std::string("--seed=") + bad}), HasSubstr("--seed: '" + std::string(bad) + "'")) << bad;
  }
  for (const char* name : {"--first", "--shift", "--seed"})
    EXPECT_THAT(refusal({std::string(name) + "="}), HasSubstr(name)) << "an empty word is no number";
  EXPECT_EQ(first, 18446744073709551615U) << "refused words change nothing";
  EXPECT_EQ(refusal({"--shift=-2147483648"}), "");
}

TEST_F(SubcommandTest, ListsAreSplitAndCounted) {
  std::vector<double> rise;
  std::vector<std::string> add, files;
  command_.option("--rise", rise, "").separatedByCommas().values(3);
  command_.option("--add", add, "").oneAtATime();
  command_.option("--files", files, "").values(1, -1);
  EXPECT_EQ(refusal({"--rise", "0,0.1,0.02", "--add", "a,b", "--add", "c", "--files", "x", "y"}), "");
  EXPECT_THAT(rise, ElementsAre(0.0, 0.1, 0.02));
  EXPECT_THAT(add, ElementsAre("a,b", "c"));
  EXPECT_THAT(files, ElementsAre("x", "y"));
  EXPECT_THAT(refusal({"--rise", "0,0.1"}), HasSubstr("--rise"));
  EXPECT_NE(refusal({"--add", "a", "b"}), "") << "a second value without its own --add";
}

TEST_F(SubcommandTest, WhatExcludesEachOtherIsNotTakenTogether) {
  double simplify = 0.0;
  bool hull = false;
  const Option first = command_.option("--simplify", simplify, "");
  command_.flag("--hull", hull, "").excludes(first);
  EXPECT_EQ(refusal({"--hull"}), "");
  EXPECT_THAT(refusal({"--hull", "--simplify", "1"}), HasSubstr("excludes"));
}

TEST_F(SubcommandTest, OnlyTheChosenOneIsCalledAndAWordBelowMustFollow) {
  int called = 0;
  Subcommand below = command_.add("now", "at once");
  command_.mustGoOn();
  below.onChosen([&] { ++called; });
  Subcommand(app_).add("rest", "nothing").onChosen([&] { called += 100; });
  EXPECT_NE(refusal({}), "");
  EXPECT_EQ(called, 0);
  EXPECT_EQ(refusal({"now"}), "");
  EXPECT_EQ(called, 1);
}

}  // namespace
}  // namespace hapticell::cli
