// SPDX-License-Identifier: Apache-2.0
// The memory ends in the middle of a change: of the document nothing may be lost, whichever allocation fails.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <new>

#include "tests/support/allocation_guard.h"
#include "tests/support/test_data.h"
#include "tests/workcell/document/every_command.h"
#include "workcell/format/document_io.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::workcell {
namespace {

using test::CommandMaker;
using test::everything;
using test::MemoryShortage;

constexpr std::size_t kMostTries = 100'000;

struct Seen {
  std::string state;
  std::vector<std::string> undo, redo;
  bool dirty = false;
  bool operator==(const Seen&) const = default;
};

Seen look(const Document& document) {
  return {everything(document), document.undoTexts(), document.redoTexts(), document.isDirty()};
}

/// Does `change` with ever more memory until it is enough; each failure must leave `document` as it was. Small counts
/// one by one, then in growing steps. Gives how often the memory ended.
template <typename Change>
std::size_t failsHarmlessly(Document& document, const Change& change, std::size_t smallest = 0) {
  const Seen before = look(document);
  std::size_t failures = 0;
  for (std::size_t granted = 0; granted < kMostTries; granted += 1 + granted / 16) {
    bool done = true;
    try {
      const MemoryShortage shortage(granted, smallest);
      change(document);
    } catch (const std::bad_alloc&) {
      done = false;
    }
    if (done) return failures;
    ++failures;
    const Seen after = look(document);
    EXPECT_EQ(after.state, before.state) << "after " << granted << " allocations";
    EXPECT_TRUE(after == before) << "the history, after " << granted << " allocations";
    EXPECT_FALSE(document.inCompound()) << granted;
    if (::testing::Test::HasFailure()) return failures;
  }
  ADD_FAILURE() << "the change never came to its end";
  return failures;
}

TEST(NoMemory, EveryCommandAndUndoingItIsDoneWholeOrNotAtAll) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  Document document = test::cellOfEverything();
  for (const CommandMaker& make : test::oneOfEach(document)) {
    const Command command = make(document);
    const auto execute = [&command](Document& changed) { EXPECT_TRUE(changed.execute(command)); };
    EXPECT_GT(failsHarmlessly(document, execute), 1U) << "command of kind " << command.index();
    failsHarmlessly(document, [](Document& changed) { EXPECT_TRUE(changed.undo()); });
    failsHarmlessly(document, [](Document& changed) { EXPECT_TRUE(changed.redo()); });
    ASSERT_FALSE(HasFailure()) << "command of kind " << command.index();
  }
}

TEST(NoMemory, AnImportIsTakenBack) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  Document document = test::cellOfEverything();
  const std::vector<Entity> parts{test::makeSolid("part"), test::makeSolid("nut"), test::makeSolid("bolt")};
  const auto import = [&parts](Document& changed) {
    EXPECT_TRUE(addImported(changed, parts, Pose::translation({0, 0, 1})));
  };
  EXPECT_GT(failsHarmlessly(document, import), 20U);
  EXPECT_NE(document.findByName("bolt"), nullptr);
}

TEST(NoMemory, SavingLeavesTheOldFile) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "kept.hcell";
  const auto bytes = [&file] {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  Document document = test::cellOfEverything();
  ASSERT_TRUE(saveDocument(document, file));
  const std::string old = bytes();
  ASSERT_TRUE(document.execute(RenameEntity{document.findByName("part")->id, "another"}));
  const auto save = [&](Document& changed) {
    const auto saved = saveDocument(changed, file);
    // A system call that lacks memory may also be told as an error.
    if (!saved) throw std::bad_alloc();
  };
  const auto saveOrKeep = [&](Document& changed) {
    try {
      save(changed);
    } catch (const std::bad_alloc&) {
      EXPECT_TRUE(bytes() == old) << "the file is not the old one";
      throw;
    }
  };
  // Large pieces only: the JSON library does not live through a shortage of small ones.
  const std::size_t failures = failsHarmlessly(document, saveOrKeep, 1024);
  EXPECT_GT(failures, 2U);
  EXPECT_NE(bytes().find("another"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::workcell
