// SPDX-License-Identifier: Apache-2.0
#include "cli/device/program_answer.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

#include "config/program_folders.h"
#include "config/user_folders.h"

extern char** environ;

namespace hapticell::cli {

namespace fs = std::filesystem;

namespace {

/// What comes until the other end closes, or the time is over.
std::string readUntilClosed(int pipe, int patience) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::milliseconds(patience);
  std::string text;
  std::array<char, 4096> piece{};
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waited{pipe, POLLIN, 0};
    const int ready = left > 0 ? poll(&waited, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    const ssize_t count = ready > 0 ? read(pipe, piece.data(), piece.size()) : 0;
    if (count <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

fs::path siblingProgram(const std::string& name) {
  for (const fs::path& folder : config::programFolders()) {
    for (const char* place : {".", "../bin", "../libexec/hapticell"}) {
      const fs::path beside = folder / place / name;
      if (::access(beside.c_str(), X_OK) == 0) return beside.lexically_normal();
    }
  }
  return config::systemProgram(name);
}

std::string answerOf(const fs::path& program, const std::vector<std::string>& arguments, int patience) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  const bool started = posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  const std::string text = started ? readUntilClosed(ends[0], patience) : std::string();
  close(ends[0]);
  if (started) {
    kill(child, SIGKILL);  // It has answered, or never will.
    waitpid(child, nullptr, 0);
  }
  return text;
}

}  // namespace hapticell::cli
