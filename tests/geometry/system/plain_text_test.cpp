// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/plain_text.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/system/error.h"

namespace hapticell {
namespace {

TEST(PlainText, LeavesWordsOfAllScriptsAsTheyAre) {
  for (const char* text :
       {"", "arm 7", "Kühlplatte Ø 8 ± 0,1", "機械", "пресс", "می‌خواهم", "100 % </b>", "😀"})
    EXPECT_EQ(plainText(text), text);
}

TEST(PlainText, IsOneLineThatNoTerminalObeys) {
  EXPECT_EQ(plainText("x\n12:00:00.000 warning: FORGED"), "x 12:00:00.000 warning: FORGED");
  EXPECT_EQ(plainText("a\r\tb\x1B[2Jc\x07\x7F"), "a  b [2Jc  ");
  EXPECT_EQ(plainText(std::string_view("a\0b", 3)), "a b");
  EXPECT_EQ(plainText("a\xC2\x9B"
                      "31mb\xC2\x85"),
            "a 31mb ")
      << "C1: the eight-bit CSI and NEL";
  EXPECT_EQ(plainText("a\xE2\x80\xA8"
                      "b\xE2\x80\xA9"),
            "a b ")
      << "line and paragraph separators";
}

TEST(PlainText, ShowsWhatTurnsOrHides) {
  EXPECT_EQ(plainText("exe.\xE2\x80\xAEgnp"), "exe.\xEF\xBF\xBDgnp") << "right-to-left override";
  for (const char* mark : {"\xD8\x9C", "\xE2\x80\x8E", "\xE2\x80\x8F", "\xE2\x80\xAA", "\xE2\x81\xA6", "\xE2\x81\xA9",
                           "\xE2\x80\x8B", "\xEF\xBB\xBF", "\xC2\xAD", "\xF3\xA0\x81\x81"})
    EXPECT_EQ(plainText(mark), "\xEF\xBF\xBD");
}

TEST(PlainText, IsValidHoweverBent) {
  const std::string unknown = "\xEF\xBF\xBD";
  EXPECT_EQ(plainText("a\xFF"
                      "b"),
            "a" + unknown + "b");
  EXPECT_EQ(plainText("\xC0\x8A"), unknown + unknown) << "a newline in two bytes";
  EXPECT_EQ(plainText("\xE0\x80\x8A"), unknown);
  EXPECT_EQ(plainText("\xED\xA0\x80"), unknown) << "half of a pair";
  EXPECT_EQ(plainText("\xF4\x90\x80\x80"), unknown) << "over U+10FFFF";
  EXPECT_EQ(plainText("\xE6\xA9"), unknown) << "cut within";
}

TEST(PlainText, IsCutBetweenCharacters) {
  EXPECT_EQ(plainText("abcdef", 6), "abcdef");
  EXPECT_EQ(plainText("abcdefg", 6), "abcdef...");
  EXPECT_EQ(plainText("abcde\xC3\xA4", 6), "abcde...");
}

TEST(PlainText, TwiceIsTheSameAndNeverAControlCharacter) {
  std::mt19937 random(29);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 40);
  for (int i = 0; i < 20'000; ++i) {
    std::string text(static_cast<std::size_t>(length(random)), ' ');
    for (char& c : text) c = static_cast<char>(byte(random) % (i % 2 == 0 ? 256 : 128));
    const std::string once = plainText(text, 20);
    EXPECT_EQ(plainText(once, 20), once);
    EXPECT_LE(once.size(), 23u);
    for (const unsigned char c : once) EXPECT_TRUE(c >= 0x20 && c != 0x7F);
  }
}

TEST(PlainText, StandsInEveryPartOfAnError) {
  const Error error{.file = "a\nb.stl", .place = "line\n1", .found = "x\x1B[31m", .expected = "y\r", .fix = "Do\nit."};
  EXPECT_EQ(error.message(), "a b.stl, line 1: x [31m; expected y . Do it.");
}

}  // namespace
}  // namespace hapticell
