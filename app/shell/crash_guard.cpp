// SPDX-License-Identifier: Apache-2.0
#include "app/shell/crash_guard.h"

#ifdef __linux__
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "geometry/system/assertion.h"
#endif

namespace hapticell::app {

#ifdef __linux__
namespace {

constexpr std::array kBreaks{SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
enum class Keeping { kIdle, kKept, kFailed };

/// All that the handler touches; it may neither allocate nor lock.
struct Guarded {
  std::array<struct sigaction, kBreaks.size()> before;
  std::array<char, 4096> note{};
  std::array<char, 256> uncaught{};
  std::function<bool()> keep;
  std::optional<CrashReport> report;
  sem_t wake;
  std::atomic<bool> broken{false}, ended{false};
  std::atomic<pid_t> breaker{0};
  std::atomic<Keeping> keeping{Keeping::kIdle};
  std::thread keeper;
  std::terminate_handler terminate_before = nullptr;
  std::array<char, 64 * 1024> stack;  // Of the window's thread, where its own has run over.
};
Guarded* guarded = nullptr;

/// The keeper's own faults are told by where they come from.
thread_local bool is_keeper = false;

void writeText(int file, const char* text) {
  [[maybe_unused]] const auto written = ::write(file, text, std::strlen(text));
}

const char* nameOf(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "invalid memory access (SIGSEGV)";
    case SIGBUS:
      return "memory error (SIGBUS)";
    case SIGFPE:
      return "arithmetic error (SIGFPE)";
    case SIGILL:
      return "invalid instruction (SIGILL)";
    default:
      return "the program aborted (SIGABRT)";
  }
}

const char* causeOf(int signal) {
  if (signal == SIGABRT && *brokenContract()) return brokenContract();
  if (signal == SIGABRT && *guarded->uncaught.data()) return guarded->uncaught.data();
  return nameOf(signal);
}

void writeNote(const Crash& crash) {
  const int file = ::open(guarded->note.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return;
  writeText(file, crash.cause);
  writeText(file, " [");
  writeText(file, crash.thread);
  writeText(file, "]\n");
  ::close(file);
}

void writeCrash(int signal) {
  std::array<char, 32> thread{};
  ::prctl(PR_GET_NAME, thread.data());
  const Crash crash{causeOf(signal), thread.data(), guarded->keeping == Keeping::kKept};
  writeNote(crash);
  if (guarded->report) guarded->report->write(crash);
}

void waitForKeeper() {
  // ns between two looks for the copy, 2 ms. Half, twice: a crash ends so much later.
  constexpr long kLook = 2'000'000;
  constexpr int kLooks = static_cast<int>(CrashGuard::kPatience * 1e9 / kLook);
  ::sem_post(&guarded->wake);
  for (int look = 0; look < kLooks && guarded->keeping == Keeping::kIdle; ++look) {
    const timespec pause{0, kLook};
    ::nanosleep(&pause, nullptr);
  }
}

void restoreHandlers() {
  for (std::size_t i = 0; i < kBreaks.size(); ++i) ::sigaction(kBreaks[i], &guarded->before[i], nullptr);
}

void handleBreak(int signal) {
  const pid_t thread = ::gettid();
  if (!guarded->broken.exchange(true)) {
    guarded->breaker = thread;
    waitForKeeper();
    writeCrash(signal);
  } else if (guarded->breaker != thread) {
    // The first one ends the program for all; the keeper that broke too must not keep it waiting.
    if (is_keeper) guarded->keeping = Keeping::kFailed;
    for (;;) ::pause();
  }
  restoreHandlers();
  ::raise(signal);  // Delivered once this returns.
}

[[noreturn]] void handleTerminate() {
  auto& text = guarded->uncaught;
  if (std::current_exception()) {
    try {
      throw;
    } catch (const std::exception& exception) {
      std::snprintf(text.data(), text.size(), "uncaught error: %s", exception.what());
    } catch (...) {
      std::snprintf(text.data(), text.size(), "uncaught error");
    }
  }
  std::abort();
}

void runKeeper() {
  is_keeper = true;
  ::pthread_setname_np(::pthread_self(), "crash-keeper");
  while (::sem_wait(&guarded->wake) != 0) {
  }
  if (guarded->ended) return;
  bool kept = false;
  try {
    kept = guarded->keep();
  } catch (...) {  // No memory, say: the copy of a minute ago stands.
  }
  guarded->keeping = kept ? Keeping::kKept : Keeping::kFailed;
}

}  // namespace

CrashGuard::CrashGuard(std::function<bool()> keep, const std::filesystem::path& note,
                       std::optional<CrashReport> report) {
  const std::string path = note.string();
  if (guarded || path.size() >= sizeof guarded->note) return;
  guarded = new Guarded;
  guarded->keep = std::move(keep);
  guarded->report = std::move(report);
  std::memcpy(guarded->note.data(), path.c_str(), path.size() + 1);
  std::array<void*, 1> first;
  ::backtrace(first.data(), 1);  // Loads what it needs now: later there may be no memory.
  ::sem_init(&guarded->wake, 0, 0);
  guarded->keeper = std::thread(runKeeper);
  guarded->terminate_before = std::set_terminate(handleTerminate);
  stack_t stack{};
  stack.ss_sp = guarded->stack.data();
  stack.ss_size = guarded->stack.size();
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = handleBreak;
  action.sa_flags = SA_ONSTACK;
  for (std::size_t i = 0; i < kBreaks.size(); ++i) ::sigaction(kBreaks[i], &action, &guarded->before[i]);
  is_mine_ = true;
}

CrashGuard::~CrashGuard() {
  if (!is_mine_) return;
  restoreHandlers();
  std::set_terminate(guarded->terminate_before);
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  ::sigaltstack(&none, nullptr);
  guarded->ended = true;
  ::sem_post(&guarded->wake);
  guarded->keeper.join();
  ::sem_destroy(&guarded->wake);
  delete guarded;
  guarded = nullptr;
}
#else
CrashGuard::CrashGuard(std::function<bool()>, const std::filesystem::path&, std::optional<CrashReport>) {}
CrashGuard::~CrashGuard() = default;
#endif

}  // namespace hapticell::app
