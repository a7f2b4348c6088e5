// SPDX-License-Identifier: Apache-2.0
// Two programs on one document notice each other, and what a dead one left counts for nothing.
#include "workcell/files/document_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/support/test_data.h"
#include "workcell/files/autosave.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

class DocumentLockTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path file() const { return folder_.path() / "cell.hcell"; }

  /// A process that has the document open until this ends it; another than this one.
  class OtherProgram {
   public:
    explicit OtherProgram(const fs::path& document) {
      int ends[2];
      EXPECT_EQ(::pipe(ends), 0);
      child_ = ::fork();
      if (child_ == 0) {
        const DocumentLock lock = DocumentLock::take(document);
        char held = lock.isHeld() ? 'y' : 'n';
        (void)!::write(ends[1], &held, 1);
        for (;;) ::pause();
      }
      char held = 0;
      EXPECT_EQ(::read(ends[0], &held, 1), 1);
      EXPECT_EQ(held, 'y');
      ::close(ends[0]);
      ::close(ends[1]);
    }
    pid_t process() const { return child_; }
    void kill() {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
    }

   private:
    pid_t child_ = 0;
  };
};

TEST_F(DocumentLockTest, TheSecondProgramIsToldWhoHasIt) {
  OtherProgram other(file());
  DocumentLock lock = DocumentLock::take(file());
  EXPECT_FALSE(lock.isHeld());
  ASSERT_TRUE(lock.owner());
  EXPECT_EQ(lock.owner()->process, other.process());
  EXPECT_FALSE(lock.owner()->user.empty());
  EXPECT_NE(lock.owner()->process_start, 0u);
  const auto refused = DocumentLock::takeForWriting(file());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), ::testing::HasSubstr("process " + std::to_string(other.process())));
  EXPECT_FALSE(lock.tryAgain());
  lock.takeOver();
  EXPECT_FALSE(lock.isHeld()) << "he lives, and here";
  other.kill();
  EXPECT_TRUE(lock.tryAgain()) << "what a dead program left counts for nothing";
  EXPECT_TRUE(lock.isHeld());
}

TEST_F(DocumentLockTest, GoesWithItsOwner) {
  {
    const DocumentLock lock = DocumentLock::take(file());
    EXPECT_TRUE(lock.isHeld());
    EXPECT_TRUE(fs::exists(lockOf(file())));
    EXPECT_TRUE(DocumentLock::take(file()).owner()) << "two windows of one program are two as well";
  }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(DocumentLockTest, WhatDeadProgramsLeftForOtherDocumentsIsRemoved) {
  const fs::path other = folder_.path() / "other.hcell", living = folder_.path() / "living.hcell";
  OtherProgram dead(other), alive(living);
  dead.kill();
  std::ofstream(folder_.path() / ".package-lock.lock") << "another program's";
  ASSERT_TRUE(fs::exists(lockOf(other)));
  {
    const DocumentLock lock = DocumentLock::take(file());
    EXPECT_TRUE(lock.isHeld());
    EXPECT_FALSE(fs::exists(lockOf(other)));
    EXPECT_TRUE(fs::exists(lockOf(living)));
    EXPECT_TRUE(fs::exists(folder_.path() / ".package-lock.lock"));
  }
  alive.kill();
}

TEST_F(DocumentLockTest, AnotherMachinesLockCountsUntilItIsTakenOver) {
  std::ofstream(lockOf(file())) << R"({"user": "anna\nx", "host": "far", "process": 12, "since": "2026-11-26 09:30"})";
  DocumentLock lock = DocumentLock::take(file());
  ASSERT_TRUE(lock.owner());
  EXPECT_EQ(english(lock.owner()->words()), "anna x on far since 2026-11-26 09:30 (process 12)");
  EXPECT_FALSE(lock.tryAgain());
  lock.takeOver();
  EXPECT_TRUE(lock.isHeld());
  EXPECT_FALSE(lock.owner());
}

TEST_F(DocumentLockTest, NonsenseAndLinksDoNoHarm) {
  std::ofstream(lockOf(file())) << "[1, 2";
  { EXPECT_TRUE(DocumentLock::take(file()).isHeld()); }
  const fs::path precious = folder_.write("precious", "kept");
  fs::create_symlink(precious, lockOf(file()));
  EXPECT_FALSE(DocumentLock::take(file()).isHeld());
  EXPECT_EQ(*readFileContent(precious), "kept");
  fs::remove(lockOf(file()));
  folder_.write("cell.hcell", "{}");
  fs::create_symlink("cell.hcell", folder_.path() / "alias.hcell");
  const DocumentLock lock = DocumentLock::take(folder_.path() / "alias.hcell");
  EXPECT_TRUE(DocumentLock::take(file()).owner()) << "one document under two names";
  EXPECT_FALSE(DocumentLock::take(folder_.path() / "missing/cell.hcell").owner());
}

/// A run that ended without a word, with a copy of the document at `file`.
class LeftCopy : public DocumentLockTest {
 protected:
  LeftCopy() {
    ::setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
    add(document_, "box");
    EXPECT_TRUE(saveDocument(document_, file()));
    saved_ = contentNameOf(file());
    add(document_, "unsaved");
    leave(document_);
  }
  ~LeftCopy() override { ::unsetenv("XDG_STATE_HOME"); }
  static void add(Document& document, const char* name) {
    Diagnostics notes;
    auto part = EntityLoader(fs::current_path()).load("box:1,1,1", 1.0, notes);
    ASSERT_TRUE(part);
    part->name = name;
    ASSERT_TRUE(document.execute(AddEntity{std::move(*part)}));
  }
  void leave(const Document& document) const {
    RunFolder run;
    ASSERT_TRUE(autosave(document.state(), document.path(), *run.path(), saved_));
  }
  Document document_;
  std::string saved_;
};

TEST_F(LeftCopy, IsOfferedWhateverTheClocksSay) {
  using namespace std::chrono_literals;
  const auto now = fs::file_time_type::clock::now();
  for (const auto document_time : {now - 48h, now, now + 48h}) {
    fs::last_write_time(file(), document_time);
    const auto left = findLeftWork();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].document, file());
    EXPECT_FALSE(left[0].document_changed) << "the file is what the copy was made of";
  }
  const CopyFacts facts = copyFactsIn(findLeftWork()[0].run);
  EXPECT_EQ(facts.base, contentNameOf(file()));
  EXPECT_NE(facts.as_saved, facts.base);
}

