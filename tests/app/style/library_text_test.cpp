// SPDX-License-Identifier: Apache-2.0
#include "app/style/library_text.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/host/language.h"
#include "app/style/plain_lines.h"

namespace hapticell::app {
namespace {

TEST(LibraryText, IsWordForWordInEnglishButForItsUnits) {
  const Text::Angle angle{1.2 * std::numbers::pi / 180.0};
  EXPECT_EQ(shownText(Text("%1 is %2 from its upper limit", "A5", angle)), "A5 is 1.2° from its upper limit");
  EXPECT_EQ(shownText(Text("%1 is %2 from its lower limit", "slide", Text::Length{0.0125})),
            "slide is 12.5 mm from its lower limit");
  EXPECT_EQ(shownText(Text("The left hand is %1 from the end of its reach", Text::Length{0.013, true})),
            "The left hand is 13 mm from the end of its reach");
  const std::vector<Text> both{Text("%1 touches %2", "robot", "table"), Text("%1 moves as fast as it can", "A2")};
  EXPECT_EQ(shownText(both), "robot touches table; A2 moves as fast as it can");
  EXPECT_EQ(shownText(Text()), "");
}

TEST(LibraryText, AProblemOfTheLinkIsSaidWithWhatHelps) {
  const Text what("No haptic server answers at %1.", "station:4747");
  EXPECT_EQ(shownText(haptic::LinkProblem{what, Text("Start hapticell-haptic-server.")}),
            "No haptic server answers at station:4747. Start hapticell-haptic-server.");
  EXPECT_EQ(shownText(haptic::LinkProblem{what}), "No haptic server answers at station:4747.");
  EXPECT_EQ(shownText(haptic::LinkProblem()), "");
}

TEST(LibraryText, NamesMayHoldAnything) {
  EXPECT_EQ(shownText(Text("%1 touches %2", "%2", "100 %1")), "%2 touches 100 %1");
  EXPECT_EQ(shownText(Text::plain("100 %1 of %2")), "100 %1 of %2");
}

TEST(LibraryText, LinesOfOthersAreDrawnAsWhatTheyAre) {
  EXPECT_EQ(plainLines("door\n12:00 warning: FORGED"), "door 12:00 warning: FORGED");
  EXPECT_EQ(plainLines("a\nb\x1B[2Jc", 2), "a\nb [2Jc");
  EXPECT_EQ(plainLines("a\nb\nc", 2), "a\nb\n...");
  EXPECT_EQ(plainLines(QStringLiteral("x\u202Ey")), QStringLiteral("x\uFFFDy"));
}

TEST(LibraryText, IsFrenchInFrench) {
  Translator french;
  if (!french.loadLanguage("fr")) GTEST_SKIP() << "built without Qt's Linguist tools";
  for (const char* known : {"%1 is %2 from its upper limit", "%1 touches %2", "The arm is near a singularity",
                            "No haptic server answers at %1."})
    EXPECT_FALSE(french.translate("LibraryText", known, nullptr, -1).isEmpty()) << known;
}

}  // namespace
}  // namespace hapticell::app
