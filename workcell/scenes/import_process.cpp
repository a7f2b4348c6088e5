// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/import_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include "config/program_folders.h"
#include "config/user_folders.h"
#include "geometry/system/packed_text.h"
#include "geometry/system/sanitizers.h"
#include "workcell/text/text_cursor.h"

extern char** environ;

namespace hapticell::workcell {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

constexpr const char* kProgram = "hapticell-importer";

/// A file descriptor that is closed with the object.
class Descriptor {
 public:
  /// Takes `file` to a number that no descriptor of the child's has, so that handing it over overwrites none.
  explicit Descriptor(int file) : file_(file < 0 ? -1 : ::fcntl(file, F_DUPFD_CLOEXEC, 10)) {
    if (file >= 0) ::close(file);
  }
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return file_; }
  void close() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

 private:
  int file_;
};

/// Beside the running program, where an installation puts it, or (for developers) where the environment says.
fs::path findProgram() {
  if (const char* named = std::getenv("HAPTICELL_IMPORTER")) return named[0] == '/' ? fs::path(named) : fs::path();
  for (const fs::path& programs : config::programFolders()) {
    for (const char* place : {".", "../bin", "../libexec/hapticell", "../lib/hapticell"}) {
      const fs::path beside = programs / place / kProgram;
      if (::access(beside.c_str(), X_OK) == 0) return beside;
    }
  }
  return config::systemProgram(kProgram);
}

bool sendAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string readAll(int file) {
  struct stat state {};
  if (::fstat(file, &state) != 0 || state.st_size <= 0) return {};
  std::string content(static_cast<std::size_t>(state.st_size), '\0');
  std::size_t have = 0;
  while (have < content.size()) {
    const ssize_t got = ::pread(file, content.data() + have, content.size() - have, static_cast<off_t>(have));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return {};
    have += static_cast<std::size_t>(got);
  }
  return content;
}

