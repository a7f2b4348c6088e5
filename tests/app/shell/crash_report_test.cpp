// SPDX-License-Identifier: Apache-2.0
#include "app/shell/crash_report.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "app/shell/action_trail.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> entriesOf(const ActionTrail& trail) {
  std::vector<std::string> entries;
  trail.forEach([&](const char* text) { entries.emplace_back(text); });
  return entries;
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ActionTrail, KeepsTheLastOnesOldestFirst) {
  ActionTrail trail;
  EXPECT_TRUE(entriesOf(trail).empty());
  trail.add("first");
  ASSERT_EQ(entriesOf(trail).size(), 1u);
  EXPECT_EQ(entriesOf(trail)[0].substr(9), "first") << "after HH:MM:SS and a blank";
  for (int i = 0; i < 1000; ++i) trail.add("action " + std::to_string(i));
  const auto entries = entriesOf(trail);
  ASSERT_EQ(entries.size(), ActionTrail::kKept);
  EXPECT_TRUE(entries.front().ends_with("action 950")) << entries.front();
  EXPECT_TRUE(entries.back().ends_with("action 999")) << entries.back();
}

TEST(ActionTrail, MakesOneShortLineOfEach) {
  ActionTrail trail;
  trail.add("two\nlines\x1b" + std::string(1000, 'x'));
  trail.add("a");
  const auto entries = entriesOf(trail);
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].size(), ActionTrail::kLongest);
  EXPECT_EQ(entries[0].find_first_of("\n\x1b"), std::string::npos);
  EXPECT_EQ(entries[1].substr(9), "a");
}

class CrashReports : public testing::Test {
 protected:
  CrashReports() { ::setenv("XDG_STATE_HOME", state.path().c_str(), 1); }
  ~CrashReports() override { ::unsetenv("XDG_STATE_HOME"); }
  test::TemporaryFolder state;
};

TEST_F(CrashReports, SayWhatBrokeInWhichProgramAfterWhichActions) {
  const auto folder = CrashReport::makeFolder();
  ASSERT_TRUE(folder) << folder.error().message();
  ActionTrail trail;
  trail.add("actionUndo");
  trail.add("message: cell.hcell is saved");
  const CrashReport report(*folder, "hapticell 9.9.9\ncommit: 0123456789ab\ncompiler: GCC\nlibraries: Qt 6.4", trail);
  report.write({"invalid memory access (SIGSEGV)", "some-thread", true});
  const auto reports = CrashReport::reportsIn(*folder);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].filename().string().size(),
            std::string("crash-20261126-135817-").size() + std::to_string(::getpid()).size() + 4);
  const std::string text = contentOf(reports[0]);
  std::size_t at = 0;
  for (const char* part : {"not sent", "time: 2", " UTC", "cause: invalid memory access (SIGSEGV)",
                           "thread: some-thread", "kept", "hapticell 9.9.9", "commit: 0123456789ab", "Qt 6.4",
                           "actionUndo", "message: cell.hcell is saved", "calls, innermost first:", "["}) {
    at = text.find(part, at);
    ASSERT_NE(at, std::string::npos) << part << " is missing or in another place:\n" << text;
  }
  struct stat facts {};
  ASSERT_EQ(::stat(reports[0].c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
}

TEST_F(CrashReports, LeaveAnEarlierReportOfTheSameNameAlone) {
  const auto folder = CrashReport::makeFolder();
  ASSERT_TRUE(folder);
  const ActionTrail trail;
  const CrashReport report(*folder, "program", trail);
  for (int i = 0; i < 3; ++i) report.write({"cause", "thread", false});
  for (const fs::path& file : CrashReport::reportsIn(*folder)) {
    const std::string text = contentOf(file);
    EXPECT_EQ(text.find("time: "), text.rfind("time: ")) << text;
  }
}

TEST_F(CrashReports, AreTenAtMostWithTheNextOne) {
  const auto folder = CrashReport::makeFolder();
  ASSERT_TRUE(folder);
  for (int i = 10; i < 25; ++i) std::ofstream(*folder / ("crash-202611" + std::to_string(i) + "-000000-1.txt")) << "x";
  std::ofstream(*folder / "notes.md") << "of the user";
  ASSERT_TRUE(CrashReport::makeFolder());
  const auto left = CrashReport::reportsIn(*folder);
  ASSERT_EQ(left.size(), CrashReport::kKept - 1);
  EXPECT_EQ(left.front().filename(), "crash-20261116-000000-1.txt");
  EXPECT_EQ(left.back().filename(), "crash-20261124-000000-1.txt");
  EXPECT_TRUE(fs::exists(*folder / "notes.md"));
}

}  // namespace
}  // namespace hapticell::app
