// SPDX-License-Identifier: Apache-2.0
// Programs that are killed (SIGKILL) at any moment of saving, autosaving, exporting and packing: what stands there is
// the old content or the new, never a part, and the next start leaves nothing astray. 60 kills; HAPTICELL_KILLS=200 for
// more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <random>
#include <set>

#include "geometry/system/atomic_file.h"
#include "tests/support/test_data.h"
#include "workcell/files/autosave.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"
#include "workcell/text/file_content.h"
#include "workcell/files/pack.h"
#include "workcell/files/scene_export.h"

namespace hapticell::workcell {
namespace {

namespace fs = std::filesystem;

int kills() {
  const char* wanted = std::getenv("HAPTICELL_KILLS");
  return wanted ? std::atoi(wanted) : 60;
}

class KilledWriter : public ::testing::Test {
 protected:
  KilledWriter() {
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    EntityLoader loader(folder_.path());
    Diagnostics notes;
    ImportOptions options;
    for (int i = 0; i < 12; ++i) {
      const fs::path file =
          folder_.write("parts/p" + std::to_string(i) + ".obj", mesh + std::string(20'000, '#') + "\n");
      auto part = loader.load(file.string(), 1.0, notes);
      EXPECT_TRUE(part);
      part->name = "part" + std::to_string(i);
      EXPECT_TRUE(document_.execute(AddEntity{std::move(*part)}));
    }
    other_ = document_;
    EXPECT_TRUE(other_.execute(RenameEntity{other_.state().entities[0]->id, "renamed"}));
    fs::create_directory(work());
  }

  fs::path work() const { return folder_.path() / "work"; }

  /// A process that does `work` without end; killed within `most_us`.
  static void runAndKill(const std::function<void()>& work, int after_us) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (;;) work();
    }
    ::usleep(static_cast<useconds_t>(after_us));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;
  }

  /// In a process of its own, as the next start is.
  static bool runOnce(const std::function<bool()>& work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work() ? 0 : 1);
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  /// Kills `write`, which is told which of the two documents to write; each file that `names` then lists in the working
  /// folder has the content that an undisturbed writer gives it, or is not there.
  void killWriters(const std::vector<std::string>& names, const std::function<bool(const DocumentState&)>& write,
                   int longest_us) {
    std::map<std::string, std::set<std::string>> whole;
    for (const Document* each : {&document_, &other_}) {
      ASSERT_TRUE(write(each->state()));
      for (const std::string& name : names) whole[name].insert(*readFileContent(work() / name));
    }
    std::mt19937 random(7);
    std::uniform_int_distribution<int> pause(0, longest_us);
    std::size_t left = 0;
    for (int i = 0; i < kills() / 4; ++i) {
      runAndKill(
          [&] {
            (void)write(document_.state());
            (void)write(other_.state());
          },
          pause(random));
      for (const std::string& name : names) {
        const auto content = readFileContent(work() / name);
        ASSERT_TRUE(content) << name << " is gone";
        EXPECT_TRUE(whole[name].contains(*content)) << name << " is a part, after kill " << i;
      }
      left += listed().size() - names.size();
    }
    ASSERT_TRUE(runOnce([&] { return write(document_.state()); }));
    EXPECT_EQ(listed(), std::set<std::string>(names.begin(), names.end())) << "the next start tidies";
    RecordProperty("left_by_kills", static_cast<int>(left));
  }

  std::set<std::string> listed() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(work())) names.insert(entry.path().filename().string());
    return names;
  }

  test::TemporaryFolder folder_;
  Document document_, other_;
};

TEST_F(KilledWriter, SavingLeavesTheOldDocumentOrTheNew) {
  killWriters(
      {"cell.hcell"},
      [&](const DocumentState& state) {
        Document copy(state);
        return saveDocument(copy, work() / "cell.hcell").has_value();
      },
      8000);
}

