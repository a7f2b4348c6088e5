// SPDX-License-Identifier: Apache-2.0
#include "workcell/xacro.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>

extern char** environ;

namespace hapticell::workcell {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPatience = std::chrono::seconds(60);
constexpr std::size_t kLongest = 64u << 20;

bool isInPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string rest = path ? path : "";
  while (!rest.empty()) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const std::string candidate = rest.substr(0, colon) + "/" + program;
    if (access(candidate.c_str(), X_OK) == 0) return true;
    rest.erase(0, colon + 1);
  }
  return false;
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  bool open() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
  void closeEnd(std::size_t k) {
    if (ends[k] >= 0) close(ends[k]);
    ends[k] = -1;
  }
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
};

struct Result {
  std::string output, complaints;
  int status = -1;
  bool in_time = true;
};

/// Reads both pipes until the program closes them; false when it takes too long or says too much.
bool drain(Pipe& output, Pipe& complaints, Result& result) {
  const auto deadline = Clock::now() + kPatience;
  std::array<pollfd, 2> waits{{{output.ends[0], POLLIN, 0}, {complaints.ends[0], POLLIN, 0}}};
  std::array<std::string*, 2> texts{&result.output, &result.complaints};
  for (int open = 2; open > 0;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0 || poll(waits.data(), waits.size(), static_cast<int>(left)) <= 0) return false;
    for (std::size_t k = 0; k < waits.size(); ++k) {
      if (waits[k].fd < 0 || waits[k].revents == 0) continue;
      std::array<char, 65536> buffer;
      const ssize_t count = read(waits[k].fd, buffer.data(), buffer.size());
      if (count <= 0) {
        waits[k].fd = -1;
        --open;
        continue;
      }
      texts[k]->append(buffer.data(), static_cast<std::size_t>(count));
      if (texts[k]->size() > kLongest) return false;
    }
  }
  return true;
}

bool run(const std::string& file, Result& result) {
  Pipe output, complaints;
  if (!output.open() || !complaints.open()) return false;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, complaints.ends[1], STDERR_FILENO);
  std::string program = "xacro", argument = file;
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "xacro", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return false;
  output.closeEnd(1);
  complaints.closeEnd(1);
  result.in_time = drain(output, complaints, result);
  if (!result.in_time) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return true;
}

std::string lastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return "no reason given";
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, std::min<std::size_t>(300, end - begin));
}

}  // namespace

Expected<std::string> expandXacro(const std::filesystem::path& file) {
  if (!isInPath("xacro")) {
    return makeError(
        {file.string(), "", "a xacro file, and the program xacro is not on this computer", "plain URDF",
         "Install xacro (it comes with ROS, or by pip), or expand the file elsewhere: xacro FILE > robot.urdf."});
  }
  Result result;
  if (!run(std::filesystem::absolute(file).string(), result))
    return makeError({file.string(), "", "the program xacro could not be started", "", ""});
  if (!result.in_time)
    return makeError({file.string(), "", "the program xacro did not end within 60 s", "a result", ""});
  if (result.status != 0 || result.output.empty()) {
    return makeError({file.string(), "", "xacro cannot expand it (" + lastLine(result.complaints) + ")", "valid xacro",
                      "Where a package is not found, name its folder in ROS_PACKAGE_PATH."});
  }
  return std::move(result.output);
}

}  // namespace hapticell::workcell
