// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/promise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace hapticell {
namespace {

using ::testing::HasSubstr;

constexpr double kNoMeasurement = std::numeric_limits<double>::quiet_NaN();

Promise atMost(const std::string& name, double asked, double measured) {
  return {.name = name, .asked = asked, .measured = measured};
}

Promise atLeast(const std::string& name, double asked, double measured) {
  return {.name = name, .asked = asked, .measured = measured, .is_at_least = true};
}

TEST(Promise, BoundsIncludeTheirEnds) {
  EXPECT_TRUE(atMost("a", 1.0, 1.0).isKept());
  EXPECT_FALSE(atMost("a", 1.0, std::nextafter(1.0, 2.0)).isKept());
  EXPECT_TRUE(atLeast("a", 1.0, 1.0).isKept());
  EXPECT_FALSE(atLeast("a", 1.0, std::nextafter(1.0, 0.0)).isKept());
}

TEST(Promise, RoundingWidensEitherBound) {
  Promise most = atMost("a", 1.0, 1.05), least = atLeast("a", 1.0, 0.95);
  EXPECT_FALSE(most.isKept());
  EXPECT_FALSE(least.isKept());
  most.rounding = least.rounding = 0.051;
  EXPECT_TRUE(most.isKept());
  EXPECT_TRUE(least.isKept());
}

TEST(Promise, AMeasurementThatIsNoNumberIsMissedAndWorst) {
  EXPECT_FALSE(atMost("a", 1.0, kNoMeasurement).isKept());
  EXPECT_FALSE(atLeast("a", 1.0, kNoMeasurement).isKept());
  for (const bool is_first : {true, false}) {
    Promises promises;
    promises.list = {atMost("position", 1.0, 900.0)};
    promises.list.insert(is_first ? promises.list.begin() : promises.list.end(),
                         atMost("velocity", 1.0, kNoMeasurement));
    ASSERT_NE(promises.worst(), nullptr);
    EXPECT_EQ(promises.worst()->name, "velocity");
  }
}

TEST(Promises, NothingAskedIsKept) {
  EXPECT_TRUE(Promises{}.areKept());
  EXPECT_EQ(Promises{}.worst(), nullptr);
}

TEST(Promises, TheWorstIsMissedByTheLargestShareOfWhatWasAsked) {
  Promises promises;
  promises.list = {atMost("position", 0.001, 0.0011), atMost("velocity", 1.0, 1.05),
                   atLeast("clearance", 0.010, 0.002)};
  ASSERT_NE(promises.worst(), nullptr);
  EXPECT_EQ(promises.worst()->name, "clearance") << "80 % of the clearance is missing, 10 % and 5 % of the others";
  promises.list.back().measured = 0.0095;
  EXPECT_EQ(promises.worst()->name, "position");
  promises.list.front().measured = 0.0;
  promises.list.back().measured = 0.0096;
  EXPECT_EQ(promises.worst()->name, "velocity");
  promises.list[1].measured = -3.0;
  EXPECT_FALSE(promises.areKept());
  promises.list.back().measured = 0.010;
  EXPECT_TRUE(promises.areKept());
}

RC_GTEST_PROP(Promises, TheWorstIsOneThatIsMissedAndExistsWhereAnyIs, ()) {
  const auto numbers = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(1, 1000));
  Promises promises;
  bool is_missed = false;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    promises.list.push_back(i % 4 == 0 ? atMost("m", numbers[i], numbers[i + 1])
                                       : atLeast("l", numbers[i], numbers[i + 1]));
    is_missed = is_missed || !promises.list.back().isKept();
  }
  const auto share = [](const Promise& p) { return std::abs(p.measured - p.asked) / p.asked; };
  RC_ASSERT((promises.worst() != nullptr) == is_missed);
  RC_ASSERT(promises.areKept() == !is_missed);
  if (!is_missed) return;
  RC_ASSERT(!promises.worst()->isKept());
  for (const Promise& each : promises.list) RC_ASSERT(each.isKept() || share(each) <= share(*promises.worst()));
}

TEST(Promises, TheErrorNamesFilePlaceBothNumbersAndTheFix) {
  Promises promises{
      .list =
          {{.name = "position", .asked = 0.001, .measured = 0.01371234, .unit = "m", .place = "at 1.2 s, frame 30"}},
      .help = "Ask for more."};
  const std::string text = promises.missed("weld.csv").message();
  EXPECT_THAT(text, HasSubstr("weld.csv, at 1.2 s, frame 30: position 0.01371 m"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "expected at most 0.001 m. Ask for more. Nothing was written. To write the file anyway, use --allow-miss."));
  promises.list.front() = atLeast("clearance", 0.5, 0.25);
  promises.help = {};
  EXPECT_EQ(promises.missed("").message(),
            "clearance 0.25 of the limit; expected at least 0.5 of the limit. Nothing was written. To write the file "
            "anyway, use --allow-miss.");
}

TEST(PromisesDeathTest, NoErrorOfPromisesThatAreKept) {
  EXPECT_DEATH((void)Promises{}.missed("x"), "contract broken");
}

}  // namespace
}  // namespace hapticell
