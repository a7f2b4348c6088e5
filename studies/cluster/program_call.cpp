// SPDX-License-Identifier: Apache-2.0
#include "studies/cluster/program_call.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>

#include "config/user_folders.h"

extern char** environ;

namespace hapticell::studies {

namespace {

std::string readToEnd(int pipe) {
  std::string text;
  std::array<char, 4096> piece{};
  while (true) {
    const ssize_t count = ::read(pipe, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Expected<ProgramAnswer> callProgram(const std::string& name, const std::vector<std::string>& arguments) {
  const std::filesystem::path program = config::systemProgram(name);
  if (program.empty())
    return makeError({.found = Text("the program %1 is not installed", name),
                      .expected = "Slurm's commands in PATH",
                      .fix = "Install Slurm (Debian: slurm-client), or run the chunks by GNU Parallel."});
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return makeError({.file = name, .found = systemText(errno)});
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int fault = posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  ProgramAnswer answer;
  if (fault == 0) answer.output = readToEnd(ends[0]);
  close(ends[0]);
  if (fault != 0) return makeError({.file = program.string(), .found = systemText(fault)});
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return answer;
}

}  // namespace hapticell::studies
