// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/test_data.h"
#include "trajectory/motion/csv_table.h"
#include "trajectory/motion/motion_spline.h"
#include "trajectory/motion/number_text.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {
namespace {

using ::testing::HasSubstr;

RC_GTEST_PROP(NumberText, TheShortestTextReadsBackToTheLastBit, (double value)) {
  if (!std::isfinite(value)) return;
  const std::string text = shortestText(value);
  RC_ASSERT(text.find(',') == std::string::npos);
  RC_ASSERT(std::strtod(text.c_str(), nullptr) == value);
  RC_ASSERT(std::signbit(std::strtod(text.c_str(), nullptr)) == std::signbit(value));
  RC_ASSERT(parseNumber(text) == value);
}

TEST(NumberText, FixedTextKeepsZerosAndHasNoNegativeZero) {
  EXPECT_EQ(fixedText(1.5, 3), "1.500");
  EXPECT_EQ(fixedText(-0.0004, 3), "0.000");
  EXPECT_EQ(fixedText(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixedText(-0.0, 0), "0");
  EXPECT_EQ(fixedText(1e22, 0), "10000000000000000000000");
  EXPECT_EQ(fixedText(-1e300, 6).size(), 1u + 301u + 7u);
  EXPECT_EQ(shortestText(0.1), "0.1");
  EXPECT_EQ(shortestText(-0.0), "-0.0");
}

RC_GTEST_PROP(NumberText, FixedTextIsOffByHalfADigitAtMost, ()) {
  const double value = *rc::gen::inRange(-10'000'000, 10'000'000) * 1.2345e-4;
  const int decimals = *rc::gen::inRange(0, 7);
  const double again = std::strtod(fixedText(value, decimals).c_str(), nullptr);
  RC_ASSERT(std::abs(again - value) <= 0.5 * std::pow(10.0, -decimals) * (1.0 + 1e-9) + 1e-12);
}

TEST(CsvNumber, IsAFiniteNumberAndNothingElse) {
  EXPECT_EQ(parseNumber(" +1.25e1 "), 12.5);
  EXPECT_EQ(parseNumber("-0.5"), -0.5);
  EXPECT_EQ(parseNumber("\"7\""), 7.0) << "quoted, as spreadsheets do";
  for (const char* none : {"", " ", "1,5", "1.5x", "nan", "inf", "-inf", "1e999", "0x10", "+-5", "++5", "--5", "1 2"}) {
    EXPECT_FALSE(parseNumber(none)) << none;
  }
}

class CsvTables : public ::testing::Test {
 protected:
  Expected<CsvTable> read(const std::string& text) const {
    return readCsvTable(folder_.write("table.csv", text), {"t", "x"}, {"dwell"});
  }
  std::string problem(const std::string& text) const {
    const auto table = read(text);
    return table ? std::string() : table.error().message();
  }
  hapticell::test::TemporaryFolder folder_;
};

TEST_F(CsvTables, OnlyTheWantedColumnsMustBeNumbers) {
  const auto table = read("\xEF\xBB\xBF\"x\";note;t\r\n1;none;0\r\n# between\r\n\r\n2.5;\"-\";0.5\r\n");
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->rows, (std::vector<std::vector<double>>{{0.0, 1.0, 0.0}, {0.5, 2.5, 0.0}}));
  EXPECT_EQ(table->lines, (std::vector<std::size_t>{2, 5}));
  EXPECT_EQ(table->has_optional, (std::vector<bool>{false}));
  const auto whole = read("t,dwell,x\n1,0.25,3");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->rows.at(0), (std::vector<double>{1.0, 3.0, 0.25}));
  EXPECT_EQ(whole->has_optional, (std::vector<bool>{true}));
}

