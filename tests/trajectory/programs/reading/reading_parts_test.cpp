// SPDX-License-Identifier: Apache-2.0
// What programs of controllers are read with: words, expressions, angles, and the path that their moves make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "trajectory/programs/reading/fanuc_file.h"
#include "trajectory/programs/reading/krl_parser.h"
#include "trajectory/programs/reading/program_expression.h"
#include "trajectory/programs/reading/program_path.h"
#include "trajectory/programs/reading/program_run.h"
#include "trajectory/programs/reading/program_tokens.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// --- Angles

double angleApartOf(const dquat& a, const dquat& b) {
  return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

RC_GTEST_PROP(RobotAngles, TakenApartAndPutTogetherTheyAreTheSameTurn, ()) {
  const auto part = [] { return *rc::gen::inRange(-100, 101) * 1e-2; };
  const double w = part(), x = part(), y = part(), z = part();
  dquat q(w, x, y, z);
  RC_PRE(glm::length(q) > 0.1);
  q = glm::normalize(q);
  RC_ASSERT(angleApartOf(fromKukaAngles(kukaAngles(q)), q) < 1e-6);
  RC_ASSERT(angleApartOf(fromFanucAngles(fanucAngles(q)), q) < 1e-6);
  RC_ASSERT(angleApartOf(fromStaubliAngles(staubliAngles(q)), q) < 1e-6);
  RC_ASSERT(std::abs(kukaAngles(q).y) <= 90.0 && std::abs(staubliAngles(q).y) <= 90.0);
}

TEST(RobotAngles, AreDegreesInTheOrderOfEachMaker) {
  const dquat q =
      glm::angleAxis(0.5, dvec3(0, 0, 1)) * glm::angleAxis(0.3, dvec3(0, 1, 0)) * glm::angleAxis(0.2, dvec3(1, 0, 0));
  const double degree = 180.0 / std::numbers::pi;
  EXPECT_LT(glm::distance(kukaAngles(q), degree * dvec3(0.5, 0.3, 0.2)), 1e-9) << "A about Z, B about Y, C about X";
  EXPECT_LT(glm::distance(fanucAngles(q), degree * dvec3(0.2, 0.3, 0.5)), 1e-9) << "W, P, R";
  const dquat s =
      glm::angleAxis(0.5, dvec3(1, 0, 0)) * glm::angleAxis(0.3, dvec3(0, 1, 0)) * glm::angleAxis(0.2, dvec3(0, 0, 1));
  EXPECT_LT(glm::distance(staubliAngles(s), degree * dvec3(0.5, 0.3, 0.2)), 1e-9);
}

TEST(RobotAngles, AtARightMiddleAngleTheLastOneIsZero) {
  for (const double middle : {-90.0, 90.0}) {
    const dquat kuka = fromKukaAngles({20.0, middle, 50.0}), staubli = fromStaubliAngles({20.0, middle, 50.0});
    EXPECT_EQ(kukaAngles(kuka).z, 0.0);
    EXPECT_LT(angleApartOf(fromKukaAngles(kukaAngles(kuka)), kuka), 1e-6);
    EXPECT_EQ(staubliAngles(staubli).z, 0.0);
    EXPECT_LT(angleApartOf(fromStaubliAngles(staubliAngles(staubli)), staubli), 1e-6);
  }
}

// --- Words and expressions

std::vector<std::string> textsOf(const Tokens& tokens) {
  std::vector<std::string> texts;
  for (const Token& token : tokens) texts.push_back(token.kind == Token::Kind::kLineEnd ? "|" : token.text);
  return texts;
}

TEST(ProgramTokens, WordsNumbersTextsSignsAndLines) {
  const Tokens tokens =
      tokensOf("&ACCESS RVP\nPTP {X 1.5e-2, Y -.5} ; remark\n\nTxt = \"A ; b\" #BASE <> $VEL.CP", krl());
  EXPECT_EQ(textsOf(tokens), (std::vector<std::string>{"ptp", "{", "x", "1.5e-2", ",", "y", "-", ".5", "}", "|", "txt",
                                                       "=", "A ; b", "#base", "<>", "$vel", ".", "cp", "|"}));
  EXPECT_EQ(tokens[3].number, 0.015);
  EXPECT_EQ(tokens[7].number, 0.5);
  EXPECT_EQ(tokens[0].line, 2u);
  EXPECT_EQ(tokens[10].line, 4u);
  EXPECT_TRUE(tokens[0].isWord() && tokens[0].is("ptp"));
  EXPECT_FALSE(tokens[12].is("A ; b")) << "a text is no word";
}

TEST(ProgramTokens, AnythingIsTakenApartSomehow) {
  EXPECT_TRUE(tokensOf("", krl()).empty());
  EXPECT_TRUE(tokensOf("\n\n; only a remark", krl()).empty());
  EXPECT_EQ(textsOf(tokensOf("\"never closed\nPTP", krl())),
            (std::vector<std::string>{"never closed", "|", "ptp", "|"}));
  EXPECT_EQ(textsOf(tokensOf("1e 2.", krl())), (std::vector<std::string>{"1", "e", "2.", "|"}));
  const Tokens pose = tokensOf("PTP x ; HaptiCell pose [1,2]", krl());
  EXPECT_THAT(textsOf(pose), Contains("@pose"));
}

class Expressions : public ::testing::Test {
 protected:
  Expressions() {
    variables_["seven"] = Value::of(7.0);
    meaning_.find = [this](const std::string& name) {
      const auto found = variables_.find(name);
      return found == variables_.end() ? nullptr : &found->second;
    };
    meaning_.variable = [](const std::string& name) { return Value::unknown("'" + name + "' is not given"); };
    meaning_.call = [](const std::string& name, const std::vector<Argument>& arguments) {
      return name == "half" && arguments.size() == 1 ? Value::of(0.5 * arguments[0].value.number)
                                                     : Value::unknown(name);
    };
    meaning_.field = [](const Value&, const std::string&) { return Value::unknown("no record"); };
  }
  Value valueOf(const std::string& text) {
    const Tokens tokens = tokensOf(text, krl());
    ExpressionReader reader(tokens, 0, krl(), meaning_);
    Value value = reader.expression();
    is_at_end_ = reader.isAtEnd();
    return value;
  }
  std::map<std::string, Value> variables_;
  ExpressionMeaning meaning_;
  bool is_at_end_ = false;
};

TEST_F(Expressions, HaveTheUsualOrderOfOperators) {
  EXPECT_EQ(valueOf("1 + 2 * 3 - 4 / 2").number, 5.0);
  EXPECT_EQ(valueOf("(1 + 2) * -3").number, -9.0);
  EXPECT_EQ(valueOf("2 - 3 - 4").number, -5.0) << "from the left";
  EXPECT_EQ(valueOf("seven * half(4)").number, 14.0);
  EXPECT_EQ(valueOf("1 + 1 == 2 AND NOT (3 < 2)").number, 1.0);
  EXPECT_EQ(valueOf("1 > 2 OR 2 <> 2").number, 0.0);
  EXPECT_TRUE(is_at_end_);
}

TEST_F(Expressions, WhatDependsOnSomethingElseIsUnknownAndSaysWhy) {
  const Value value = valueOf("1 + missing");
  EXPECT_FALSE(value.isKnown());
  EXPECT_EQ(english(value.whyUnknown()), "'missing' is not given");
  EXPECT_FALSE(valueOf("1 / 0").isKnown());
  EXPECT_FALSE(valueOf("").isKnown());
  EXPECT_FALSE(valueOf(std::string(5000, '(') + "1").isKnown()) << "too deep, and no stack overflow";
}

TEST_F(Expressions, ARecordHasItsFields) {
  const Value record = valueOf("{X 1.0, Y seven, Z -2}");
  EXPECT_EQ(record.kind, Value::Kind::kRecord);
  EXPECT_EQ(record.numberOf("y"), 7.0);
  EXPECT_EQ(record.numberOf("z"), -2.0);
  EXPECT_FALSE(record.numberOf("a"));
}

TEST_F(Expressions, AStepIntoAVariableIsTakenApart) {
  const Tokens tokens = tokensOf("points[3].x = 1", krl());
  ExpressionReader reader(tokens, 0, krl(), meaning_);
  std::vector<AccessStep> steps;
  EXPECT_EQ(reader.path(steps), "points");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].index, 3.0);
  EXPECT_EQ(steps[1].field, "x");
  EXPECT_TRUE(reader.next().is("="));
}

