// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "trajectory/programs/writing/program_writers.h"

namespace hapticell::trajectory {
namespace {

using ::testing::HasSubstr;

constexpr ProgramFormat kFormats[] = {ProgramFormat::kKrl,      ProgramFormat::kRapid, ProgramFormat::kFanuc,
                                      ProgramFormat::kUrScript, ProgramFormat::kVal3,  ProgramFormat::kInform};

TEST(ProgramNumbers, EachLanguageHasNumbersForSpeedAndDwell) {
  for (const ProgramFormat format : kFormats) {
    const ProgramNumbers& numbers = programNumbers(format);
    for (const NumberRule* rule : {&numbers.speed, &numbers.dwell}) {
      EXPECT_GT(rule->greatest, rule->least) << numbers.language;
      EXPECT_GT(rule->least, 0.0) << numbers.language;
      EXPECT_GE(rule->least * (1.0 + 1e-9), 0.5 * std::pow(10.0, -rule->decimals)) << "the least is not written as 0";
    }
  }
  EXPECT_EQ(programNumbers(ProgramFormat::kFanuc).dwell.greatest, 327.67) << "FANUC's manual: WAIT 0.01 to 327.67 sec";
  EXPECT_EQ(programNumbers(ProgramFormat::kInform).speed.greatest, 1500.0) << "INFORM's V, mm/s";
  EXPECT_EQ(programNumbers(ProgramFormat::kFanuc).acceleration.greatest, 0.0) << "it has none";
}

RC_GTEST_PROP(ProgramNumbers, WhatIsInRangeIsWrittenWithinHalfADigit, ()) {
  const ProgramNumbers& numbers =
      programNumbers(*rc::gen::elementOf(std::vector<ProgramFormat>(std::begin(kFormats), std::end(kFormats))));
  const NumberRule& rule = *rc::gen::arbitrary<bool>() ? numbers.speed : numbers.dwell;
  const double share = *rc::gen::inRange(0, 1001) * 1e-3;
  const double wanted = rule.least * std::pow(rule.greatest / rule.least, share);
  NumberWriter writer(numbers);
  const std::string text = writer.text(rule, wanted / rule.scale, "speed");
  RC_ASSERT(!writer.error());
  const double got = std::strtod(text.c_str(), nullptr);
  RC_ASSERT(got > 0.0);
  RC_ASSERT(std::abs(got - wanted) <= 0.5 * std::pow(10.0, -rule.decimals) + 1e-9 * wanted);
  RC_ASSERT(writer.notes().empty() == (std::abs(got - wanted) <= 1e-3 * wanted));
}

TEST(ProgramNumbers, WhatTheLanguageCannotHoldIsAnErrorAndTheFirstIsKept) {
  const ProgramNumbers& numbers = programNumbers(ProgramFormat::kFanuc);
  for (const double bad :
       {0.0, -0.1, 0.0005, 5.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    NumberWriter writer(numbers);
    (void)writer.text(numbers.speed, bad, "speed");
    ASSERT_TRUE(writer.error()) << bad;
    (void)writer.text(numbers.dwell, 1e9, "dwell", "frame 3");
    const std::string message = writer.error()->message();
    EXPECT_THAT(message, HasSubstr("speed: "));
    EXPECT_THAT(message, HasSubstr("1 to 4000 mm/sec, the range of FANUC"));
    EXPECT_THAT(message, HasSubstr("Choose another speed. Nothing was written."));
  }
  NumberWriter writer(numbers);
  (void)writer.text(numbers.dwell, 1e9, "dwell", "frame 3");
  EXPECT_THAT(writer.error()->message(), HasSubstr("dwell, frame 3: "));
}

TEST(ProgramNumbers, RoundingIsNotedOnceForEachKindOfNumber) {
  const ProgramNumbers& numbers = programNumbers(ProgramFormat::kFanuc);
  NumberWriter writer(numbers);
  EXPECT_EQ(writer.text(numbers.speed, 0.0124, "speed"), "12");
  EXPECT_EQ(writer.text(numbers.speed, 0.0126, "speed"), "13");
  EXPECT_EQ(writer.text(numbers.dwell, 0.014, "dwell", "frame 2"), "0.01");
  ASSERT_EQ(writer.notes().size(), 2u);
  EXPECT_THAT(english(writer.notes()[0]), HasSubstr("12.4 mm/sec, is rounded to 12 mm/sec"));
  EXPECT_THAT(english(writer.notes()[1]), HasSubstr("dwell of frame 2"));
  EXPECT_EQ(writer.text(numbers.speed, 0.25, "speed"), "250");
}

TEST(ProgramWriters, ListsOfNumbersHavePointsWhateverTheLocale) {
  EXPECT_EQ(numberList({1.0, -0.00001, 2.5}, 3), "1.000,0.000,2.500");
  EXPECT_EQ(numberList({1.0, 2.0}, 0, "; "), "1; 2");
  EXPECT_EQ(numberList({}, 2), "");
  const double joints[] = {0.5 * 3.14159265358979323846, -1.0 / kDegreesPerRadian};
  EXPECT_EQ(jointList(joints, 2, kDegreesPerRadian), "90.00,-1.00");
}

TEST(ProgramWriters, EachWritesItsHeaderAndAMoveAFrame) {
  Trajectory trajectory;
  for (int i = 0; i < 3; ++i) {
    Trajectory::Frame frame{.t = 1.0 * i, .X_WT = Pose::translation({0.5 + 0.1 * i, 0.2, 0.3})};
    if (i == 1) frame.dwell = 0.5;
    ASSERT_TRUE(trajectory.addFrame(frame));
  }
  const ProgramOptions options;
  const auto write = [&](ProgramFormat format, auto writer) {
    const ProgramNumbers& rules = programNumbers(format);
    NumberWriter numbers(rules);
    const ProgramInput input{.trajectory = trajectory,
                             .options = options,
                             .name = "weld",
                             .blends = {0.0, 0.0, 0.0},
                             .rules = rules,
                             .numbers = numbers};
    EXPECT_FALSE(input.hasJoints());
    const std::vector<ProgramFile> files = writer(input);
    EXPECT_FALSE(numbers.error()) << numbers.error()->message();
    std::string all;
    for (const ProgramFile& file : files) all += file.content;
    return all;
  };
  const std::string krl_text = write(ProgramFormat::kKrl, writeKrl),
                    ur = write(ProgramFormat::kUrScript, writeUrScript);
  EXPECT_THAT(krl_text, HasSubstr("DEF weld"));
  EXPECT_THAT(krl_text, HasSubstr("600"));
  EXPECT_THAT(ur, HasSubstr("movel"));
  EXPECT_THAT(ur, HasSubstr("0.6"));
  EXPECT_THAT(ur, HasSubstr("sleep(0.5"));
  EXPECT_THAT(write(ProgramFormat::kRapid, writeRapid), HasSubstr("MoveL"));
  EXPECT_THAT(write(ProgramFormat::kFanuc, writeFanuc), HasSubstr("/POS"));
  EXPECT_THAT(write(ProgramFormat::kVal3, writeVal3), HasSubstr("movel"));
  EXPECT_THAT(write(ProgramFormat::kInform, writeInform), HasSubstr("MOVL"));
}

}  // namespace
}  // namespace hapticell::trajectory