TEST_F(CsvTables, WhatIsWrongIsNamedWithItsPlace) {
  EXPECT_THAT(problem(""), HasSubstr("an empty file"));
  EXPECT_THAT(problem("t,x\n"), HasSubstr("no line after the header"));
  EXPECT_THAT(problem("t,y\n1,2\n"), HasSubstr("no column 'x'"));
  EXPECT_THAT(problem("t,x,x\n1,2,3\n"), HasSubstr("two columns 'x'"));
  EXPECT_THAT(problem("t,x\n1,2\n3\n"), HasSubstr("line 3: 1 fields; expected 2"));
  EXPECT_THAT(problem("t,x\n1,nan\n"), HasSubstr("line 2, column 'x'"));
  EXPECT_THAT(problem("t,x\n1,\n"), HasSubstr("nothing"));
  EXPECT_THAT(problem("t,x\n1," + std::string(70'000, '1')), HasSubstr("65 536"));
  EXPECT_THAT(readCsvTable(folder_.path(), {"t"}).error().message(), HasSubstr("a folder"));
  EXPECT_FALSE(readCsvTable(folder_.path() / "none.csv", {"t"}));
}

/// A helix with two joints.
Trajectory helix(std::size_t frames) {
  Trajectory trajectory;
  trajectory.joint_names = {"a", "b"};
  for (std::size_t i = 0; i < frames; ++i) {
    const double u = 0.05 * static_cast<double>(i);
    const Pose X{{0.3 * std::cos(u), 0.3 * std::sin(u), 0.1 * u},
                 glm::angleAxis(2.5 * u, glm::normalize(dvec3(0.2, 0.1, 1)))};
    const double joints[] = {std::sin(u), 0.5 * u};
    EXPECT_TRUE(trajectory.addFrame({.t = u, .X_WT = X}, joints));
  }
  return trajectory;
}

std::vector<double> timesOf(const Trajectory& trajectory) {
  std::vector<double> times;
  for (const auto& frame : trajectory.frames()) times.push_back(frame.t);
  return times;
}

TEST(MotionSpline, ThroughAllFramesItPassesThem) {
  const Trajectory trajectory = helix(80);  // half turns and more: quaternions change sign on the way
  const std::vector<double> u = timesOf(trajectory);
  const MotionSpline spline = splineThrough(trajectory, u);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const PoseDistance off = distanceBetween(spline.pose(u[i]), trajectory[i].X_WT);
    EXPECT_LT(off.position, 1e-9);
    EXPECT_LT(off.angle, 1e-6);
    EXPECT_NEAR(glm::length(spline.pose(u[i]).q), 1.0, 1e-12);
    EXPECT_NEAR(spline.joints(u[i])[0], trajectory.joints(i)[0], 1e-9);
    EXPECT_NEAR(spline.joints(u[i])[1], trajectory.joints(i)[1], 1e-9);
  }
}

TEST(MotionSpline, AFitKeepsItsDemandAndMeetsTheEnds) {
  const Trajectory trajectory = helix(120);
  const std::vector<double> u = timesOf(trajectory);
  FitDemand demand;
  demand.tolerance = {.position = 2e-4, .angle = 2e-3};
  demand.joint_tolerance = 1e-3;
  const MotionSpline spline = fitMotion(trajectory, u, demand);
  EXPECT_LT(spline.spline().breaks().size(), 60u) << "few spans for a smooth motion";
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    EXPECT_LE(demand.tolerance.shareOf(distanceBetween(spline.pose(u[i]), trajectory[i].X_WT)), 1.0 + 1e-9);
    EXPECT_NEAR(spline.joints(u[i])[0], trajectory.joints(i)[0], 1e-3);
  }
  for (const std::size_t end : {std::size_t{0}, trajectory.size() - 1}) {
    EXPECT_LT(distanceBetween(spline.pose(u[end]), trajectory[end].X_WT).position, 1e-9);
  }
}

TEST(MotionSpline, JerkIsTheThirdDifferenceOfThePosition) {
  const Trajectory trajectory = helix(60);
  const MotionSpline spline = fitMotion(trajectory, timesOf(trajectory), {.tolerance = {.position = 1e-4}});
  const auto& breaks = spline.spline().breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double u = 0.5 * (breaks[i] + breaks[i + 1]), h = 0.2 * (breaks[i + 1] - breaks[i]);
    const dvec3 third = (spline.pose(u + 1.5 * h).p - 3.0 * spline.pose(u + 0.5 * h).p +
                         3.0 * spline.pose(u - 0.5 * h).p - spline.pose(u - 1.5 * h).p) /
                        (h * h * h);
    EXPECT_LT(glm::distance(spline.jerk(u), third), 1e-3 * (1.0 + glm::length(third))) << "one cubic within a span";
  }
}

}  // namespace
}  // namespace hapticell::trajectory
