// SPDX-License-Identifier: Apache-2.0
// Undo and redo of every change that a document knows: one of each kind, from a cell that has something of everything.
#include <gtest/gtest.h>

#include <set>

#include "tests/workcell/document/every_command.h"

namespace hapticell::workcell {
namespace {

using test::cellOfEverything;
using test::CommandMaker;
using test::everything;
using test::oneOfEach;

TEST(EveryCommand, IsOneStepThatCanBeUndoneAndRedone) {
  Document document = cellOfEverything();
  const std::vector<CommandMaker> commands = oneOfEach(document);
  const std::size_t before = document.undoTexts().size();
  std::set<std::size_t> kinds;
  std::vector<std::string> states{everything(document)};
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const Command command = commands[k](document);
    const auto done = document.execute(command);
    ASSERT_TRUE(done) << k << ": " << done.error().message();
    kinds.insert(command.index());
    EXPECT_EQ(document.undoTexts().size(), before + k + 1) << k;
    EXPECT_FALSE(document.undoText().empty()) << k;
    states.push_back(everything(document));
    EXPECT_NE(states[k + 1], states[k]) << "step " << k << " changed nothing";
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a kind of command is not tried here";
  for (std::size_t k = commands.size(); k > 0; --k) {
    ASSERT_TRUE(document.undo());
    EXPECT_EQ(everything(document), states[k - 1]) << "undoing step " << k - 1;
  }
  for (std::size_t k = 0; k < commands.size(); ++k) {
    ASSERT_TRUE(document.redo());
    EXPECT_EQ(everything(document), states[k + 1]) << "redoing step " << k;
  }
}

}  // namespace
}  // namespace hapticell::workcell