// --- Paths

TEST(ProgramPath, MovesAreFramesWithTimesByTheirSpeeds) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  path.setLinearSpeed(0.5);
  path.moveTo(1, Pose::translation({0, 0, 0}), true);
  path.moveTo(2, Pose::translation({1, 0, 0}), false);
  path.wait(0.25);
  path.moveTo(3, Pose::translation({1, 1, 0}), false);
  EXPECT_EQ(path.current()->p, dvec3(1, 1, 0));
  const auto program = path.finish("weld");
  ASSERT_TRUE(program) << program.error().message();
  ASSERT_EQ(program->trajectory.size(), 3u);
  EXPECT_NEAR(program->trajectory[1].t - program->trajectory[0].t, 2.0, 1e-9) << "1 m at 0.5 m/s";
  EXPECT_EQ(program->trajectory[1].dwell, 0.25);
  EXPECT_EQ(program->trajectory[2].X_WT.p, dvec3(1, 1, 0));
}

TEST(ProgramPath, TargetsAreOfThePresentFrame) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  path.setFrame(Pose{{1, 0, 0}, glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 0, 1))}, "table");
  path.moveTo(1, Pose::translation({0.5, 0, 0}), false);
  path.moveTo(2, Pose::translation({0.7, 0, 0}), false);
  const auto program = path.finish("p");
  ASSERT_TRUE(program);
  EXPECT_LT(glm::distance(program->trajectory[0].X_WT.p, dvec3(1.0, 0.5, 0.0)), 1e-12);
}

