// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "mannequin/motion/marker_clip.h"
#include "tests/mannequin/motion/c3d_text.h"
#include "tests/mannequin/motion/second_c3d_reader.h"
#include "tests/support/test_data.h"

namespace hapticell::mannequin {
namespace {

using test::C3dFile;
using test::C3dText;

/// Two markers, three frames, x = frame, y = marker, z = 100 frame + marker; the second is not seen in frame 1.
/// `used`: how many points the parameters state as a real number, where they do.
std::string smallFile(int processor, bool real, const char* up = "+Z", const std::string& unit = "mm",
                      std::optional<float> used = {}) {
  C3dText file(processor);
  file.byte(2);
  file.byte(0x50);
  for (unsigned value : {2u, 3u, 1u, 3u, 0u}) file.word(value);  // Points, analog, first, last, gap.
  const float scale = real ? -1.0f : 0.5f;
  file.real(scale);
  file.word(3);  // Data's block.
  file.word(1);
  file.real(50.0f);
  file.fillTo(512);
  file.byte(1);
  file.byte(0x50);
  file.byte(1);
  file.byte(processor);
  file.group(1, "POINT");
  C3dText labels(processor), units(processor), screen(processor);
  labels.text("HEAD  HAND  ");
  units.text(unit);
  screen.text(up);
  file.parameter(1, "LABELS", -1, {6, 2}, labels);
  file.parameter(1, "UNITS", -1, {static_cast<int>(unit.size())}, units);
  file.parameter(1, "Y_SCREEN", -1, {2}, screen);
  if (used) {
    C3dText count(processor);
    count.real(*used);
    file.parameter(1, "USED", 4, {1}, count);
  }
  file.byte(0);
  file.byte(0);
  file.fillTo(1024);
  const auto value = [&](double v) {
    if (real) return file.real(static_cast<float>(v));
    file.word(static_cast<unsigned>(static_cast<int>(std::lround(v / static_cast<double>(scale)))) & 0xffff);
  };
  for (int frame = 0; frame < 3; ++frame) {
    for (int marker = 0; marker < 2; ++marker) {
      for (double v : {1.0 * frame, 1.0 * marker, 100.0 * frame + marker}) value(v);
      const bool seen = !(frame == 1 && marker == 1);
      if (real)
        file.real(seen ? 0.3f : -1.0f);
      else
        file.word(seen ? 0x0101u : 0xffffu);
    }
    for (int analog = 0; analog < 3; ++analog) real ? file.real(7.0f) : file.word(7u);
  }
  return file.bytes;
}

class AnyProcessor : public ::testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(AnyProcessor, HasTheSameMarkers) {
  const auto [processor, real] = GetParam();
  const auto clip = parseC3d(smallFile(processor, real), "small.c3d");
  ASSERT_TRUE(clip) << clip.error().message();
  EXPECT_EQ(clip->names, (std::vector<std::string>{"HEAD", "HAND"}));
  ASSERT_EQ(clip->frames(), 3u);
  EXPECT_DOUBLE_EQ(clip->frame_time, 0.02);
  EXPECT_FALSE(clip->at(1, 1));
  EXPECT_NEAR(clip->seenShare(1), 2.0 / 3.0, 1e-12);
  ASSERT_TRUE(clip->at(2, 1));
  EXPECT_LT(glm::length(*clip->at(2, 1) - dvec3(0.002, 0.001, 0.201)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(C3d, AnyProcessor, ::testing::Combine(::testing::Values(84, 85, 86), ::testing::Bool()));

TEST(C3d, TurnsTheAxisThatPointsUpIntoZ) {
  const auto y = parseC3d(smallFile(84, true, "+Y"), "y.c3d"), x = parseC3d(smallFile(84, true, "+X"), "x.c3d");
  ASSERT_TRUE(y && x);
  EXPECT_LT(glm::length(*y->at(2, 1) - dvec3(0.002, -0.201, 0.001)), 1e-9);
  EXPECT_LT(glm::length(*x->at(2, 1) - dvec3(0.001, 0.201, 0.002)), 1e-9);
}

TEST(C3d, KnowsItsUnits) {
  EXPECT_NEAR(parseC3d(smallFile(84, true, "+Z", "m"), "m.c3d")->at(2, 1)->z, 201.0, 1e-6);
  EXPECT_NEAR(parseC3d(smallFile(84, true, "+Z", "in"), "in.c3d")->at(2, 1)->z, 201.0 * 0.0254, 1e-6);
  const auto odd = parseC3d(smallFile(84, true, "+Z", "ell"), "odd.c3d");
  ASSERT_FALSE(odd);
  EXPECT_NE(odd.error().message().find("'ell'"), std::string::npos);
  EXPECT_FALSE(parseC3d(smallFile(84, true, "+Z", "  "), "none.c3d")->warnings.empty());
}

TEST(C3d, RefusesWhatDoesNotFit) {
  const std::string sound = smallFile(84, true);
  const auto refused = [&](std::size_t at, char value, const char* words) {
    std::string bytes = sound;
    bytes[at] = value;
    const auto clip = parseC3d(bytes, "bad.c3d");
    EXPECT_FALSE(clip) << words;
    if (!clip) {
      EXPECT_NE(clip.error().message().find(words), std::string::npos) << clip.error().message();
    }
  };
  refused(1, 0x51, "the C3D header is missing");
  refused(0, 9, "parameters");
  refused(512 + 3, 80, "processor 80");
  refused(2, 0, "no points");
  refused(8, 9, "3 frames");
  for (std::size_t size : {0u, 1u, 511u, 520u, 1000u, 1030u})
    EXPECT_FALSE(parseC3d(std::string_view(sound).substr(0, size), "cut.c3d")) << size;
}

TEST(C3d, RefusesCountsThatAreNone) {
  EXPECT_TRUE(parseC3d(smallFile(84, true, "+Z", "mm", 2.0f), "two.c3d"));
  for (const auto& [used, words] :
       {std::pair(-8.4e11f, "no points"), {0.5f, "no points"}, {9e11f, "points; expected at most"}}) {
    const auto clip = parseC3d(smallFile(84, true, "+Z", "mm", used), "bad.c3d");
    ASSERT_FALSE(clip) << used;
    EXPECT_NE(clip.error().message().find(words), std::string::npos) << clip.error().message();
  }
}

RC_GTEST_PROP(C3d, SurvivesAnyChangedByte, ()) {
  std::string bytes = smallFile(*rc::gen::element(84, 85, 86), *rc::gen::arbitrary<bool>());
  for (const auto& at :
       *rc::gen::container<std::vector<std::size_t>>(4, rc::gen::inRange<std::size_t>(0, bytes.size())))
    bytes[at] = *rc::gen::arbitrary<char>();
  const auto clip = parseC3d(bytes, "damaged.c3d");
  if (clip) {
    RC_ASSERT(clip->places.size() == clip->frames() * clip->names.size());
  }
}

TEST(C3d, TheSharedRecordingIsWhatItsSourceStates) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/cmu_02_05.c3d");
  const auto clip = readC3d(file);
  ASSERT_TRUE(clip) << clip.error().message();
  EXPECT_EQ(clip->names.size(), 41u);
  EXPECT_EQ(clip->frames(), 1854u);
  EXPECT_NEAR(clip->frame_time, 1.0 / 120.0, 1e-9);
  EXPECT_DOUBLE_EQ(clip->metres_per_unit, 1e-3);
  // A person of subject 02's size upright on the floor: the highest marker on the head, the lowest at the toes.
  double low = 1e9, high = -1e9;
  for (std::size_t frame = 0; frame < clip->frames(); frame += 100) {
    for (std::size_t marker = 0; marker < clip->names.size(); ++marker) {
      if (const auto& p = clip->at(frame, marker)) {
        low = std::min(low, p->z);
        high = std::max(high, p->z);
      }
    }
  }
  EXPECT_GT(low, -0.05);
  EXPECT_LT(low, 0.15);
  EXPECT_GT(high, 1.5);
  EXPECT_LT(high, 2.3);
}

bool warns(const MarkerClip& clip, const std::string& words) {
  return std::any_of(clip.warnings.begin(), clip.warnings.end(),
                     [&](const Text& each) { return english(each).find(words) != std::string::npos; });
}

/// x 0 to 0.19 m, y 0, 0.1, 0.2 m, z 1.5 m in 20 frames, whatever the header says.
void expectTheThreeMarkers(const C3dFile& file, const std::string& warning) {
  const auto clip = parseC3d(file.bytes(), "maker.c3d");
  ASSERT_TRUE(clip) << clip.error().message();
  ASSERT_EQ(clip->frames(), 20u);
  ASSERT_EQ(clip->names.size(), 3u);
  for (std::size_t f = 0; f < 20; ++f) {
    for (std::size_t m = 0; m < 3; ++m) {
      ASSERT_TRUE(clip->at(f, m));
      EXPECT_LT(glm::length(*clip->at(f, m) - dvec3(0.01 * static_cast<double>(f), 0.1 * static_cast<double>(m), 1.5)),
                1e-4);
    }
  }
  if (warning.empty())
    EXPECT_TRUE(clip->warnings.empty()) << english(clip->warnings.front());
  else
    EXPECT_TRUE(warns(*clip, warning)) << warning;
}

TEST(C3dOfMakers, SoundFilesAreReadWithoutAWord) {
  for (const int processor : {84, 85, 86}) {
    C3dFile file;
    file.processor = processor;
    expectTheThreeMarkers(file, "");
    file.real = false;
    expectTheThreeMarkers(file, "");
  }
}

TEST(C3dOfMakers, AnalogSamplesAreWhatFillsTheFile) {
  for (const int processor : {84, 86}) {
    C3dFile file;
    file.processor = processor;
    file.analog = 16 * 7;
    file.header_analog = 16;  // The channels instead of the samples a frame.
    file.analog_used = 16.0;
    file.analog_rate = 700.0;
    expectTheThreeMarkers(file, "112 (channels × samples) match the file size");
  }
}

TEST(C3dOfMakers, TheScaleIsThatWithWhichTheNumbersWereWritten) {
  C3dFile file;
  file.real = false;
  file.scale = 0.0551;
  file.parameter_scale = 0.0215;
  const auto clip = parseC3d(file.bytes(), "scale.c3d");
  ASSERT_TRUE(clip);
  EXPECT_NEAR(clip->at(3, 1)->z, 1.5, 1e-4);
  EXPECT_TRUE(warns(*clip, "the scale of the points is"));
}

TEST(C3dOfMakers, FaultsThatOtherReadersPassOverDoNotEndTheReading) {
  C3dFile start;
  start.parameter_start = 0;
  expectTheThreeMarkers(start, "");
  start.header_block = 0;
  expectTheThreeMarkers(start, "where the points begin");
  C3dFile swapped;
  swapped.last_link_swapped = true;
  expectTheThreeMarkers(swapped, "");
  for (const auto& [word, metres] : {std::pair("mete", 1.0),
                                     {"metre", 1.0},
                                     {"millimet", 1e-3},
                                     {"cent", 1e-2},
                                     {"MM", 1e-3},
                                     {"Inches", 0.0254},
                                     {"foot", 0.3048}}) {
    C3dFile unit;
    unit.unit = word;
    const auto clip = parseC3d(unit.bytes(), "unit.c3d");
    ASSERT_TRUE(clip) << word;
    EXPECT_EQ(clip->metres_per_unit, metres) << word;
  }
  C3dFile raw;
  raw.unit = std::string("\x01\xffzz");
  const auto refused = parseC3d(raw.bytes(), "raw.c3d");
  ASSERT_FALSE(refused);
  for (const char c : refused.error().message()) EXPECT_TRUE(c >= ' ' && c < '\x7f');
}

TEST(C3dOfMakers, NoFrameIsLostWhereSixteenBitsCountThem) {
  C3dFile zeros;
  zeros.header_first = zeros.header_last = 0;
  zeros.parameter_frames = 20;
  expectTheThreeMarkers(zeros, "the file has 20");
  C3dFile plain = zeros;  // Only the size of the file tells.
  plain.parameter_frames.reset();
  expectTheThreeMarkers(plain, "the file has 20");
  C3dFile absurd;  // What TRIAL or LONG_FRAMES say cannot be: the header's count fits.
  absurd.long_frames = 3e9;
  expectTheThreeMarkers(absurd, "");
  absurd.long_frames = 25.0;
  expectTheThreeMarkers(absurd, "the file has 20");
  for (const auto& [frames, said] : {std::pair(70'000, 70'000 & 0xffff), {90'000, 65'535}, {131'077, 5}}) {
    C3dFile file;
    file.labels = {"A"};
    file.frames = frames;
    file.header_last = said;
    file.parameter_frames = said;
    const auto clip = parseC3d(file.bytes(), "long.c3d");
    ASSERT_TRUE(clip);
    EXPECT_EQ(clip->frames(), static_cast<std::size_t>(frames));
    EXPECT_TRUE(warns(*clip, "the file has " + std::to_string(frames)));
  }
}

TEST(C3dOfMakers, UpIsToldFoundOrSaid) {
  // A head 1.7 m over a foot along each of the six axes.
  for (int axis = 0; axis < 6; ++axis) {
    C3dFile file;
    file.labels = {"S:LFHD", "S:LANK"};
    file.up.reset();
    file.place = [axis](int f, int m) {
      dvec3 p(10.0 * f, 20.0, 30.0);
      p[axis % 3] = (axis < 3 ? 1.0 : -1.0) * (m == 0 ? 1750.0 : 50.0);
      return std::optional(p);
    };
    const auto clip = parseC3d(file.bytes(), "up.c3d");
    ASSERT_TRUE(clip);
    EXPECT_EQ(static_cast<int>(clip->up), axis);
    EXPECT_NEAR(clip->at(7, 0)->z - clip->at(7, 1)->z, 1.7, 1e-4);
    EXPECT_TRUE(warns(*clip, "does not state which axis is up"));
    file.labels = {"M1", "M2"};  // Names that tell nothing: the longest side does.
    EXPECT_EQ(static_cast<int>(parseC3d(file.bytes(), "up.c3d")->up), axis);
    file.up = axis < 3 ? std::string("+") + "XYZ"[axis] : std::string("-") + "XYZ"[axis - 3];
    const auto said = parseC3d(file.bytes(), "up.c3d");
    EXPECT_NEAR(said->at(7, 0)->z - said->at(7, 1)->z, 1.7, 1e-4);
    EXPECT_TRUE(said->warnings.empty());
    file.labels = {"S:LFHD", "S:LANK"};
    file.up = axis % 3 == 0 ? "+Y" : "+X";  // Says another axis than where the body stands.
    const auto wrong = parseC3d(file.bytes(), "up.c3d");
    EXPECT_EQ(static_cast<int>(wrong->up), axis);
    EXPECT_TRUE(warns(*wrong, "but the body stands along"));
    EXPECT_EQ(parseC3d(file.bytes(), "up.c3d", UpAxis::kY)->up, UpAxis::kY);
  }
}

void expectEqualsSecondReader(const std::filesystem::path& path, int& equal, int& without) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  const std::string bytes = content.str();
  const auto second = test::SecondC3dReader(bytes).read();
  const auto clip = parseC3d(bytes, path.string());
  EXPECT_EQ(clip.has_value(), second.has_value()) << path;
  if (!clip || !second) {
    ++without;
    return;
  }
  EXPECT_EQ(clip->names.size(), second->markers) << path;
  EXPECT_EQ(clip->frames(), second->frames) << path;
  std::size_t seen = 0;
  dvec3 sum(0.0);
  const dmat3 back = glm::transpose(uprightTurn(clip->up));
  for (const auto& p : clip->places) {
    if (!p) continue;
    ++seen;
    sum += back * *p / clip->metres_per_unit;
  }
  EXPECT_EQ(seen, second->seen) << path;
  EXPECT_LT(glm::length(sum - second->sum), 1e-6 * std::max(1.0, glm::length(second->sum))) << path;
  ++equal;
}

TEST(C3dOfMakers, PublicSampleFilesEqualASecondReader) {
  // The sample files of c3d.org, BTKData and ezc3d, in a folder c3d beside the other shared data.
  HAPTICELL_SHARED_DATA_OR_SKIP(folder, "c3d");
  int equal = 0, without = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending == ".c3d") expectEqualsSecondReader(entry.path(), equal, without);
  }
  std::printf("%d files equal the second reader, %d are read by neither\n", equal, without);
  RecordProperty("equal", equal);
  EXPECT_GE(equal, 54);
}

TEST(C3dOfMakers, TheSharedRecordingEqualsASecondReader) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/cmu_02_05.c3d");
  int equal = 0, without = 0;
  expectEqualsSecondReader(file, equal, without);
  EXPECT_EQ(equal, 1);
}

}  // namespace
}  // namespace hapticell::mannequin
