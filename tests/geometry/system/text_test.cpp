// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/text.h"

#include <gtest/gtest.h>

#include <numbers>

namespace hapticell {
namespace {

TEST(Text, IsPlainEnglishInMillimetresAndDegrees) {
  EXPECT_EQ(english(Text("%1 is %2 from its upper limit", "A5", Text::Angle{std::numbers::pi / 180.0})),
            "A5 is 1.0 deg from its upper limit");
  EXPECT_EQ(english(Text("%1 is %2 from %3", "box", Text::Length{0.0154}, "table")), "box is 15.4 mm from table");
  EXPECT_EQ(english(Text("%1 away", Text::Length{0.0154, true})), "15 mm away");
  EXPECT_EQ(english(Text("%2 of %1", 7, 3)), "3 of 7");
}

TEST(Text, NamesMayHoldAnything) {
  EXPECT_EQ(english(Text("%1 touches %2", "%2", "100 %")), "%2 touches 100 %");
  EXPECT_EQ(english(Text::plain("50 %1 of it")), "50 %1 of it");
}

TEST(Text, APlaceWithoutAValueStays) {
  EXPECT_EQ(english(Text("%1 and %2 at 5 %", "a")), "a and %2 at 5 %");
  EXPECT_EQ(filled("%", {}), "%");
}

TEST(Text, NothingSaysNothing) {
  EXPECT_TRUE(Text().empty());
  EXPECT_TRUE(Text::plain("").empty());
  EXPECT_EQ(english(Text()), "");
}

TEST(Text, SeveralAreOneLine) {
  const std::vector<Text> texts{Text("%1 is free", "box"), Text("it rests")};
  EXPECT_EQ(english(texts), "box is free; it rests");
  EXPECT_EQ(english(std::vector<Text>()), "");
}

TEST(Text, IsTheSameWithTheSameIdAndArguments) {
  EXPECT_EQ(Text("%1 is free", "box"), Text("%1 is free", std::string("box")));
  EXPECT_NE(Text("%1 is free", "box"), Text("%1 is free", "table"));
  EXPECT_NE(Text("a"), Text());
}

}  // namespace
}  // namespace hapticell