TEST(ProgramPath, AnArcStaysOnItsCircle) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  path.moveTo(1, Pose::translation({0.2, 0, 0}), false);
  path.moveArc(2, Pose::translation({0, 0.2, 0}), Pose::translation({-0.2, 0, 0}));
  const auto program = path.finish("arc");
  ASSERT_TRUE(program);
  ASSERT_GT(program->trajectory.size(), 10u);
  double most = 0.0;
  for (std::size_t i = 0; i < program->trajectory.size(); ++i) {
    const dvec3& p = program->trajectory[i].X_WT.p;
    EXPECT_NEAR(glm::length(p), 0.2, 1e-9);
    EXPECT_GE(p.y, -1e-9) << "by way of the point between";
    if (i > 0) most = std::max(most, glm::distance(p, program->trajectory[i - 1].X_WT.p));
  }
  EXPECT_LT(0.2 - std::sqrt(0.04 - 0.25 * most * most), 1e-4 + 1e-9) << "chords within 0.1 mm of the arc";
}

TEST(ProgramPath, AMissingTargetIsLeftOutAtTheEndsAndAnErrorInBetween) {
  const ProgramReadOptions options;
  ProgramPath ends(options);
  ends.missTarget(1, "home is not given");
  ends.moveTo(2, {}, false);
  ends.moveTo(3, Pose::translation({1, 0, 0}), false);
  ends.missTarget(4, "home is not given");
  const auto program = ends.finish("p");
  ASSERT_TRUE(program) << program.error().message();
  EXPECT_EQ(program->trajectory.size(), 2u);
  EXPECT_FALSE(program->notes.empty());
  ProgramPath middle(options);
  middle.moveTo(2, {}, false);
  middle.missTarget(3, "p7 is not given");
  middle.moveTo(4, Pose::translation({1, 0, 0}), false);
  const auto broken = middle.finish("p");
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message(), HasSubstr("line 3"));
}

