// SPDX-License-Identifier: Apache-2.0
// Registers of FANUC's programs, and records and functions of RAPID, by the makers' manuals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "trajectory/programs/reading/fanuc_registers.h"
#include "trajectory/programs/reading/rapid_functions.h"
#include "trajectory/programs/reading/rapid_records.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {
namespace {

using ::testing::HasSubstr;

// --- FANUC: R[] and PR[]

std::map<int, FanucPosition> taughtPositions() {
  FanucPosition position;
  position.X = Pose{{0.1, 0.2, 0.3}, fromFanucAngles({10.0, 20.0, 30.0})};
  return {{4, position}};
}

TEST(FanucRegisters, OperatorsComeInTheirUsualOrderFromTheLeft) {
  const auto positions = taughtPositions();
  FanucRegisters registers(positions);
  registers.set(1, 10.0);
  EXPECT_EQ(registers.number("R[1]-4-3"), 3.0);
  EXPECT_EQ(registers.number("2*3+1"), 7.0);
  EXPECT_EQ(registers.number("1+2*R[1]"), 21.0);
  EXPECT_EQ(registers.number("8/2/2"), 2.0);
  EXPECT_EQ(registers.number("-5"), -5.0);
  EXPECT_EQ(registers.number("5*-2"), -10.0);
  EXPECT_EQ(registers.number("R[1]-R[1]+1"), 1.0);
}

TEST(FanucRegisters, WhatTheFileDoesNotSayIsUnknown) {
  const auto positions = taughtPositions();
  FanucRegisters registers(positions);
  EXPECT_FALSE(registers.number("R[2]"));
  EXPECT_FALSE(registers.number("R[2]+1"));
  EXPECT_FALSE(registers.number("1/0"));
  EXPECT_FALSE(registers.number("DI[3]"));
  EXPECT_FALSE(registers.number(""));
  registers.set(2, 1.0);
  EXPECT_TRUE(registers.assign("R[2]=DI[3]"));
  EXPECT_FALSE(registers.value(2)) << "no longer 1, and not 0";
  EXPECT_FALSE(registers.assign("WAIT"));
}

TEST(FanucRegisters, ConditionsHoldAreFalseOrAreNotKnown) {
  const auto positions = taughtPositions();
  FanucRegisters registers(positions);
  ASSERT_TRUE(registers.assign("R[1]=2"));
  EXPECT_EQ(registers.holds("R[1:COUNT] = 2"), true);
  EXPECT_EQ(registers.holds("(R[1]<>2)"), false);
  EXPECT_EQ(registers.holds("R[1]>=2 AND R[1]<3"), true);
  EXPECT_EQ(registers.holds("R[1]>2 OR R[1]=1 AND R[1]=2"), false);
  EXPECT_FALSE(registers.holds("DI[1]=ON"));
  EXPECT_FALSE(registers.holds("R[1]=2 AND DI[1]=ON"));
}

TEST(FanucRegisters, PositionRegistersAreSetWholeAndByElement) {
  const auto positions = taughtPositions();
  FanucRegisters registers(positions);
  EXPECT_EQ(registers.position(1), nullptr);
  ASSERT_TRUE(registers.assignPosition("PR[1]=P[4]", {}));
  ASSERT_TRUE(registers.position(1));
  EXPECT_NEAR(registers.number("PR[1,2]").value_or(0.0), 200.0, 1e-9) << "mm";
  EXPECT_NEAR(registers.number("PR[1,6]").value_or(0.0), 30.0, 1e-9) << "R in degrees";
  ASSERT_TRUE(registers.assignPosition("PR[1,3]=PR[1,3]-25-5", {}));
  EXPECT_LT(glm::distance(registers.position(1)->X->p, dvec3(0.1, 0.2, 0.27)), 1e-12);
  ASSERT_TRUE(registers.assignPosition("PR[1,4]=-10", {}));
  EXPECT_LT(glm::distance(fanucAngles(registers.position(1)->X->q), dvec3(-10.0, 20.0, 30.0)), 1e-9);
  ASSERT_TRUE(registers.assignPosition("PR[2]=LPOS", {}));
  EXPECT_EQ(registers.position(2), nullptr) << "nobody knows where the robot is";
  FanucPosition here;
  here.X = Pose::translation({1, 2, 3});
  ASSERT_TRUE(registers.assignPosition("PR[2]=LPOS", here));
  EXPECT_EQ(registers.position(2)->X->p, dvec3(1, 2, 3));
  ASSERT_TRUE(registers.assignPosition("PR[2]=P[4]+PR[1]", {}));
  EXPECT_EQ(registers.position(2), nullptr) << "a sum of positions is not understood, so it is unknown";
  ASSERT_TRUE(registers.assignPosition("PR[1,2]=R[9]", {}));
  EXPECT_EQ(registers.position(1), nullptr);
  EXPECT_FALSE(registers.assignPosition("PR[1]", {}));
}

TEST(FanucRegisters, WhatStandsInBrackets) {
  EXPECT_EQ(fanucBracketed("L P[12:ABOVE] 10MM/SEC", "P["), 12);
  EXPECT_FALSE(fanucBracketed("P[R[1]]", "P["));
  EXPECT_FALSE(fanucBracketed("P[-1]", "P["));
  EXPECT_FALSE(fanucBracketed("P[99999999999]", "P["));
  EXPECT_EQ(fanucRegisterIn("PR[2,3:NAME]"), std::pair(2, 3));
  EXPECT_EQ(fanucRegisterIn("PR[2:NAME]"), std::pair(2, 0));
  EXPECT_FALSE(fanucRegisterIn("PR[2,12]"));
  EXPECT_FALSE(fanucRegisterIn("R[2]"));
  EXPECT_EQ(fanucWithoutBlanks("R[1:UP-DOWN] = 2"), "R[1]=2");
  EXPECT_EQ(fanucWithoutBlanks("R[1:NEVER CLOSED"), "R[1:NEVERCLOSED");
}

// --- RAPID

Value targetAt(const dvec3& p_mm, const dquat& q) {
  return Value::list("robtarget", {Value::list("pos", {p_mm.x, p_mm.y, p_mm.z}),
                                   Value::list("orient", {q.w, q.x, q.y, q.z}), Value::list("", {0, 0, 0, 0})});
}

std::vector<Argument> argumentsOf(const std::vector<Value>& values) {
  std::vector<Argument> given;
  for (const Value& value : values) given.push_back({"", value});
  return given;
}

TEST(RapidRecords, APoseIsInMillimetresWithTheRealPartFirst) {
  const dquat q = glm::angleAxis(0.4, glm::normalize(dvec3(1, 2, 3)));
  const auto X = rapidPose(targetAt({100, -200, 300}, q));
  ASSERT_TRUE(X);
  EXPECT_LT(glm::distance(X->p, dvec3(0.1, -0.2, 0.3)), 1e-12);
  EXPECT_GT(std::abs(glm::dot(X->q, q)), 1.0 - 1e-12);
  EXPECT_FALSE(rapidPose(targetAt({0, 0, 0}, dquat(0.9, 0, 0, 0)))) << "no turn";
  EXPECT_FALSE(rapidPose(Value::of(1.0)));
  EXPECT_FALSE(rapidPose(Value::list("pose", {Value::list("pos", {1, 2, 3}), Value::unknown("q")})));
}

TEST(RapidRecords, ATargetKeepsWhatItHadBesidesItsPlace) {
  const Value moved = rapidTarget(Pose::translation({1, 2, 3}), targetAt({0, 0, 0}, dquat(1, 0, 0, 0)));
  EXPECT_EQ(moved.items[0].numbers(3), (std::vector<double>{1000, 2000, 3000}));
  EXPECT_EQ(moved.items[2].numbers(4), (std::vector<double>{0, 0, 0, 0})) << "its configuration";
  const Value fresh = rapidTarget(Pose::identity(), Value::unknown("nothing"));
  EXPECT_EQ(fresh.text, "robtarget");
  EXPECT_FALSE(fresh.items[2].isKnown());
}

TEST(RapidRecords, FieldsHavePlacesAndTypes) {
  using Field = std::pair<std::size_t, std::string>;
  EXPECT_EQ(rapidField("robtarget", "rot"), Field(1, "orient"));
  EXPECT_EQ(rapidField("pos", "z"), Field(2, ""));
  EXPECT_EQ(rapidField("wobjdata", "oframe"), Field(4, "pose"));
  EXPECT_EQ(rapidField("", "rax_6"), Field(5, "")) << "the first record that has it";
  EXPECT_FALSE(rapidField("pos", "q1"));
  EXPECT_FALSE(rapidField("pos", ""));
}

TEST(RapidFunctions, OffsGoesInTheFrameAndRelToolInTheTool) {
  const dquat down = glm::angleAxis(std::numbers::pi, dvec3(1, 0, 0));
  const Value target = targetAt({100, 0, 500}, down);
  auto given = argumentsOf({target, Value::of(10.0), Value::of(20.0), Value::of(30.0)});
  const auto above = rapidPose(rapidFunction("offs", given, {}));
  ASSERT_TRUE(above);
  EXPECT_LT(glm::distance(above->p, dvec3(0.11, 0.02, 0.53)), 1e-12);
  const auto beside = rapidPose(rapidFunction("reltool", given, {}));
  ASSERT_TRUE(beside);
  EXPECT_LT(glm::distance(beside->p, dvec3(0.11, -0.02, 0.47)), 1e-12) << "the tool looks down";
  given.push_back({"rz", Value::of(90.0)});
  const auto turned = rapidPose(rapidFunction("reltool", given, {}));
  ASSERT_TRUE(turned);
  const dquat expected = down * glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 0, 1));
  EXPECT_GT(std::abs(glm::dot(turned->q, expected)), 1.0 - 1e-12);
}

