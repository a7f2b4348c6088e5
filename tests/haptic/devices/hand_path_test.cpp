// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/hand_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <numbers>
#include <string>
#include <utility>

#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

std::string problem(std::string_view text) {
  const auto path = parseHandPath(text, "hand.csv");
  return path ? "no problem" : path.error().message();
}

TEST(HandPath, InterpolatesPosesAndHoldsButtonsAndEnds) {
  const auto path = parseHandPath(
      "t,x,y,z,qw,qx,qy,qz,button\n"
      "1.0,0,0,0,1,0,0,0,0\n"
      "2.0,0.01,0.02,-0.03,0.7071067811865476,0,0,0.7071067811865476,1\n",
      "hand.csv");
  ASSERT_TRUE(path.has_value()) << path.error().message();
  EXPECT_EQ(path->duration(), 2.0);
  const HandSample middle = path->at(1.5);
  EXPECT_NEAR(middle.X_DH.p.y, 0.01, 1e-15);
  EXPECT_NEAR(rotationVector(middle.X_DH.q).z, std::numbers::pi / 4.0, 1e-12);
  EXPECT_EQ(middle.buttons, 0u);
  EXPECT_EQ(path->at(0.0).X_DH.p, dvec3(0.0));
  EXPECT_EQ(path->at(99.0).X_DH.p, dvec3(0.01, 0.02, -0.03));
  EXPECT_EQ(path->at(2.0).buttons, 1u);
}

TEST(HandPath, TakesColumnsInAnyOrderAndWithoutTurning) {
  const auto path =
      parseHandPath("\xEF\xBB\xBFz, y ,x,note,t\r\n# a remark\r\n0.3,0.2,+0.1,hello,0\r\n\r\n", "hand.csv");
  ASSERT_TRUE(path.has_value()) << path.error().message();
  EXPECT_EQ(path->at(0.0).X_DH.p, dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(path->at(0.0).X_DH.q, dquat(1, 0, 0, 0));
}

TEST(HandPath, TwoSamplesAtOneTimeAreAStep) {
  const auto path = parseHandPath("t,x,y,z\n0,0,0,0\n1,0,0,0\n1,0.1,0,0\n2,0.1,0,0\n", "hand.csv");
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(path->at(0.999).X_DH.p.x, 0.0, 1e-12);
  EXPECT_NEAR(path->at(1.0).X_DH.p.x, 0.1, 1e-12);
}

TEST(HandPath, NamesLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(problem("t,x,y,z\n0,0,0,0\n1,zero,0,0\n"), "hand.csv, line 3, column 'x': \"zero\"; expected a number");
  EXPECT_THAT(problem("t,x,y,z\n0,0,0\n"), HasSubstr("line 2, column 'z'"));
  EXPECT_THAT(problem("t,x,y,z\n0,nan,0,0\n"), HasSubstr("column 'x'"));
  EXPECT_THAT(problem("t,x,y,z\n0,1e999,0,0\n"), HasSubstr("column 'x'"));
  EXPECT_THAT(problem("t,x,y\n0,0,0\n"), HasSubstr("column 'z': the column is missing"));
  EXPECT_THAT(problem("t,x,y,z,qw\n0,0,0,0,1\n"), HasSubstr("column 'qx': the column is missing"));
  EXPECT_THAT(problem("t,x,y,z\n1,0,0,0\n0,0,0,0\n"), HasSubstr("line 3, column 't'"));
  EXPECT_THAT(problem("t,x,y,z,qw,qx,qy,qz\n0,0,0,0,0,0,0,0\n"), HasSubstr("quaternion"));
  for (const char* button : {"-1", "7", "0.5", "4"}) {
    EXPECT_THAT(problem(std::string("t,x,y,z,button\n0,0,0,0,") + button + "\n"), HasSubstr("column 'button'"));
  }
  EXPECT_THAT(problem("t,x,y,z\n"), HasSubstr("no line after the header"));
  EXPECT_THAT(problem(""), HasSubstr("no line after the header"));
}

TEST(HandPath, ReadsAFileAndSaysWhenItCannot) {
  const test::TemporaryFolder folder;
  const auto path = readHandPath(folder.write("hand.csv", "t,x,y,z\n0,0.01,0,0\n"));
  ASSERT_TRUE(path.has_value());
  EXPECT_EQ(path->samples().size(), 1u);
  EXPECT_FALSE(readHandPath(folder.path() / "none.csv").has_value());
}

HandPath read(const std::string& text) {
  auto path = parseHandPath(text, "hand.csv");
  EXPECT_TRUE(path.has_value()) << path.error().message();
  return path ? std::move(*path) : HandPath({HandSample{}});
}

TEST(HandPath, TimesOfAClockCountFromTheFirstRow) {
  for (const auto& [begin, step] : std::initializer_list<std::pair<const char*, double>>{{"1700000000.0", 0.5},
                                                                                         {"1700000000000", 500.0},
                                                                                         {"1700000000000000", 5e5},
                                                                                         {"1700000000000000000", 5e8},
                                                                                         {"412.0", 0.5},
                                                                                         {"-3.0", 0.5}}) {
    std::string text = "t,x,y,z\n";
    for (int i = 0; i < 3; ++i) {
      char row[80];
      std::snprintf(row, sizeof row, "%.3f,%.2f,0,0\n", std::atof(begin) + i * step, 0.01 * i);
      text += row;
    }
    const HandPath path = read(text);
    EXPECT_NEAR(path.duration(), 1.0, 1e-6) << begin;
    EXPECT_NEAR(path.at(0.5).X_DH.p.x, 0.01, 1e-6) << begin;
    ASSERT_EQ(path.assumptions().size(), 1u) << begin;
    EXPECT_THAT(english(path.assumptions()[0]), HasSubstr("the first line is time 0"));
  }
}

TEST(HandPath, APauseBeforeThePathIsKept) {
  const HandPath path = read("t,x,y,z\n2,0,0,0\n5,0.01,0,0\n");
  EXPECT_EQ(path.duration(), 5.0);
  EXPECT_TRUE(path.assumptions().empty());
}

TEST(HandPath, ARecordingInMillisecondsIsRecognised) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i < 200; ++i) text += std::to_string(5 * i) + ",0,0,0.01\n";
  const HandPath path = read(text);
  EXPECT_NEAR(path.duration(), 0.995, 1e-12);
  ASSERT_EQ(path.assumptions().size(), 1u);
  EXPECT_THAT(english(path.assumptions()[0]), HasSubstr("milliseconds"));
  EXPECT_TRUE(read("t,x,y,z\n0,0,0,0\n5,0.01,0,0\n10,0,0,0\n").assumptions().empty()) << "a few rows of a slow hand";
}

TEST(HandPath, PositionsInMillimetresAreRecognisedAndFartherOnesRefused) {
  const HandPath path = read("t,x,y,z\n0,0,0,20\n1,-40,0.5,10\n");
  EXPECT_NEAR(path.at(0.0).X_DH.p.z, 0.02, 1e-15);
  EXPECT_NEAR(path.at(1.0).X_DH.p.x, -0.04, 1e-15);
  ASSERT_EQ(path.assumptions().size(), 1u);
  EXPECT_THAT(english(path.assumptions()[0]), HasSubstr("millimetres are assumed"));
  EXPECT_TRUE(read("t,x,y,z\n0,0.4,0,0\n").assumptions().empty());
  EXPECT_THAT(problem("t,x,y,z\n0,0,0,20000\n"), HasSubstr("a position 20000 from the centre"));
}

}  // namespace
}  // namespace hapticell::haptic