TEST_F(KilledWriter, ExportingLeavesTheOldFilesOrTheNew) {
  killWriters(
      {"cell.glb", "cell.mtl", "cell.obj"},
      [&](const DocumentState& state) {
        Diagnostics notes;
        return exportState(state, work() / "cell.glb", {}, notes).has_value() &&
               exportState(state, work() / "cell.obj", {}, notes).has_value();
      },
      12000);
}

TEST_F(KilledWriter, PackingLeavesTheOldArchiveOrTheNew) {
  killWriters(
      {"cell.zip"},
      [&](const DocumentState& state) {
        Diagnostics notes;
        return pack(state, work() / "cell.zip", "cell.hcell", {{}, true}, notes).has_value();
      },
      60000);
}

TEST_F(KilledWriter, PackingIntoAFolderLeavesNoneOrAWholeOne) {
  const fs::path place = work() / "cell";
  const auto write = [&] {
    Diagnostics notes;
    return pack(document_.state(), place, "cell.hcell", {{}, true}, notes).has_value();
  };
  std::mt19937 random(7);
  std::uniform_int_distribution<int> pause(0, 40000);
  for (int i = 0; i < kills() / 8; ++i) {
    runAndKill([&] { write() ? void(::pause()) : ::_exit(1); }, pause(random));
    if (fs::exists(place)) {
      Diagnostics notes;
      const auto again = loadDocument(place / "cell.hcell", notes);
      ASSERT_TRUE(again) << again.error().message();
      EXPECT_EQ(again->state().entities.size(), document_.state().entities.size());
      fs::remove_all(place);
    }
  }
  ASSERT_TRUE(runOnce(write));
  EXPECT_EQ(listed(), std::set<std::string>{"cell"});
}

TEST_F(KilledWriter, TwoPacksAtOnceGiveOneWholeArchive) {
  const fs::path place = work() / "cell.zip";
  const auto write = [&](const Document& document) {
    Diagnostics notes;
    return pack(document.state(), place, "cell.hcell", {{}, true}, notes).has_value();
  };
  std::set<std::string> whole;
  for (const Document* each : {&document_, &other_}) {
    ASSERT_TRUE(write(*each));
    whole.insert(*readFileContent(place));
  }
  ASSERT_EQ(whole.size(), 2u);
  for (int i = 0; i < 5; ++i) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(write(document_) ? 0 : 1);
    EXPECT_TRUE(write(other_));
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_TRUE(whole.contains(*readFileContent(place)));
  }
  EXPECT_EQ(listed(), std::set<std::string>{"cell.zip"});
}

TEST_F(KilledWriter, AutosavingLeavesTheOldCopyOrTheNew) {
  ::setenv("XDG_STATE_HOME", (work() / "state").c_str(), 1);
  const std::set<std::string> names{"part0", "renamed"};
  std::mt19937 random(7);
  std::uniform_int_distribution<int> pause(0, 30000);
  for (int i = 0; i < kills() / 4; ++i) {
    // Every second one is killed while it makes its folder, the others once they have a copy.
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      RunFolder run;
      const auto place = run.path();
      for (char told = 0;; told = 1) {
        if (!place || !autosave(document_.state(), {}, *place) || !autosave(other_.state(), {}, *place)) ::_exit(1);
        if (told == 0) (void)!::write(ends[1], "!", 1);
      }
    }
    ::close(ends[1]);
    char told = 0;
    if (i % 2 == 1) {
      EXPECT_EQ(::read(ends[0], &told, 1), 1);
    }
    ::usleep(static_cast<useconds_t>(pause(random)));
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    ::close(ends[0]);
  }
  const auto left = findLeftWork();
  EXPECT_GE(static_cast<int>(left.size()), kills() / 8);
  for (const LeftWork& each : left) {
    Diagnostics notes;
    const auto again = loadDocument(each.copy, notes);
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->state().entities.size(), document_.state().entities.size());
    EXPECT_TRUE(names.contains(again->state().entities[0]->name));
    discardLeftWork(each.run);
  }
  EXPECT_TRUE(fs::is_empty(runsFolder())) << "nothing of runs that are over";
  ::unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace hapticell::workcell
