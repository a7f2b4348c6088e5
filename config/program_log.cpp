// SPDX-License-Identifier: Apache-2.0
#include "config/program_log.h"

#include <fcntl.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "config/user_folders.h"
#include "geometry/system/plain_text.h"

namespace hapticell::config {

namespace fs = std::filesystem;

namespace {

/// Bytes of a line: a page of a sentence. Half: some paths are cut; twice: a driver can write twice as much.
constexpr std::size_t kLongestLine = 2000;
/// Processes of one program that log at the same time. Half: tests side by side have no log; twice: so many more files.
constexpr int kMostAtOnce = 9;

/// Held while the process lives; -1: none.
class Lock {
 public:
  Lock() = default;
  Lock(Lock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Lock& operator=(Lock&&) = delete;
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  /// 0, or the error number; EWOULDBLOCK: another process has it.
  int take(const fs::path& path) {
    file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file_ < 0) return errno;
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return 0;
    const int problem = errno;
    ::close(std::exchange(file_, -1));
    return problem;
  }

 private:
  int file_ = -1;
};

spdlog::level::level_enum levelOf(LogLevel level) {
  switch (level) {
    case LogLevel::kError:
      return spdlog::level::err;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kDebug:
      return spdlog::level::debug;
  }
  return spdlog::level::info;
}

std::shared_ptr<spdlog::sinks::sink> fileSink(const fs::path& file, const LogLimits& limits) {
  spdlog::file_event_handlers events;
  // For this user only, and not for the programs that this one starts.
  events.after_open = [](const spdlog::filename_t&, std::FILE* opened) {
    ::fchmod(::fileno(opened), 0600);
    ::fcntl(::fileno(opened), F_SETFD, FD_CLOEXEC);
  };
  auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file.string(), limits.bytes, limits.files - 1,
                                                                     false, events);
  sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %z %l: %v");
  return sink;
}

tl::unexpected<Error> noLog(const fs::path& path, Text found) {
  return makeError({.file = path.string(),
                    .found = std::move(found),
                    .expected = "a log file that can be written",
                    .fix = "The program runs on without a log file."});
}

}  // namespace

struct ProgramLog::Parts {
  Lock lock;  ///< Let go after the file is closed.
  fs::path file;
  std::shared_ptr<spdlog::sinks::sink> sink;
  std::unique_ptr<spdlog::logger> logger;
  std::atomic<bool> failure_told{false};
};

ProgramLog::ProgramLog(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ProgramLog::~ProgramLog() = default;

Expected<std::unique_ptr<ProgramLog>> ProgramLog::open(const std::string& program, LogLevel level, LogLimits limits) {
  const auto state = userStateFolder();
  HAPTICELL_TRY(state);
  const fs::path folder = *state / "logs";
  HAPTICELL_TRY(makeOwnFolder(folder));
  auto parts = std::make_unique<Parts>();
  for (int number = 1; parts->file.empty(); ++number) {
    if (number > kMostAtOnce) return noLog(folder, Text("%1 processes have a log there", kMostAtOnce));
    const std::string name = number == 1 ? program : program + "-" + std::to_string(number);
    const int problem = parts->lock.take(folder / (name + ".lock"));
    if (problem == 0) parts->file = folder / (name + ".log");
    if (problem != 0 && problem != EWOULDBLOCK) return noLog(folder / (name + ".lock"), systemText(problem));
  }
  try {
    parts->sink = fileSink(parts->file, limits);
  } catch (const spdlog::spdlog_ex& failure) {
    return noLog(parts->file, plainText(failure.what()));
  }
  parts->logger = std::make_unique<spdlog::logger>(program, parts->sink);
  parts->logger->set_level(levelOf(level));
  parts->logger->flush_on(spdlog::level::trace);
  parts->logger->set_error_handler([parts = parts.get()](const std::string& problem) {
    if (!parts->failure_told.exchange(true))
      std::fprintf(stderr, "%s: %s\n", parts->file.c_str(), plainText(problem).c_str());
  });
  return std::unique_ptr<ProgramLog>(new ProgramLog(std::move(parts)));
}

void ProgramLog::write(LogLevel level, std::string_view sentence) {
  parts_->logger->log(levelOf(level), "{}", plainText(sentence, kLongestLine));
}

const fs::path& ProgramLog::file() const {
  return parts_->file;
}

std::shared_ptr<spdlog::sinks::sink> ProgramLog::sink() const {
  return parts_->sink;
}

}  // namespace hapticell::config
