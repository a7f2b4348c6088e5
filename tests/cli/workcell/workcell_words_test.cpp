// SPDX-License-Identifier: Apache-2.0
#include "cli/workcell/workcell_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

TEST(WorkcellCommands, TakeTheirWords) {
  test::expectRefusals({addWorkcellCommand},
                       {{{"workcell"}, "subcommand is required"},
                        {{"workcell", "new", "a.hcell", "--add", "box:1,1,1", "--add", "b.stl,name=b"}, ""},
                        {{"workcell", "pack", "a.hcell"}, "--output is required"},
                        {{"workcell", "changes", "a.hcell", "b.hcell", "c.hcell"}, "c.hcell"}});
  EXPECT_THAT(test::OneCommand({addWorkcellCommand}).below("workcell"), ::testing::ElementsAre("new", "pack", "changes"));
  test::OneCommand changes({addWorkcellCommand});
  EXPECT_NE(changes.error({"workcell", "changes", "a.hcell"}), "") << "one document and no import";
}

}  // namespace
}  // namespace hapticell::cli
