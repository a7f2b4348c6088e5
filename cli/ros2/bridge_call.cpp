// SPDX-License-Identifier: Apache-2.0
#include "cli/ros2/bridge_call.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "cli/device/program_answer.h"

extern char** environ;

namespace hapticell::cli {

namespace {

std::string readBridge(int pipe) {
  std::string text;
  std::array<char, 4096> piece{};
  while (true) {
    const ssize_t count = ::read(pipe, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

/// 0 or an errno.
int startBridge(const std::string& program, const std::string& job, int output, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGINT);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  std::string name = program, argument = job;
  char* words[] = {name.data(), argument.data(), nullptr};
  const int fault = posix_spawn(&child, program.c_str(), &actions, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return fault;
}

}  // namespace

Expected<BridgeAnswer> callBridge(const std::string& job) {
  const std::string program = siblingProgram("hapticell-ros2").string();
  if (program.empty())
    return makeError({.found = "the program hapticell-ros2 is not installed",
                      .expected = "it beside hapticell-cli",
                      .fix = "Install HaptiCell with its link to ROS 2 (Debian: cyclonedds-dev, when building)."});
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return makeError({.file = program, .found = systemText(errno)});
  const auto before = std::signal(SIGINT, SIG_IGN);
  pid_t child = 0;
  const int fault = startBridge(program, job, ends[1], child);
  close(ends[1]);
  BridgeAnswer answer;
  if (fault == 0) answer.output = readBridge(ends[0]);
  close(ends[0]);
  int status = 0;
  while (fault == 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  std::signal(SIGINT, before);
  if (fault != 0) return makeError({.file = program, .found = systemText(fault)});
  if (!WIFEXITED(status)) {
    return makeError({.file = program,
                      .found = Text("it ended by signal %1", WTERMSIG(status) + 0),
                      .expected = "a result",
                      .fix = "This is a bug. Please report it."});
  }
  answer.status = WEXITSTATUS(status);
  return answer;
}

}  // namespace hapticell::cli
