// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "mannequin/motion/c3d_numbers.h"
#include "mannequin/motion/word_reader.h"

namespace hapticell::mannequin {
namespace {

TEST(WordReader, WordsComeWithTheirLinesWhateverEndsThem) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string text = std::string(
                                 "\xEF\xBB\xBF"
                                 "HIERARCHY") +
                             end + end + "  ROOT\tHips " + end + "{";
    WordReader reader(text);
    EXPECT_EQ(reader.next(), "HIERARCHY");
    EXPECT_EQ(english(reader.place()), "line 1");
    EXPECT_EQ(reader.peek(), "ROOT");
    EXPECT_EQ(english(reader.place()), "line 1") << "peeking takes nothing";
    EXPECT_EQ(reader.next(), "ROOT");
    EXPECT_EQ(english(reader.place()), "line 3");
    EXPECT_EQ(reader.next(), "Hips");
    EXPECT_FALSE(reader.atEnd());
    EXPECT_TRUE(reader.take('{'));
    EXPECT_EQ(english(reader.place()), "line 4");
    EXPECT_TRUE(reader.atEnd());
    EXPECT_EQ(reader.next(), "");
    EXPECT_FALSE(reader.take('}'));
  }
}

TEST(WordReader, LinesAndWhatStandsBeforeAMark) {
  WordReader reader("name value  with blanks  \nkey one : two\n\n  third line");
  EXPECT_EQ(reader.next(), "name");
  EXPECT_EQ(reader.restOfLine(), " value  with blanks  ");
  EXPECT_EQ(reader.nextBefore(':'), "key one");
  EXPECT_TRUE(reader.take(':'));
  EXPECT_EQ(reader.nextBefore(':'), "two") << "or the line's end";
  EXPECT_EQ(reader.nextLine(), "third line");
  EXPECT_EQ(reader.nextLine(), "");
}

TEST(WordReader, NumbersAreFiniteAndOfABelievableSize) {
  EXPECT_EQ(WordReader::numberOf("-1.5e2"), -150.0);
  EXPECT_NEAR(WordReader::numberOf("1e-310").value_or(1.0), 0.0, 1e-300) << "rounded-off angles are written like that";
  EXPECT_EQ(WordReader::numberOf("0." + std::string(400, '0') + "1"), 0.0);
  for (const char* none : {"", "1,5", "nan", "inf", "1.5x", "1e10", "-1e999", "1e999", "0x1", "+1", "--1", "1 2"}) {
    EXPECT_FALSE(WordReader::numberOf(none)) << none;
  }
  EXPECT_FALSE(WordReader::numberOf(std::string(400, '9'))) << "too large for a double, and not zero";
  WordReader reader("1 two 3");
  EXPECT_EQ(reader.number(), 1.0);
  EXPECT_FALSE(reader.number());
  EXPECT_EQ(reader.number(), 3.0) << "what is none is taken as well";
}

TEST(WordReader, WhatIsNoTextIsSaid) {
  EXPECT_TRUE(whyNoText("HIERARCHY\nROOT").empty());
  EXPECT_TRUE(whyNoText("").empty());
  EXPECT_NE(english(whyNoText("\xFF\xFEH")).find("UTF-16"), std::string::npos);
  EXPECT_FALSE(whyNoText(std::string("a\0b", 3)).empty());
}

std::string bytesOfWord(std::uint16_t word, bool big) {
  const char low = static_cast<char>(word & 0xff), high = static_cast<char>(word >> 8);
  return big ? std::string{high, low} : std::string{low, high};
}

TEST(C3dNumbers, WholeNumbersFollowTheProcessor) {
  const std::string bytes("\x01\x80\xff", 3);
  const C3dBytes intel(bytes, C3dProcessor::kIntel), mips(bytes, C3dProcessor::kMips), dec(bytes, C3dProcessor::kDec);
  EXPECT_EQ(intel.word(0), 0x8001);
  EXPECT_EQ(dec.word(0), 0x8001);
  EXPECT_EQ(mips.word(0), 0x0180);
  EXPECT_EQ(intel.whole(0), -32767);
  EXPECT_EQ(mips.whole(0), 384);
  EXPECT_EQ(intel.byte(2), 0xff);
}

TEST(C3dNumbers, BeyondTheEndThereIsNothing) {
  const std::string bytes = "abcd";
  const C3dBytes file(bytes, C3dProcessor::kIntel);
  EXPECT_EQ(file.size(), 4u);
  EXPECT_EQ(file.text(1, 3), "bcd");
  EXPECT_EQ(file.text(2, 3), "");
  EXPECT_EQ(file.text(9, 0), "");
  constexpr std::size_t kEnormous = static_cast<std::size_t>(-1);
  EXPECT_EQ(file.text(1, kEnormous), "");
  EXPECT_TRUE(file.holds(4, 0) && !file.holds(4, 1) && !file.holds(kEnormous, 2));
  EXPECT_FALSE(file.byte(4) || file.word(3) || file.real(1));
}

RC_GTEST_PROP(C3dNumbers, RealNumbersComeBackFromEachProcessorsBytes, ()) {
  const float value = static_cast<float>(*rc::gen::inRange(-1'000'000, 1'000'000)) * 1e-2f;
  const auto halves = [](float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    return std::array<std::uint16_t, 2>{static_cast<std::uint16_t>(bits >> 16),
                                        static_cast<std::uint16_t>(bits & 0xffff)};
  };
  const auto [high, low] = halves(value);
  RC_ASSERT(C3dBytes(bytesOfWord(low, false) + bytesOfWord(high, false), C3dProcessor::kIntel).real(0) ==
            double{value});
  RC_ASSERT(C3dBytes(bytesOfWord(high, true) + bytesOfWord(low, true), C3dProcessor::kMips).real(0) == double{value});
  // DEC: four times the number in the exponent, the high word first, each with its low byte first.
  const auto [dec_high, dec_low] = halves(4.0f * value);
  RC_ASSERT(C3dBytes(bytesOfWord(dec_high, false) + bytesOfWord(dec_low, false), C3dProcessor::kDec).real(0) ==
            double{value});
}

TEST(C3dNumbers, NoNumbersAndEnormousOnesAreNothing) {
  for (const float bad : {NAN, INFINITY, -INFINITY, 2e12f}) {
    const auto bits = std::bit_cast<std::uint32_t>(bad);
    const std::string bytes = bytesOfWord(static_cast<std::uint16_t>(bits & 0xffff), false) +
                              bytesOfWord(static_cast<std::uint16_t>(bits >> 16), false);
    EXPECT_FALSE(C3dBytes(bytes, C3dProcessor::kIntel).real(0)) << bad;
  }
}

}  // namespace
}  // namespace hapticell::mannequin
