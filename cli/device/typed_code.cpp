// SPDX-License-Identifier: Apache-2.0
#include "cli/device/typed_code.h"

#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

namespace hapticell::cli {

namespace {

// Bytes: guards memory; a code is some ten letters. Half, twice: no effect.
constexpr std::size_t kLongestLine = 200;

/// No echo while it lives; a terminal that was interrupted meanwhile gets its echo back too.
class SilentTerminal {
 public:
  SilentTerminal() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGQUIT}) sigaddset(&signals, signal);
    sigprocmask(SIG_BLOCK, &signals, &signals_);
    silent_ = tcgetattr(STDIN_FILENO, &before_) == 0;
    if (!silent_) return;
    termios quiet = before_;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    quiet.c_lflag |= ICANON;
    quiet.c_lflag &= ~static_cast<tcflag_t>(ISIG);  // Ctrl+C comes as a sign, see readLine(): the echo is put back.
    quiet.c_cc[VEOL] = 3;                           // And it ends the line.
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &quiet);
  }
  ~SilentTerminal() {
    if (silent_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
    sigprocmask(SIG_SETMASK, &signals_, nullptr);
  }
  SilentTerminal(const SilentTerminal&) = delete;
  SilentTerminal& operator=(const SilentTerminal&) = delete;

 private:
  termios before_{};
  sigset_t signals_{};
  bool silent_ = false;
};

Expected<std::string> readLine() {
  constexpr char kInterrupt = 3;
  std::string line;
  char sign = 0;
  while (true) {
    const ssize_t got = ::read(STDIN_FILENO, &sign, 1);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0 || sign == kInterrupt) break;
    if (sign == '\n' || sign == '\r') return line;
    line += sign;
    if (line.size() > kLongestLine)
      return makeError(
          {.place = "standard input", .found = "a line of over 200 characters", .expected = "a pairing code"});
  }
  if (!line.empty() && sign != kInterrupt) return line;
  return makeError({.place = "standard input",
                    .found = "the input ended without a pairing code",
                    .expected = "the pairing code on one line",
                    .fix = "Type the code that hapticell-haptic-server --pair shows."});
}

}  // namespace

Expected<std::string> readTypedCode(const std::string& prompt) {
  if (::isatty(STDIN_FILENO) != 1) return readLine();
  std::fprintf(stderr, "%s", prompt.c_str());
  std::fflush(stderr);
  const auto line = [] {
    const SilentTerminal silent;
    return readLine();
  }();
  std::fputs("\n", stderr);
  return line;
}

}  // namespace hapticell::cli
