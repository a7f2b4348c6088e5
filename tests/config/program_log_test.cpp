// SPDX-License-Identifier: Apache-2.0
#include "config/program_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "config/log_level.h"
#include "tests/support/test_data.h"

namespace hapticell::config {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class ProgramLogs : public testing::Test {
 protected:
  ProgramLogs() { ::setenv("XDG_STATE_HOME", state.path().c_str(), 1); }
  ~ProgramLogs() override { ::unsetenv("XDG_STATE_HOME"); }
  fs::path logs() const { return state.path() / "hapticell/logs"; }
  static std::unique_ptr<ProgramLog> open(LogLevel level = LogLevel::kInfo, LogLimits limits = {}) {
    auto log = ProgramLog::open("tested", level, limits);
    EXPECT_TRUE(log) << log.error().message();
    return std::move(*log);
  }
  test::TemporaryFolder state;
};

TEST(LogLevels, AreKnownByTheirWords) {
  EXPECT_EQ(logLevelFrom("error"), LogLevel::kError);
  EXPECT_EQ(logLevelFrom("warning"), LogLevel::kWarning);
  EXPECT_EQ(logLevelFrom("info"), LogLevel::kInfo);
  EXPECT_EQ(logLevelFrom("debug"), LogLevel::kDebug);
  for (const char* word : {"", "Info", "trace", "3"}) {
    const auto level = logLevelFrom(word);
    ASSERT_FALSE(level) << word;
    EXPECT_THAT(level.error().message(), HasSubstr("--log-level"));
  }
}

TEST_F(ProgramLogs, HoldTheirLevelAndThoseBeforeIt) {
  const std::vector<LogLevel> levels{LogLevel::kError, LogLevel::kWarning, LogLevel::kInfo, LogLevel::kDebug};
  for (std::size_t level = 0; level < levels.size(); ++level) {
    fs::remove_all(logs());
    const auto log = open(levels[level]);
    for (std::size_t i = 0; i < levels.size(); ++i) log->write(levels[i], "sentence " + std::to_string(i));
    const std::string text = contentOf(logs() / "tested.log");
    for (std::size_t i = 0; i < levels.size(); ++i)
      EXPECT_EQ(text.find("sentence " + std::to_string(i)) != std::string::npos, i <= level) << text;
  }
}

TEST_F(ProgramLogs, WriteOneLineWithTimeAndLevel) {
  open()->write(LogLevel::kWarning, "first\nsecond\x1b[31m");
  const std::string text = contentOf(logs() / "tested.log");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_THAT(text, testing::MatchesRegex("20..-..-.. ..:..:...... [+-]..:.. warning: first second.*\n"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST_F(ProgramLogs, AreAddedToByTheNextRun) {
  open()->write(LogLevel::kInfo, "one run");
  open()->write(LogLevel::kInfo, "the next");
  EXPECT_THAT(contentOf(logs() / "tested.log"), testing::AllOf(HasSubstr("one run"), HasSubstr("the next")));
}

TEST_F(ProgramLogs, KeepToTheirSize) {
  const LogLimits limits{.bytes = 4000, .files = 3};
  const auto log = open(LogLevel::kInfo, limits);
  for (int i = 0; i < 500; ++i) log->write(LogLevel::kInfo, "line number " + std::to_string(i));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(logs())) {
    if (entry.path().extension() != ".log") continue;
    ++files;
    EXPECT_LE(entry.file_size(), limits.bytes) << entry.path();
  }
  EXPECT_EQ(files, limits.files);
  EXPECT_THAT(contentOf(logs() / "tested.log"), HasSubstr("line number 499"));
  EXPECT_THAT(contentOf(logs() / "tested.2.log"), Not(HasSubstr("line number 499")));
}

TEST_F(ProgramLogs, OfTwoAtOnceAreTwoFiles) {
  const auto first = open();
  const auto second = open();
  EXPECT_EQ(first->file(), logs() / "tested.log");
  EXPECT_EQ(second->file(), logs() / "tested-2.log");
  first->write(LogLevel::kInfo, "of the first");
  second->write(LogLevel::kInfo, "of the second");
  EXPECT_THAT(contentOf(first->file()), Not(HasSubstr("of the second")));
  EXPECT_THAT(contentOf(second->file()), HasSubstr("of the second"));
}

TEST_F(ProgramLogs, AreForThisUserOnly) {
  const auto log = open();
  struct stat facts {};
  ASSERT_EQ(::stat(log->file().c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
  ASSERT_EQ(::stat(logs().c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0700u);
}

TEST_F(ProgramLogs, AreLeftOutWhereTheirFolderCannotBeMade) {
  state.write("hapticell", "no folder");
  const auto log = ProgramLog::open("tested", LogLevel::kInfo);
  ASSERT_FALSE(log);
  EXPECT_THAT(log.error().message(), HasSubstr("hapticell"));
}

}  // namespace
}  // namespace hapticell::config
