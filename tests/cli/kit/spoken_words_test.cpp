// SPDX-License-Identifier: Apache-2.0
// What a command says: results, sentences, progress; and how it is asked to stop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "cli/kit/progress_line.h"
#include "cli/kit/result_writer.h"
#include "cli/kit/stop_signal.h"
#include "tests/cli/kit/kept_words.h"
#include "tests/support/test_data.h"

namespace hapticell::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using test::KeptWords;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

std::string writtenIn(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ResultWriter, WritesAFileWholeOrNotAtAll) {
  const hapticell::test::TemporaryFolder folder;
  const ResultWriter writer((folder.path() / "result.json").string());
  EXPECT_TRUE(writer.isAsked());
  ::testing::internal::CaptureStdout();
  ASSERT_TRUE(writer.write({{"a", 1}, {"name", "caf\xe9"}}));
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(writtenIn(folder.path() / "result.json"), "{\n  \"a\": 1,\n  \"name\": \"caf\xef\xbf\xbd\"\n}\n")
      << "what is not UTF-8 is replaced";
  ASSERT_TRUE(writer.writeLine({{"a", 2}}));
  EXPECT_EQ(writtenIn(folder.path() / "result.json"), "{\"a\":2}\n") << "the newest";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing is left beside it";
  const auto failed = ResultWriter((folder.path() / "none/result.json").string()).write({});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message(), HasSubstr("result.json"));
}

TEST(ResultWriter, PrintsOrTellsTheListener) {
  for (const char* place : {"", "-"}) {
    const ResultWriter writer(place);
    EXPECT_EQ(writer.isAsked(), *place == '-');
    ::testing::internal::CaptureStdout();
    ASSERT_TRUE(writer.writeLine({{"a", 1}}));
    ASSERT_TRUE(printText("plain\n"));
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "{\"a\":1}\nplain\n");
    KeptWords kept;
    const ListenerOfThread listening(kept);
    ::testing::internal::CaptureStdout();
    ASSERT_TRUE(writer.write({{"a", 2}}));
    ASSERT_TRUE(printText("plain\n"));
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_THAT(kept.results, ElementsAre(ordered_json{{"a", 2}}));
    EXPECT_EQ(kept.texts, "plain\n");
  }
}

TEST(ResultWriter, SentencesGoToStandardErrorWithoutForeignControl) {
  ::testing::internal::CaptureStderr();
  warn(Text("no part '%1'", "a\x1b[2J\nb"));
  report({.file = "x\x1b]0;.stl", .found = "nothing"});
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, StartsWith("hapticell-cli: no part 'a"));
  EXPECT_THAT(said, HasSubstr("\nhapticell-cli: x"));
  EXPECT_THAT(said, Not(HasSubstr("\x1b")));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 2) << said;
  KeptWords kept;
  const ListenerOfThread listening(kept);
  ::testing::internal::CaptureStderr();
  warn(Text("careful"));
  report({.found = "wrong"});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(kept.warnings, ElementsAre(Text("careful")));
  ASSERT_THAT(kept.errors, SizeIs(1));
  EXPECT_EQ(kept.errors[0].message(), "wrong");
}

TEST(ResultWriter, NumbersThatJsonDoesNotHaveAreNull) {
  EXPECT_EQ(finiteOrNull(0.25), 0.25);
  EXPECT_TRUE(finiteOrNull(std::numeric_limits<double>::infinity()).is_null());
  EXPECT_TRUE(finiteOrNull(std::nan("")).is_null());
  EXPECT_EQ(toJson(dvec3(1.0, -2.0, 0.5)), ordered_json({1.0, -2.0, 0.5}));
  EXPECT_EQ(ordered_json(Text("%1 of %2", 2, 3)), "2 of 3");
  EXPECT_EQ(shortNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(shortNumber(1234567.0), "1.23457e+06");
  EXPECT_EQ(shortNumber(-180.0), "-180");
}

/// Standard error as a pipe, for what other threads write there.
class ReadStandardError {
 public:
  ReadStandardError() : before_(::dup(STDERR_FILENO)) {
    EXPECT_EQ(::pipe(ends_), 0);
    ::dup2(ends_[1], STDERR_FILENO);
  }
  ~ReadStandardError() { restore(); }
  ReadStandardError(const ReadStandardError&) = delete;
  ReadStandardError& operator=(const ReadStandardError&) = delete;
  /// Waits for the next line.
  std::string line() {
    std::string text;
    for (char c = 0; ::read(ends_[0], &c, 1) == 1 && c != '\n';) text += c;
    return text;
  }
  /// What is left, once nobody writes any more.
  std::string rest() {
    restore();
    std::string text;
    for (char c = 0; ::read(ends_[0], &c, 1) == 1;) text += c;
    return text;
  }

 private:
  void restore() {
    if (before_ < 0) return;
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
    ::close(ends_[1]);
    before_ = -1;
  }
  int before_;
  int ends_[2]{};
};

TEST(ProgressLine, WritesALineATenthWhereNoTerminalIs) {
  ReadStandardError read;
  {
    ProgressLine progress;
    progress.monitor().report(Text("reading %1", "a\x1b[2J.step"), 0.35);
    const std::string first = read.line();
    EXPECT_THAT(first, StartsWith(" 35 %  reading a"));
    EXPECT_THAT(first, Not(HasSubstr("\x1b")));
    progress.monitor().report(Text("reading"), 0.38);
    progress.monitor().report(Text("checking"), 1.0);
    EXPECT_EQ(read.line(), "100 %  checking") << "nothing for the same tenth";
  }
  EXPECT_EQ(read.rest(), "");
}

/// Hears progress from the thread of the line.
class HeardProgress final : public CommandListener {
 public:
  void hearResult(const nlohmann::ordered_json&) override {}
  void hearText(const std::string&) override {}
  void hearError(const Error&) override {}
  void hearWarning(const Text&) override {}
  void hearProgress(double share, const std::string& stage) override {
    if (stage == "meshing") heard_share = share;
  }
  std::atomic<double> heard_share{-1.0};
};

TEST(ProgressLine, AListenerHearsItAndCancelsTheWork) {
  HeardProgress listener;
  const ListenerOfThread listening(listener);
  ProgressLine progress;
  progress.monitor().report(Text("meshing"), 0.5);
  while (listener.heard_share < 0.0) std::this_thread::yield();
  EXPECT_EQ(listener.heard_share, 0.5);
  EXPECT_FALSE(progress.monitor().isCancelled());
  listener.askToStop();
  while (!progress.monitor().isCancelled()) std::this_thread::yield();
}

TEST(StopSignal, TheFirstOneOnlySetsAFlag) {
  {
    const StopSignal stop;
    EXPECT_FALSE(stop.asked());
    std::raise(SIGINT);
    EXPECT_TRUE(stop.asked());
    EXPECT_EQ(std::signal(SIGINT, SIG_IGN), SIG_DFL) << "a second one ends the program";
    std::raise(SIGTERM);
    EXPECT_TRUE(stop.asked());
  }
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
  const StopSignal again;
  EXPECT_FALSE(again.asked()) << "of this one";
}

TEST(StopSignal, WithAListenerSignalsStayAsTheyAre) {
  KeptWords kept;
  const ListenerOfThread listening(kept);
  std::signal(SIGINT, SIG_IGN);
  {
    const StopSignal stop;
    EXPECT_EQ(std::signal(SIGINT, SIG_IGN), SIG_IGN);
    EXPECT_FALSE(stop.asked());
    kept.askToStop();
    EXPECT_TRUE(stop.asked());
  }
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN);
}

}  // namespace
}  // namespace hapticell::cli
