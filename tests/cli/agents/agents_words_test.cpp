// SPDX-License-Identifier: Apache-2.0
#include "cli/agents/agents_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(AgentsCommand, TakesItsWordsAndNeedsATask) {
  test::expectRefusals({addAgentsCommand},
                       {{{"agents"}, "task is required"},
                        {{"agents", "a.toml", "--runs", "0"}, "--runs"},
                        {{"agents", "a.toml", "--modes", "operator,both", "--seed", "7"}, ""},
                        {{"agents", "a.toml", "--jobs", "5000"}, "--jobs"}});
  const std::string task = hapticell::test::sourceFile("config/agents/obstacle-field.toml").string();
  test::OneCommand agents({addAgentsCommand});
  EXPECT_THAT(agents.error({"agents", "/none.toml"}), ::testing::HasSubstr("none.toml"));
  EXPECT_THAT(agents.error({"agents", task, "--modes", "robots"}), ::testing::HasSubstr("operator, agents or both"));
  test::OneCommand weighed({addAgentsCommand});
  EXPECT_THAT(weighed.error({"agents", task, "--weights", "goal=101"}), ::testing::HasSubstr("from 0 (off) to 100"));
}

}  // namespace
}  // namespace hapticell::cli
