// SPDX-License-Identifier: Apache-2.0
#include "app/shell/crash_report.h"

#ifdef __linux__
#include <execinfo.h>
#endif
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <string_view>
#include <utility>

#include "config/user_folders.h"

namespace hapticell::app {

namespace fs = std::filesystem;

namespace {

/// Text in memory of its own, as printf() may not be called in a signal handler. What does not fit is left out.
class FixedText {
 public:
  FixedText& add(std::string_view text) {
    const std::size_t bytes = std::min(text.size(), text_.size() - 1 - size_);
    std::copy_n(text.begin(), bytes, text_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += bytes;
    return *this;
  }
  /// With zeros before it up to so many digits.
  FixedText& add(std::uint64_t number, std::size_t digits = 1) {
    std::array<char, 20> backwards;
    std::size_t count = 0;
    for (; number != 0 || count < digits; number /= 10) backwards[count++] = static_cast<char>('0' + number % 10);
    while (count > 0) add(std::string_view(&backwards[--count], 1));
    return *this;
  }
  const char* data() const { return text_.data(); }
  std::string_view view() const { return {text_.data(), size_}; }

 private:
  std::array<char, 4096> text_{};
  std::size_t size_ = 0;
};

/// The present time in UTC by arithmetic only: gmtime_r() may lock.
struct Now {
  unsigned year, month, day, hour, minute, second;

  static Now get() {
    using namespace std::chrono;
    const sys_seconds now{seconds(std::time(nullptr))};
    const auto midnight = floor<days>(now);
    const year_month_day date(midnight);
    const hh_mm_ss time(now - midnight);
    return {static_cast<unsigned>(static_cast<int>(date.year())),
            static_cast<unsigned>(date.month()),
            static_cast<unsigned>(date.day()),
            static_cast<unsigned>(time.hours().count()),
            static_cast<unsigned>(time.minutes().count()),
            static_cast<unsigned>(time.seconds().count())};
  }
};

void writeTo(int file, std::string_view text) {
  [[maybe_unused]] const auto written = ::write(file, text.data(), text.size());
}

void writeCalls(int file) {
#ifdef __linux__
  std::array<void*, 64> calls;
  ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())), file);
#endif
}

}  // namespace

Expected<fs::path> CrashReport::makeFolder() {
  const auto state = config::userStateFolder();
  HAPTICELL_TRY(state);
  const fs::path folder = *state / "crashes";
  HAPTICELL_TRY(config::makeOwnFolder(folder));
  std::vector<fs::path> reports = reportsIn(folder);
  std::error_code ignored;
  for (std::size_t i = 0; i + kKept <= reports.size(); ++i) fs::remove(reports[i], ignored);
  return folder;
}

std::vector<fs::path> CrashReport::reportsIn(const fs::path& folder) {
  std::vector<fs::path> reports;
  std::error_code fault, gone;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with("crash-") && name.ends_with(".txt") &&
        at->symlink_status(gone).type() == fs::file_type::regular)
      reports.push_back(at->path());
  }
  std::sort(reports.begin(), reports.end());
  return reports;
}

CrashReport::CrashReport(const fs::path& folder, std::string program, const ActionTrail& actions)
    : beginning_((folder / "crash-").string()), program_(std::move(program)), actions_(&actions) {}

void CrashReport::write(const Crash& crash) const {
  const Now now = Now::get();
  FixedText path;
  path.add(beginning_).add(now.year, 4).add(now.month, 2).add(now.day, 2).add("-");
  path.add(now.hour, 2).add(now.minute, 2).add(now.second, 2).add("-");
  path.add(static_cast<std::uint64_t>(::getpid())).add(".txt");
  const int file = ::open(path.data(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (file < 0) return;
  FixedText head;
  head.add("Crash report of HaptiCell. It was not sent to anyone.\n\ntime: ");
  head.add(now.year, 4).add("-").add(now.month, 2).add("-").add(now.day, 2).add(" ");
  head.add(now.hour, 2).add(":").add(now.minute, 2).add(":").add(now.second, 2).add(" UTC\ncause: ").add(crash.cause);
  head.add("\nthread: ").add(crash.thread).add("\nunsaved work: ");
  head.add(crash.kept ? "kept in the recovery copy\n" : "could not be kept\n");
  writeTo(file, head.view());
  writeTo(file, program_);
  writeTo(file, "\n\nlast actions and messages (UTC), oldest first:\n");
  actions_->forEach([file](const char* text) {
    writeTo(file, text);
    writeTo(file, "\n");
  });
  writeTo(file, "\ncalls, innermost first:\n");
  writeCalls(file);
  ::close(file);
}

}  // namespace hapticell::app
