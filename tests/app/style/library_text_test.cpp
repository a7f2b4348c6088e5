// SPDX-License-Identifier: Apache-2.0
#include "app/style/library_text.h"

#include <gtest/gtest.h>

#include "app/host/language.h"
#include "app/style/plain_lines.h"

namespace hapticell::app {
namespace {

TEST(LibraryText, IsWordForWordInEnglishButForItsUnits) {
  EXPECT_EQ(shownText("A5 is 1.2 deg from its upper limit"), "A5 is 1.2° from its upper limit");
  EXPECT_EQ(shownText("slide is 12.5 mm from its lower limit"), "slide is 12.5 mm from its lower limit");
  EXPECT_EQ(shownText("Gripper G2 is 6.4 mm from Clamp tower B"), "Gripper G2 is 6.4 mm from Clamp tower B");
  EXPECT_EQ(shownText("robot touches table; A2 is 0.3 deg from its lower limit"),
            "robot touches table; A2 is 0.3° from its lower limit");
  EXPECT_EQ(shownText(""), "");
}

TEST(LibraryText, WhatIsNotKnownStaysAsItIs) {
  for (const char* sentence : {"door_left.stl is cut short", "100 %1 of %2", "A is NaN mm from B", "\\(.+)*?{s}"})
    EXPECT_EQ(shownText(sentence), sentence);
}

TEST(LibraryText, NamesMayHoldAnything) {
  EXPECT_EQ(shownText("%2 {s} touches %1"), "%2 {s} touches %1");
  EXPECT_EQ(shownText("part is free is free"), "part is free is free");
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
                            "No haptic server answers at %1. Start hapticell-haptic-server."})
    EXPECT_FALSE(french.translate("LibraryText", known, nullptr, -1).isEmpty()) << known;
}

}  // namespace
}  // namespace hapticell::app
