// SPDX-License-Identifier: Apache-2.0
#include "cli/plan/plan_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(PlanCommand, TakesItsWordsAndOneGoal) {
  test::expectRefusals({addPlanCommand},
                       {{{"plan", "--workcell", "a.hcell", "--entity", "a"}, "--output is required"},
                        {{"plan", "--workcell", "a.hcell", "--entity", "a", "--out", "-o", "b.csv"}, ""},
                        {{"plan", "--workcell", "a.hcell", "--entity", "a", "-o", "b.csv", "--clearance", "11"}, "--clearance"},
                        {{"plan", "--workcell", "a.hcell", "--entity", "a", "-o", "b.csv", "--seed", "-1"}, "--seed"}});
  test::OneCommand none({addPlanCommand});
  EXPECT_NE(none.error({"plan", "--workcell", "/none.hcell", "--entity", "a", "-o", "b.csv"}), "");
  test::OneCommand both({addPlanCommand});
  EXPECT_NE(both.error({"plan", "--workcell", "/none.hcell", "--entity", "a", "-o", "b.csv", "--out", "--to-joints", "1"}), "");
}

}  // namespace
}  // namespace hapticell::cli
