// SPDX-License-Identifier: Apache-2.0
// Every language by a grammar of its own (program_grammar.h): names, numbers in their resolution, all axes' speeds.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/trajectory/motion/motions.h"
#include "tests/trajectory/programs/writing/program_grammar.h"
#include "trajectory/programs/reading/program_readers.h"
#include "trajectory/programs/writing/program_export.h"
#include "trajectory/programs/writing/program_names.h"

namespace hapticell::trajectory {
namespace {

using test::ParsedProgram;

constexpr std::array<ProgramFormat, 6> kAllFormats{ProgramFormat::kKrl,   ProgramFormat::kRapid,
                                                   ProgramFormat::kFanuc, ProgramFormat::kUrScript,
                                                   ProgramFormat::kVal3,  ProgramFormat::kInform};

std::string parsed(const std::vector<ProgramFile>& files, ProgramFormat format, ParsedProgram& program) {
  switch (format) {
    case ProgramFormat::kKrl:
      return test::parseKrl(files[0].content, files[1].content, program);
    case ProgramFormat::kRapid:
      return test::parseRapid(files[0].content, program);
    case ProgramFormat::kFanuc:
      return test::parseFanuc(files[0].content, program);
    case ProgramFormat::kUrScript:
      return test::parseUrScript(files[0].content, program);
    case ProgramFormat::kInform:
      return test::parseInform(files[0].content, program);
    case ProgramFormat::kVal3: {
      std::map<std::string, std::string> contents;
      for (const ProgramFile& file : files) contents[file.name] = file.content;
      return test::parseVal3(contents, program);
    }
  }
  return "?";
}

Trajectory motionOf(std::size_t count, bool with_joints, double dwell = 0.0) {
  Trajectory motion;
  motion.name = "seam";
  if (with_joints) motion.joint_names = {"a", "b", "c", "d", "e", "f"};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    const std::vector<double> joints(with_joints ? 6 : 0, 0.1 + t);
    motion.addFrame({t, test::gestureAt(2.0 * t), false, i == 2 ? dwell : 0.0}, joints);
  }
  return motion;
}

TEST(ProgramLanguages, EveryLanguageKeepsToItsGrammarWhateverTheName) {
  const std::vector<std::string> names{
      "loop",
      "circ",
      "return",
      "default",
      "ptp",
      "test",
      "TEST",
      "Étape 2",
      "",
      "9",
      "日本",
      "main",
      "p1",
      "XP1",
      "vLine",
      "movel",
      "end",
      "start",
      "__x",
      "tool0",
      "Loop",
      "con",
      "NUL",
      "while",
      "xp",
      "p",
      "-",
      "Œuvre",
      "DEF",
      "num",
      "a very long name of a program that no controller would ever take as it is, whatever it is"};
  for (const bool with_joints : {false, true})
    for (const std::string& name : names)
      for (const ProgramFormat format : kAllFormats) {
        ProgramOptions options;
        options.name = name;
        const Trajectory motion = motionOf(8, with_joints, 0.5);
        const auto files = exportProgram(motion, format, options);
        ASSERT_TRUE(files) << files.error().message();
        ParsedProgram program;
        EXPECT_EQ(parsed(*files, format, program), "") << name << ' ' << static_cast<int>(format);
        ASSERT_EQ(program.moves.size(), motion.size()) << name << ' ' << static_cast<int>(format);
        EXPECT_EQ(program.moves[0].kind, 'J');
        EXPECT_DOUBLE_EQ(program.moves[2].dwell, 0.5);
        EXPECT_EQ(program.moves[2].blend, 0.0) << "it waits there";
      }
}

TEST(ProgramLanguages, NamesKeepTheirLettersAndSayWhatChanged) {
  EXPECT_EQ(programName("Étape 2", ProgramFormat::kRapid), "Etape_2");
  EXPECT_EQ(programName("Größe", ProgramFormat::kVal3), "Grose");
  EXPECT_EQ(programName("test", ProgramFormat::kRapid), "p_test");
  EXPECT_EQ(programName("loop", ProgramFormat::kKrl), "p_loop");
  EXPECT_EQ(programName("weld", ProgramFormat::kFanuc), "WELD");
  std::vector<Text> notes;
  ProgramOptions options;
  options.name = "loop";
  ASSERT_TRUE(exportProgram(motionOf(3, false), ProgramFormat::kKrl, options, &notes));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(english(notes[0]).find("'p_loop'"), std::string::npos) << english(notes[0]);
  notes.clear();
  options.name = "weld";
  ASSERT_TRUE(exportProgram(motionOf(3, false), ProgramFormat::kFanuc, options, &notes));
  EXPECT_TRUE(notes.empty()) << "upper case is no other name";
}

TEST(ProgramLanguages, KrlSetsTheSpeedOfAllSixAxes) {
  const auto files = exportProgram(motionOf(5, true), ProgramFormat::kKrl, {});
  ParsedProgram program;
  ASSERT_EQ(parsed(*files, ProgramFormat::kKrl, program), "");
  for (int axis = 1; axis <= 6; ++axis)
    EXPECT_EQ(program.settings["$VEL_AXIS[" + std::to_string(axis) + "]"], 20.0) << axis;
}

TEST(ProgramLanguages, TheFirstMoveRunsAtItsShareInVal3) {
  const auto files = exportProgram(motionOf(5, true), ProgramFormat::kVal3, {});
  ParsedProgram program;
  ASSERT_EQ(parsed(*files, ProgramFormat::kVal3, program), "");
  EXPECT_EQ(program.settings["joint speed"], 20.0);
  EXPECT_EQ(program.settings["lines' joint speed"], 100.0);
}

/// Numbers are written within half a per mille, or refused in a sentence.
TEST(ProgramLanguages, ANumberThatALanguageCannotHoldIsRefused) {
  struct Case {
    ProgramFormat format;
    double speed, joint_speed, blend, dwell;
    bool is_written;
  };
  using enum ProgramFormat;
  const std::vector<Case> cases{
      {kFanuc, 5.0, 0.2, 0.002, 0.0, false},       {kFanuc, 0.0004, 0.2, 0.002, 0.0, false},
      {kFanuc, 0.25, 0.2, 0.002, 0.004, false},    {kFanuc, 0.25, 0.004, 0.002, 0.0, false},
      {kFanuc, 0.25, 0.2, 0.002, 400.0, false},    {kFanuc, 4.0, 1.0, 0.002, 327.67, true},
      {kFanuc, 0.001, 0.01, 0.002, 0.01, true},    {kKrl, 0.00004, 0.2, 0.002, 0.0, false},
      {kKrl, 5.0, 0.2, 0.002, 0.0, false},         {kKrl, 0.25, 0.004, 0.002, 0.0, false},
      {kKrl, 0.25, 0.2, 1e-7, 0.0, false},         {kKrl, 0.25, 0.2, 0.002, 0.0002, false},
      {kKrl, 0.0005, 0.01, 0.0, 0.004, true},      {kRapid, 1e-6, 0.2, 0.002, 0.0, false},
      {kRapid, 0.25, 0.2, 0.002, 0.0004, false},   {kRapid, 5.0, 0.004, 0.0, 0.004, true},
      {kUrScript, 1e-6, 0.2, 0.002, 0.0, false},   {kUrScript, 0.25, 0.0001, 0.002, 0.0, false},
      {kUrScript, 0.0005, 0.01, 0.0, 0.004, true}, {kVal3, 1e-7, 0.2, 0.002, 0.0, false},
      {kVal3, 0.25, 0.2, 0.002, 0.0004, false},    {kVal3, 0.0005, 0.01, 0.0, 0.004, true},
      {kInform, 2.0, 0.2, 0.002, 0.0, false},      {kInform, 0.00004, 0.2, 0.002, 0.0, false},
      {kInform, 0.25, 0.2, 0.00004, 0.0, false},   {kInform, 0.25, 0.2, 0.002, 0.004, false},
      {kInform, 1.5, 0.0001, 0.0, 0.01, true}};
  for (const Case& c : cases) {
    ProgramOptions options;
    options.speed = c.speed;
    options.joint_speed = c.joint_speed;
    options.blend = c.blend;
    const auto files = exportProgram(motionOf(6, false, c.dwell), c.format, options);
    const std::string what = std::to_string(static_cast<int>(c.format)) + ": " + std::to_string(c.speed) + ' ' +
                             std::to_string(c.joint_speed) + ' ' + std::to_string(c.blend) + ' ' +
                             std::to_string(c.dwell);
    EXPECT_EQ(files.has_value(), c.is_written) << what << (files ? "" : files.error().message());
    if (!files) {
      EXPECT_NE(files.error().message().find("Nothing was written"), std::string::npos) << files.error().message();
      continue;
    }
    ParsedProgram program;
    ASSERT_EQ(parsed(*files, c.format, program), "") << what;
    double speed = program.settings["speed"] / 1000.0;
    for (const char* setting : {"Lv", "$VEL.CP"})
      if (program.settings.contains(setting)) speed = program.settings[setting];
    EXPECT_NEAR(speed, c.speed, 1e-3 * c.speed) << what;
    EXPECT_NEAR(program.moves[2].dwell, c.dwell, 5e-4 * c.dwell) << what;
  }
  ProgramOptions never;
  never.speed = std::nan("");
  EXPECT_FALSE(exportProgram(motionOf(3, false), kKrl, never));
}

TEST(ProgramLanguages, RoundedNumbersAreNoted) {
  std::vector<Text> notes;
  ProgramOptions options;
  options.speed = 0.0125;
  ASSERT_TRUE(exportProgram(motionOf(3, false), ProgramFormat::kFanuc, options, &notes));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(english(notes[0]).find("12.5 mm/sec"), std::string::npos) << english(notes[0]);
}

TEST(ProgramLanguages, ToolsAndBasesAreOfTheLanguage) {
  ProgramOptions options;
  options.tool = "3";
  options.base = "2";
  for (const ProgramFormat format : {ProgramFormat::kFanuc, ProgramFormat::kInform}) {
    const auto files = exportProgram(motionOf(3, false), format, options);
    ASSERT_TRUE(files) << files.error().message();
    ParsedProgram program;
    EXPECT_EQ(parsed(*files, format, program), "");
    const std::string& text = files->front().content;
    EXPECT_NE(text.find(format == ProgramFormat::kFanuc ? "UF : 2, UT : 3" : "///TOOL 3"), std::string::npos) << text;
  }
  options.tool = "tGrip";
  options.base = "fTable";
  EXPECT_FALSE(exportProgram(motionOf(3, false), ProgramFormat::kFanuc, options)) << "a number there";
  for (const ProgramFormat format : {ProgramFormat::kKrl, ProgramFormat::kRapid, ProgramFormat::kVal3}) {
    const auto files = exportProgram(motionOf(3, false), format, options);
    ASSERT_TRUE(files) << files.error().message();
    ParsedProgram program;
    EXPECT_EQ(parsed(*files, format, program), "") << static_cast<int>(format);
    for (const char* word : {"tGrip", "fTable"}) {
      bool has_word = false;
      for (const auto& file : *files) has_word = has_word || file.content.find(word) != std::string::npos;
      EXPECT_TRUE(has_word) << word << ' ' << static_cast<int>(format);
    }
  }
  options.tool = "tool0;\n  Reset do1";
  EXPECT_FALSE(exportProgram(motionOf(3, false), ProgramFormat::kRapid, options)) << "what ends its statement";
}

/// Any motion comes back from the languages that are read, and from what the grammars found in all six.
RC_GTEST_PROP(ProgramLanguages, AnyMotionComesBack, ()) {
  Trajectory motion;
  motion.name = "any";
  const bool with_joints = *rc::gen::arbitrary<bool>();
  if (with_joints) motion.joint_names = {"1", "2", "3", "4", "5", "6"};
  const auto count = *rc::gen::inRange<std::size_t>(1, 12);
  const auto number = [](double scale) {
    return scale * static_cast<double>(*rc::gen::inRange(-1000000, 1000000)) / 1e6;
  };
  for (std::size_t i = 0; i < count; ++i) {
    // Middle angles of 90 degrees, where two of three angles are one, come as often as any.
    const bool is_square = *rc::gen::inRange(0, 4) == 0;
    dvec3 turn = is_square ? 0.5 * std::numbers::pi *
                                 dvec3(*rc::gen::inRange(-2, 3), *rc::gen::inRange(-2, 3), *rc::gen::inRange(-2, 3))
                           : dvec3(number(3.1), number(3.1), number(3.1));
    const Pose X{{number(3.0), number(3.0), number(3.0)}, quaternionFromRotationVector(turn)};
    std::vector<double> joints;
    for (int j = 0; with_joints && j < 6; ++j) joints.push_back(number(3.0));
    motion.addFrame({0.5 * static_cast<double>(i), X, false, *rc::gen::inRange(0, 3) == 0 ? 0.25 : 0.0}, joints);
  }
  const auto krl = exportProgram(motion, ProgramFormat::kKrl, {});
  const auto rapid = exportProgram(motion, ProgramFormat::kRapid, {});
  const auto fanuc = exportProgram(motion, ProgramFormat::kFanuc, {});
  const auto ur = exportProgram(motion, ProgramFormat::kUrScript, {});
  const auto inform = exportProgram(motion, ProgramFormat::kInform, {});
  RC_ASSERT(krl && rapid && fanuc && ur && inform);
  const ProgramReadOptions none;
  const std::array<Expected<ReadProgram>, 5> read{
      readKrl({(*krl)[0].content, (*krl)[1].content, ""}, none), readRapid(rapid->front().content, none),
      readFanuc(fanuc->front().content, none), readUrScript(ur->front().content, none),
      readInform(inform->front().content, none)};
  for (const auto& program : read) {
    if (!program) RC_FAIL(program.error().message());
    const Trajectory& again = program->trajectory;
    RC_ASSERT(again.size() == motion.size());
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const PoseDistance off = distanceBetween(again[i].X_WT, motion[i].X_WT);
      RC_ASSERT(off.position < 1e-6);
      RC_ASSERT(off.angle < 2e-6);
      RC_ASSERT(std::abs(again[i].dwell - motion[i].dwell) < 1e-9);
      if (i > 0) RC_ASSERT(again[i].t > again[i - 1].t);  // RC_ASSERT() evaluates both sides of an `or`.
    }
  }
  for (const ProgramFormat format : kAllFormats) {
    ParsedProgram found;
    const std::string wrong = parsed(*exportProgram(motion, format, {}), format, found);
    if (!wrong.empty()) RC_FAIL(wrong);
    RC_ASSERT(found.moves.size() == motion.size());
    const double unit = format == ProgramFormat::kUrScript ? 1.0 : 1e-3;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      if (found.moves[i].is_joints) continue;
      for (int axis = 0; axis < 3; ++axis)
        RC_ASSERT(std::abs(unit * found.moves[i].target[static_cast<std::size_t>(axis)] - motion[i].X_WT.p[axis]) <
                  1e-6);
    }
  }
}

}  // namespace
}  // namespace hapticell::trajectory