TEST(ProgramPath, TheFirstErrorStaysAndNothingIsTakenAfterIt) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  path.moveTo(1, {}, false);
  path.fail(2, "a jump", "none", "");
  path.fail(3, "another thing", "none", "");
  EXPECT_TRUE(path.hasFailed());
  const auto program = path.finish("p");
  ASSERT_FALSE(program);
  EXPECT_THAT(program.error().message(), HasSubstr("a jump"));
  EXPECT_FALSE(ProgramPath(options).finish("empty")) << "no target at all";
}

// --- Runs

/// A language of moves "go N" along x and of assignments: enough for loops and branches of KRL.
class Walk final : public ProgramRun {
 public:
  explicit Walk(ProgramPath& path) : ProgramRun(krl(), path) {}
  std::vector<double> went;
  using ProgramRun::find;

 protected:
  Flow plain(const Statement& statement) override {
    if (isMove(statement)) {
      const Value value = evaluate(Tokens(statement.tokens.begin() + 1, statement.tokens.end()));
      if (!value.isKnown()) path_.fail(statement.line, value.whyUnknown(), "a number", "");
      went.push_back(value.number);
      return Flow::kNext;
    }
    ExpressionReader reader(statement.tokens, 0, krl(), meaning_);
    std::vector<AccessStep> steps;
    const std::string name = reader.path(steps);
    if (reader.take("=")) assign(name, steps, reader.expression());
    return Flow::kNext;
  }
  bool isMove(const Statement& statement) const override {
    return !statement.tokens.empty() && statement.tokens[0].is("go");
  }
};

class Runs : public ::testing::Test {
 protected:
  std::vector<double> run(const std::string& body) {
    const Tokens tokens = tokensOf("DEF main()\n" + body + "\nEND\n", krl());
    std::vector<Routine> routines;
    Block data;
    parseKrl(tokens, path_, routines, data);
    if (routines.size() != 1) {
      ADD_FAILURE() << routines.size() << " routines";
      return {};
    }
    EXPECT_EQ(routines[0].name, "main");
    Walk walk(path_);
    walk.run(routines[0].body);
    return walk.went;
  }
  ProgramReadOptions options_;
  ProgramPath path_{options_};
};

TEST_F(Runs, LoopsAndBranchesGoAsTheyAreWritten) {
  EXPECT_EQ(run("FOR i = 1 TO 5 STEP 2\ngo i\nENDFOR\ngo 9"), (std::vector<double>{1, 3, 5, 9}));
  EXPECT_EQ(run("n = 3\nWHILE n > 0\ngo n\nn = n - 1\nENDWHILE"), (std::vector<double>{3, 2, 1}));
  EXPECT_EQ(run("n = 3\nREPEAT\ngo n\nn = n + 1\nUNTIL n > 4"), (std::vector<double>{3, 4}));
  EXPECT_EQ(run("IF 2 > 1 THEN\ngo 1\nELSE\ngo 2\nENDIF"), (std::vector<double>{1}));
  EXPECT_EQ(run("n = 2\nSWITCH n\nCASE 1\ngo 10\nCASE 2, 3\ngo 20\nDEFAULT\ngo 30\nENDSWITCH"),
            (std::vector<double>{20}));
  EXPECT_EQ(run("p.x = 4\np.x = p.x + 1\ngo p.x"), (std::vector<double>{5}));
  EXPECT_FALSE(path_.hasFailed());
}

TEST_F(Runs, AnUnknownConditionWithMovesInItIsAnError) {
  run("IF $IN[1] THEN\ngo 1\nENDIF");
  EXPECT_TRUE(path_.hasFailed());
}

TEST_F(Runs, AnEndlessProgramIsEnded) {
  const std::vector<double> went = run("n = 1\nWHILE n > 0\nn = n + 1\nENDWHILE");
  EXPECT_TRUE(path_.hasFailed()) << "after 500 000 statements";
  EXPECT_TRUE(went.empty());
}

