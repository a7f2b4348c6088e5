// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

#include "mannequin/ergonomics/scores/force_table.h"
#include "mannequin/ergonomics/scores/french_words.h"
#include "mannequin/ergonomics/scores/method_score.h"
#include "tests/support/test_data.h"

namespace hapticell::ergonomics {
namespace {

using ::testing::HasSubstr;

class ForceTables : public ::testing::Test {
 protected:
  Expected<ForceTable> read(const std::string& text) const { return readForceTable(folder_.write("forces.csv", text)); }
  std::string problem(const std::string& text) const {
    const auto table = read(text);
    return table ? std::string() : table.error().message();
  }
  hapticell::test::TemporaryFolder folder_;
};

TEST_F(ForceTables, TheLeastLimitOfAllRowsThatHoldCounts) {
  const auto table = read(
      "# source: our own measurements\nhand,height_from_m,height_to_m,reach_to_m,limit_n\n"
      "any,,,,200\nleft,1.0,1.5,,120\nright,1.0,1.5,0.4,150\n");
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->source, "our own measurements");
  EXPECT_EQ(table->rows.size(), 3u);
  EXPECT_EQ(table->limitAt(0, 1.2, 0.3), 120.0);
  EXPECT_EQ(table->limitAt(1, 1.2, 0.3), 150.0);
  EXPECT_EQ(table->limitAt(1, 1.2, 0.4), 200.0) << "the end of a range is not in it";
  EXPECT_EQ(table->limitAt(0, 1.0, 9.0), 120.0) << "its begin is";
  EXPECT_EQ(table->limitAt(0, 1.5, 0.3), 200.0);
  EXPECT_FALSE(ForceTable{}.limitAt(0, 1.0, 0.3)) << "nothing holds";
  EXPECT_TRUE(ForceTable{}.isEmpty());
}

TEST_F(ForceTables, WithoutASourceTheFilesNameIsIt) {
  const auto table = read("limit_n\n100\n");
  ASSERT_TRUE(table);
  EXPECT_THAT(table->source, HasSubstr("forces"));
}

TEST_F(ForceTables, WhatIsWrongIsRefusedByLineAndName) {
  EXPECT_THAT(problem("limit_n\n"), HasSubstr("line of values"));
  EXPECT_NE(problem(""), "");
  EXPECT_THAT(problem("limit_n,colour\n100,red\n"), HasSubstr("colour"));
  EXPECT_THAT(problem("limit_n\nmany\n"), HasSubstr("line 2"));
  for (const char* limit : {"0", "-5", "5001", "nan", "inf", ""}) {
    EXPECT_THAT(problem(std::string("hand,limit_n\nleft,") + limit + "\n"), HasSubstr("line 2")) << limit;
  }
  EXPECT_THAT(problem("hand,limit_n\nfoot,100\n"), HasSubstr("foot"));
  EXPECT_THAT(problem("height_from_m,height_to_m,limit_n\n1.5,1.0,100\n"), HasSubstr("line 2"));
  EXPECT_THAT(problem("hand\nleft\n"), HasSubstr("limit_n"));
}

TEST(FrenchWords, WhatIsNotKnownComesBackAsItIs) {
  EXPECT_EQ(french("no such words anywhere"), "no such words anywhere");
  EXPECT_EQ(french(""), "");
}

TEST(MethodScore, MethodsHaveNamesOfTheirOwnAndLevelsToStartFrom) {
  std::set<std::string_view> names;
  for (const PostureMethod method : kPostureMethods) {
    names.insert(nameOf(method));
    EXPECT_EQ(leastLevel(method), method == PostureMethod::kReba ? 0 : 1) << nameOf(method);
  }
  EXPECT_EQ(names.size(), kPostureMethods.size());
  EXPECT_EQ(nameOf(PostureMethod::kRula), "RULA");
  EXPECT_EQ(nameOf(PostureMethod::kEn1005), "EN 1005-4");
}

}  // namespace
}  // namespace hapticell::ergonomics