TEST_F(LeftCopy, IsNotOfferedWhereTheDocumentHoldsTheSame) {
  ASSERT_TRUE(saveDocument(document_, file()));  // The run saved, and died before it could remove the copy.
  using namespace std::chrono_literals;
  fs::last_write_time(file(), fs::file_time_type::clock::now() - 48h);
  EXPECT_TRUE(findLeftWork().empty());
  EXPECT_TRUE(fs::is_empty(runsFolder()));
}

TEST_F(LeftCopy, SaysThatOthersChangedTheDocumentSince) {
  Diagnostics notes;
  auto other = loadDocument(file(), notes);
  ASSERT_TRUE(other);
  add(*other, "of another program");
  ASSERT_TRUE(saveDocument(*other, file()));
  const auto left = findLeftWork();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_TRUE(left[0].document_changed);
  EXPECT_TRUE(changedOnDisk(file(), saved_)) << "and saving must ask";
}

TEST_F(LeftCopy, TheLaterOneComesFirstWhateverTheClocksSay) {
  add(document_, "later");
  leave(document_);
  using namespace std::chrono_literals;
  for (const LeftWork& each : findLeftWork())
    fs::last_write_time(each.copy, fs::file_time_type::clock::now() - each.counter * 24h);
  const auto left = findLeftWork();
  ASSERT_EQ(left.size(), 2u);
  EXPECT_GT(left[0].counter, left[1].counter);
  Diagnostics notes;
  EXPECT_TRUE(loadDocument(left[0].copy, notes)->findByName("later"));
}

TEST_F(LeftCopy, OfAnEarlierProgramIsOfferedToo) {
  const auto run = findLeftWork()[0].run;
  fs::remove(run / "copy.json");
  ASSERT_EQ(findLeftWork().size(), 1u);
  std::ofstream(run / "copy.json") << R"({"document": 5, "base": [], "counter": "x"})";
  EXPECT_EQ(findLeftWork().size(), 1u) << "nonsense";
}

TEST_F(LeftCopy, ATouchedFileIsNotAChangedOne) {
  fs::last_write_time(file(), fs::file_time_type::clock::now() + std::chrono::hours(3));
  EXPECT_FALSE(changedOnDisk(file(), saved_));
  const std::string text = *readFileContent(file());
  ASSERT_TRUE(writeFileAtomically(file(), text + "\n"));
  EXPECT_TRUE(changedOnDisk(file(), saved_));
  EXPECT_FALSE(changedOnDisk(file(), {})) << "nothing is known";
  fs::remove(file());
  EXPECT_FALSE(changedOnDisk(file(), saved_)) << "there is nothing to lose";
}

}  // namespace
}  // namespace hapticell::workcell