TEST_F(Runs, ABlockWithoutItsEndFailsWithItsLine) {
  const Tokens tokens = tokensOf("DEF main()\nLOOP\ngo 1\nEND\n", krl());
  std::vector<Routine> routines;
  Block data;
  parseKrl(tokens, path_, routines, data);
  EXPECT_TRUE(path_.hasFailed());
}

TEST(KrlParser, LinesOutsideOfRoutinesAreData) {
  const ProgramReadOptions options;
  ProgramPath path(options);
  std::vector<Routine> routines;
  Block data;
  parseKrl(tokensOf("DEFDAT cell PUBLIC\nDECL E6POS xp1={X 1,Y 2,Z 3,A 0,B 0,C 0}\nDECL FDAT fp1\nENDDAT\n", krl()),
           path, routines, data);
  EXPECT_FALSE(path.hasFailed());
  EXPECT_TRUE(routines.empty());
  EXPECT_GE(data.size(), 1u);
}

// --- FANUC's files

TEST(FanucFile, PartsLinesAndPositions) {
  const FanucFile file = parseFanuc(
      "/PROG  WELD_1\n/ATTR\nOWNER = MNEDITOR;\n/MN\n   1:  !a remark ;\n   2:L P[1:above] 250mm/sec FINE    ;\n"
      "   3:J P[2] 100% CNT50\n    :  ;\n/POS\nP[1:\"above\"]{\n   GP1:\n\tUF : 1, UT : 2,\t\tCONFIG : 'N U T, 0, 0, "
      "0',\n"
      "\tX =   100.000  mm,\tY =  -200.000  mm,\tZ =   300.000  mm,\n\tW =   180.000 deg,\tP =     0.000 deg,\tR =    "
      "90.000 deg\n};\n"
      "P[2]{\n   GP1:\n\tUF : 0, UT : 1,\n\tJ1= 10.0 deg,\tJ2= 20.0 deg,\tJ3= 30.0 deg,\n\tJ4= 0.0 deg,\tJ5= -90.0 "
      "deg,\tJ6= 45.0 deg\n};\n/END\n");
  EXPECT_EQ(file.name, "WELD_1");
  ASSERT_EQ(file.lines.size(), 2u) << "without the remark; what goes on is one";
  EXPECT_THAT(file.lines[0].text, HasSubstr("P[1"));
  EXPECT_EQ(file.lines[0].line, 6u);
  ASSERT_TRUE(file.positions.contains(1) && file.positions.contains(2));
  const FanucPosition& above = file.positions.at(1);
  ASSERT_TRUE(above.X);
  EXPECT_LT(glm::distance(above.X->p, dvec3(0.1, -0.2, 0.3)), 1e-12) << "metres";
  EXPECT_LT(angleApartOf(above.X->q, fromFanucAngles({180.0, 0.0, 90.0})), 1e-6);
  EXPECT_EQ(above.frame, 1);
  EXPECT_FALSE(above.joints || above.has_more_groups || above.has_external_axes);
  const FanucPosition& joints = file.positions.at(2);
  ASSERT_TRUE(joints.joints);
  EXPECT_FALSE(joints.X);
  EXPECT_NEAR((*joints.joints)[4], -0.5 * std::numbers::pi, 1e-12) << "radians";
}

TEST(FanucFile, WhatIsNotTaughtHasNoPosition) {
  const FanucFile file = parseFanuc(
      "/PROG A\n/POS\nP[3]{\n GP1:\n UF : F, UT : 1,\n X = ******** mm, Y = 1 mm, Z = 1 mm, W = 0 deg, P = 0 deg, R = "
      "0 deg\n};\n/END\n");
  ASSERT_TRUE(file.positions.contains(3));
  EXPECT_FALSE(file.positions.at(3).X);
  EXPECT_EQ(file.positions.at(3).frame, -1) << "the frame that is chosen when it runs";
  EXPECT_TRUE(parseFanuc("").lines.empty());
  EXPECT_TRUE(parseFanuc("/POS\nP[99999999999]{\n};\n").positions.empty());
}

}  // namespace
}  // namespace hapticell::trajectory
