// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "mannequin/motion/c3d_layout.h"
#include "mannequin/motion/c3d_numbers.h"
#include "mannequin/motion/marker_up.h"
#include "mannequin/motion/word_reader.h"
#include "tests/mannequin/motion/c3d_text.h"

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

C3dLayout layoutOf(const test::C3dFile& file) {
  const std::string bytes = file.bytes();
  const auto parameters = C3dParameters::read(bytes, "x.c3d");
  EXPECT_TRUE(parameters);
  const auto layout = c3dLayout(*parameters, "x.c3d");
  EXPECT_TRUE(layout) << (layout ? "" : layout.error().message());
  if (!layout) return {};
  // The file ends with its last frame: from the end backwards, by hand.
  EXPECT_EQ(bytes.size() - layout->data_at, layout->frames * layout->rowBytes());
  return *layout;
}

bool saysSo(const C3dLayout& layout, const std::string& words) {
  return std::any_of(layout.warnings.begin(), layout.warnings.end(),
                     [&](const Text& warning) { return english(warning).find(words) != std::string::npos; });
}

TEST(C3dLayout, IsWhatHeaderAndParametersSayWhereTheyAgree) {
  const C3dLayout real = layoutOf({.analog = 2});
  EXPECT_EQ(real.rowBytes(), (4u * 3u + 2u) * 4u);
  EXPECT_EQ(real.frames, 20u);
  EXPECT_EQ(real.scale, 1.0);
  EXPECT_TRUE(real.warnings.empty());
  const C3dLayout whole = layoutOf({.processor = 86, .real = false, .scale = 0.05, .parameter_scale = 0.05});
  EXPECT_EQ(whole.rowBytes(), 4u * 3u * 2u);
  EXPECT_NEAR(whole.scale, 0.05, 1e-7);
  EXPECT_TRUE(whole.warnings.empty());
}

TEST(C3dLayout, IsWhatFillsTheFileWhereTheyDisagree) {
  const C3dLayout longer = layoutOf({.frames = 60, .header_last = 12});
  EXPECT_EQ(longer.frames, 60u);
  EXPECT_TRUE(saysSo(longer, "12 frames")) << "what the header states";
  const C3dLayout moved = layoutOf({.parameter_start = 2});
  EXPECT_EQ(moved.frames, 20u);
  EXPECT_TRUE(saysSo(moved, "where the points begin"));
  const C3dLayout analog =
      layoutOf({.frames = 60, .analog = 6, .header_analog = 3, .analog_used = 3.0, .analog_rate = 200.0});
  EXPECT_EQ(analog.analog, 6u) << "3 channels, twice as often as the points";
  EXPECT_TRUE(saysSo(analog, "analog samples"));
  const C3dLayout format = layoutOf({.real = false, .parameter_scale = -0.05});
  EXPECT_FALSE(format.real);
  EXPECT_TRUE(saysSo(format, "integers match the file size"));
  const C3dLayout scales = layoutOf({.real = false, .scale = 0.05, .parameter_scale = 0.1});
  EXPECT_NEAR(scales.scale, 0.05, 1e-7) << "the header's, with which they were written";
  EXPECT_TRUE(saysSo(scales, "scale of the points"));
}

TEST(C3dLayout, RefusesAFileThatEndsBeforeItsFrames) {
  const std::string bytes = test::C3dFile{}.bytes();
  const auto parameters = C3dParameters::read(std::string_view(bytes).substr(0, bytes.size() - 700), "cut.c3d");
  ASSERT_TRUE(parameters);
  const auto layout = c3dLayout(*parameters, "cut.c3d");
  ASSERT_FALSE(layout);
  // 20 frames of 48 bytes, 700 are missing.
  EXPECT_NE(layout.error().message().find("5 frames"), std::string::npos) << layout.error().message();
  EXPECT_NE(layout.error().message().find("20 frames"), std::string::npos) << layout.error().message();
}

TEST(MarkerUp, KnowsHowHighAMarkerIsWorn) {
  const std::pair<const char*, int> known[] = {{"LFHD", 3},  {"Subject:RBHD", 3}, {"C7", 2},    {"LSHO", 2},
                                               {"CLAV", 2},  {"RASI", 1},         {"SACR", 1},  {"LKNE", 0},
                                               {"RANK", -1}, {"team|LTOE", -1},   {"LHEE", -1}, {"r shoulder", 2}};
  for (const auto& [name, height] : known) EXPECT_EQ(marker_up::heightOf(name), height) << name;
  for (const char* name : {"LWRA", "marker 7", "", "X:"}) EXPECT_FALSE(marker_up::heightOf(name)) << name;
}

/// A person who stands along the axis `up` of the file and goes 1 m along the next.
MarkerClip standingClip(int up, std::vector<std::string> names) {
  MarkerClip clip;
  clip.names = std::move(names);
  constexpr std::array kHeights = {1.7, 1.4, 0.95, 0.08};
  for (int frame = 0; frame < 50; ++frame) {
    for (std::size_t m = 0; m < clip.names.size(); ++m) {
      dvec3 p(0.0);
      p[up] = kHeights[m];
      p[(up + 1) % 3] = 0.02 * frame;
      p[(up + 2) % 3] = 0.1 * static_cast<double>(m % 2);
      clip.places.push_back(p);
    }
  }
  return clip;
}

TEST(MarkerUp, TheBodyTellsWhichAxisIsUpUnlessTheUserDoes) {
  const std::vector<std::string> names{"LFHD", "LSHO", "LASI", "LANK"}, none{"M1", "M2", "M3", "M4"};
  constexpr std::array kAxes = {UpAxis::kX, UpAxis::kY, UpAxis::kZ};
  for (int up = 0; up < 3; ++up) {
    for (const auto& labels : {names, none}) {
      MarkerClip clip = standingClip(up, labels);
      turnUpright(clip, std::nullopt, "");
      EXPECT_EQ(clip.up, kAxes[static_cast<std::size_t>(up)]);
      EXPECT_NEAR(clip.at(7, 0)->z, 1.7, 1e-12) << "the head's height, turned upright";
      EXPECT_EQ(clip.warnings.size(), 1u) << "that it was assumed";
    }
  }
  MarkerClip stated = standingClip(1, names);
  turnUpright(stated, std::nullopt, "+Y");
  EXPECT_EQ(stated.up, UpAxis::kY);
  EXPECT_TRUE(stated.warnings.empty()) << "the file states it, and the body agrees";
  MarkerClip contradicted = standingClip(1, names);
  turnUpright(contradicted, std::nullopt, "+Z");
  EXPECT_EQ(contradicted.up, UpAxis::kY) << "the body wins over the file";
  EXPECT_EQ(contradicted.warnings.size(), 1u);
  MarkerClip told = standingClip(1, names);
  turnUpright(told, UpAxis::kMinusX, "+Y");
  EXPECT_EQ(told.up, UpAxis::kMinusX) << "the user wins over both";
  EXPECT_EQ(told.warnings.size(), 1u);
  EXPECT_NEAR(told.at(7, 1)->z, -0.1, 1e-12) << "minus the file's x";
  MarkerClip lying = standingClip(0, none);
  for (auto& p : lying.places) p->x *= 0.1;
  turnUpright(lying, std::nullopt, "");
  EXPECT_EQ(lying.up, UpAxis::kZ) << "assumed where nothing shows it";
}

}  // namespace
}  // namespace hapticell::mannequin