TEST(RapidFunctions, NumbersAreThoseOfTheManual) {
  const auto number = [](const std::string& name, const std::vector<double>& of) {
    std::vector<Value> values;
    for (const double one : of) values.push_back(Value::of(one));
    return rapidFunction(name, argumentsOf(values), {});
  };
  EXPECT_NEAR(number("sin", {30.0}).number, 0.5, 1e-12) << "degrees";
  EXPECT_NEAR(number("atan2", {1.0, -1.0}).number, 135.0, 1e-12);
  EXPECT_NEAR(number("acos", {0.5}).number, 60.0, 1e-12);
  EXPECT_EQ(number("pow", {2.0, 10.0}).number, 1024.0);
  EXPECT_EQ(number("trunc", {-2.7}).number, -2.0);
  EXPECT_EQ(number("round", {2.5}).number, 3.0);
  EXPECT_FALSE(number("sqrt", {-1.0}).isKnown());
  EXPECT_FALSE(number("round", {2.55, 1.0}).isKnown()) << "with \\Dec: not read";
  const Value turn = number("orientzyx", {90.0, 0.0, 0.0});
  EXPECT_NEAR(turn.items[3].number, std::sqrt(0.5), 1e-12) << "about z first";
}

TEST(RapidFunctions, WhatIsUnknownSaysWhy) {
  EXPECT_FALSE(rapidFunction("crobt", {}, {}).isKnown()) << "nobody knows where the robot is";
  EXPECT_TRUE(rapidPose(rapidFunction("crobt", {}, Pose::translation({1, 0, 0}))));
  const Value none = rapidFunction("offs", argumentsOf({Value::unknown("'p10' is not given")}), {});
  EXPECT_THAT(english(none.whyUnknown()), HasSubstr("p10"));
  EXPECT_FALSE(rapidFunction("dotprod", argumentsOf({Value::of(1.0)}), {}).isKnown());
  EXPECT_THAT(english(rapidWord("di_grip").whyUnknown()), HasSubstr("di_grip"));
}

TEST(RapidFunctions, WhatRapidDefinesByItself) {
  EXPECT_EQ(rapidWord("v200").items[0].number, 200.0) << "mm/s";
  EXPECT_EQ(rapidWord("pi").number, std::numbers::pi);
  EXPECT_EQ(rapidWord("wobj0").items.size(), 5u);
  EXPECT_TRUE(rapidPose(rapidWord("tool0").items[1]));
  EXPECT_FALSE(rapidNumberAt(argumentsOf({Value::of(1.0)}), 1));
  EXPECT_EQ(rapidNumberAt(argumentsOf({Value::of(1.0)}), 0), 1.0);
}

}  // namespace
}  // namespace hapticell::trajectory