/// The child, killed and reaped with the object at the latest.
class Child {
 public:
  ~Child() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }

  /// 0 or an errno.
  int start(const ImporterCall& call, const std::vector<int>& skipped, int scene, int lines) {
    std::vector<std::string> words{findProgram().string()};
    if (words.front().empty()) return ENOENT;
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    for (const int part : skipped) words.insert(words.end(), {"--skip", std::to_string(part)});
    words.insert(words.end(), {"--memory", std::to_string(call.limits.bytes), "--seconds",
                               std::to_string(static_cast<long>(call.limits.seconds) + 1)});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    // What the foreign readers print is shown only where someone looks for it, and never among the answers of this
    // program.
    if (std::getenv("HAPTICELL_IMPORTER_VERBOSE") == nullptr) {
      posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, scene, kSceneDescriptor);
    posix_spawn_file_actions_adddup2(&actions, lines, kLinesDescriptor);
    posix_spawn_file_actions_addclosefrom_np(&actions, kLinesDescriptor + 1);
    const int fault = ::posix_spawn(&id_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault != 0) id_ = -1;
    return fault;
  }

  /// Seconds of the processor that it has used; 0 where that is not known.
  double processorSeconds() const {
    clockid_t clock{};
    timespec used{};
    if (::clock_getcpuclockid(id_, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0.0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }

  /// The status of waitpid() once it has ended; kills it when it has not by then.
  int wait(Clock::time_point until) {
    int status = 0;
    while (::waitpid(id_, &status, WNOHANG) == 0) {
      if (Clock::now() >= until) ::kill(id_, SIGKILL);
      ::usleep(1000);
    }
    id_ = -1;
    return status;
  }

 private:
  pid_t id_ = -1;
};

/// What the child's lines said.
class Lines {
 public:
  explicit Lines(const ImporterCall& call) : call_(call) {}

  bool done = false;
  std::optional<Error> error;
  std::optional<int> last_part;  ///< That it began.
  Text stage;                    ///< That it told last.

  void add(std::string_view bytes) {
    // Bytes of a line that never ends: guards memory against a broken child. Half, twice: no effect.
    constexpr std::size_t kLongest = 100'000;
    text_.append(bytes);
    std::size_t end = 0;
    while ((end = text_.find('\n')) != std::string::npos) {
      line(std::string_view(text_).substr(0, end));
      text_.erase(0, end + 1);
    }
    if (text_.size() > kLongest) text_.clear();
  }

 private:
  void line(std::string_view line) {
    if (line == "done") {
      done = true;
    } else if (line.starts_with("error ")) {
      error = unpackedError(line.substr(6));
      if (!error) return;  // Not a line of ours: as if it had broken down without a word.
      error->file = call_.file;
    } else if (line.starts_with("part ")) {
      const std::optional<double> number = parseNumber(line.substr(5));
      if (number && *number >= 0.0 && *number < 1e9) last_part = static_cast<int>(*number);
    } else if (line.starts_with("progress ")) {
      line.remove_prefix(9);
      const std::size_t space = line.find(' ');
      const std::optional<double> share = parseNumber(line.substr(0, space));
      if (!share || space == std::string_view::npos) return;
      stage = unpackedText(line.substr(space + 1)).value_or(Text());
      if (call_.monitor) call_.monitor->report(stage, *share);
    }
  }

  const ImporterCall& call_;
  std::string text_;
};

Error inFile(const ImporterCall& call, Text found, Text expected = {}, Text fix = {}) {
  return {.file = call.file, .found = std::move(found), .expected = std::move(expected), .fix = std::move(fix)};
}

Error tookTooLong(const ImporterCall& call, const Lines& lines, double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", seconds);
  Error error = inFile(call, Text("reading took longer than %1 s", text),
                       Text("a file that can be read in the time for its size"),
                       Text("Export it again or in another format, or split it into several files."));
  if (!lines.stage.empty()) error.place = lines.stage;
  return error;
}

/// Reads lines until the child closes its end. An error when it was cancelled or its time is up.
Expected<void> listen(const ImporterCall& call, const Child& child, int lines_end, Lines& lines) {
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(call.limits.seconds));
  while (true) {
    if (call.monitor && call.monitor->isCancelled()) return makeError(inFile(call, Text("the import was cancelled")));
    if (Clock::now() >= end) return makeError(tookTooLong(call, lines, call.limits.seconds));
    if (child.processorSeconds() > call.processor_seconds)
      return makeError(tookTooLong(call, lines, call.processor_seconds));
    pollfd waiting{lines_end, POLLIN, 0};
    // ms: within 0.1 s a cancel is felt as at once (import_process.h promises it). Half: twice the wake-ups; twice: the
    // promise is just missed.
    constexpr int kCancelledWithinMs = 50;
    if (::poll(&waiting, 1, kCancelledWithinMs) <= 0) continue;
    char buffer[4096];
    const ssize_t got = ::read(lines_end, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return {};
    lines.add(std::string_view(buffer, static_cast<std::size_t>(got)));
  }
}

/// It ended without a word: a library crashed, or the system took its memory.
Error brokeDown(const ImporterCall& call, const Lines& lines, int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return tookTooLong(call, lines, 2.0 * call.limits.seconds);
  Error error =
      inFile(call, Text("content that makes the reader crash"), Text("an undamaged file"),
             Text("Export it again or in another format (STEP, glTF, STL), without the part that this message names."));
  error.place = lines.stage.empty() ? Text("at its start") : lines.stage;
  return error;
}

/// One run of the program: what it left, or why there is nothing. `broken`: the part at which it broke down.
Expected<std::string> runImporter(const ImporterCall& call, const std::vector<int>& skipped,
                                  std::optional<int>& broken) {
  const Descriptor scene(::memfd_create("hapticell-scene", MFD_CLOEXEC));
  int ends[2] = {-1, -1};
  const bool piped = ::pipe2(ends, O_CLOEXEC) == 0;
  const Descriptor listening(ends[0]);
  Descriptor speaking(ends[1]);
  if (!piped || scene.get() < 0 || !sendAll(scene.get(), call.scene) || ::lseek(scene.get(), 0, SEEK_SET) != 0) {
    return makeError(inFile(call, Text("no memory for the import: %1", systemText(errno))));
  }
  Child child;
  if (const int fault = child.start(call, skipped, scene.get(), speaking.get()); fault != 0) {
    return makeError(inFile(call, Text("the program %1 could not be started: %2", kProgram, systemText(fault)),
                            Text("this program next to the other programs of HaptiCell"),
                            Text("Install HaptiCell again.")));
  }
  speaking.close();
  Lines lines(call);
  HAPTICELL_TRY(listen(call, child, listening.get(), lines));
  const int status = child.wait(Clock::now() + std::chrono::seconds(2));
  if (lines.error) return makeError(*lines.error);
  if (lines.done) return readAll(scene.get());
  broken = lines.last_part;
  return makeError(brokeDown(call, lines, status));
}

}  // namespace

void limitBySize(ImporterCall& call, std::uintmax_t bytes, bool finer) {
  // s of processor, s a byte (20 s a MB): a broken file of 10 kB kept the importer busy for 16 s
  // (docs/dev/reliability.md). Half: slow sound files are cut; twice: broken ones take longer.
  constexpr double kLeastSeconds = 1.5, kSecondsPerByte = 20e-6;
  // 1.5 GB, and 1024 times the file; by trial. Half: some sound files are refused; twice: a broken one takes memory
  // from the rest.
  constexpr std::uint64_t kLeastBytes = std::uint64_t{3} << 29, kFold = 1024;
  constexpr double kSlower = HAPTICELL_SANITIZED ? 20.0 : 1.0;
  const double by_size = kSlower * (kLeastSeconds + kSecondsPerByte * static_cast<double>(bytes));
  if (!finer) call.processor_seconds = std::min(call.limits.seconds, by_size);
  const std::uint64_t most = call.limits.bytes;
  call.limits.bytes = std::min<std::uint64_t>(most, kLeastBytes + kFold * std::min<std::uint64_t>(most, bytes));
}

Expected<std::string> callImporter(const ImporterCall& call) {
  // Runs, each without one more part that breaks it down. Half: files with four such parts are refused; twice: twice
  // the time for files full of them.
  constexpr std::size_t kMostRuns = 8;
  std::vector<int> skipped;
  while (true) {
    std::optional<int> broken;
    auto result = runImporter(call, skipped, broken);
    const bool again = !result && broken && skipped.size() + 1 < kMostRuns &&
                       std::find(skipped.begin(), skipped.end(), *broken) == skipped.end();
    if (!again) return result;
    skipped.push_back(*broken);
  }
}

}  // namespace hapticell::workcell
