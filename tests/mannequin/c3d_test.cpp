// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "mannequin/marker_clip.h"
#include "tests/support/test_data.h"

namespace hapticell::mannequin {
namespace {

/// Writes C3D as each of the three processors would; an independent way from the reader's: byte by byte from values.
class C3dText {
 public:
  explicit C3dText(int processor) : processor_(processor) {}

  void byte(int value) { bytes += static_cast<char>(value); }
  void word(unsigned value) {
    const int low = static_cast<int>(value & 0xff), high = static_cast<int>(value >> 8 & 0xff);
    byte(processor_ == 86 ? high : low);
    byte(processor_ == 86 ? low : high);
  }
  void real(float value) {
    if (processor_ == 85) value *= 4.0f;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    word(processor_ == 84 ? bits & 0xffff : bits >> 16);
    word(processor_ == 84 ? bits >> 16 : bits & 0xffff);
  }
  void text(const std::string& letters) { bytes += letters; }
  void fillTo(std::size_t size) { bytes.resize(size, '\0'); }
  void group(int number, const std::string& name) {
    byte(static_cast<int>(name.size()));
    byte(-number);
    text(name);
    word(3);
    byte(0);
  }
  /// `content` is what stands behind the dimensions.
  void parameter(int group, const std::string& name, int type, const std::vector<int>& sizes, const C3dText& content) {
    byte(static_cast<int>(name.size()));
    byte(group);
    text(name);
    word(static_cast<unsigned>(2 + 2 + sizes.size() + content.bytes.size() + 1));
    byte(type);
    byte(static_cast<int>(sizes.size()));
    for (int size : sizes) byte(size);
    text(content.bytes);
    byte(0);
  }
  std::string bytes;

 private:
  int processor_;
};

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
      real ? file.real(seen ? 0.3f : -1.0f) : file.word(seen ? 0x0101u : 0xffffu);
    }
    for (int analog = 0; analog < 3; ++analog) real ? file.real(7.0f) : file.word(7u);
  }
  return file.bytes;
}

class AnyProcessor : public ::testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(AnyProcessor, hasTheSameMarkers) {
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
  refused(1, 0x51, "no C3D header");
  refused(0, 9, "parameters");
  refused(512 + 3, 80, "processor 80");
  refused(2, 0, "no points");
  refused(8, 9, "3 frames");
  refused(16, 0, "points in the header");
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

}  // namespace
}  // namespace hapticell::mannequin
