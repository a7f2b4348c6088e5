// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/real_time_runner.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <future>

#include "geometry/system/assertion.h"
#include "geometry/system/error.h"
#include "haptic/devices/system_access.h"
#include "haptic/server/force_loop.h"

namespace hapticell::haptic {

namespace {

Text askForPriority(int priority) {
  sched_param parameter{};
  parameter.sched_priority = priority;
  const int refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
  if (refused == 0) return {};
  return Text(
      "The force loop runs without real-time priority (SCHED_FIFO %1: %2), so ticks are late when the computer is "
      "busy. To allow it: %3",
      priority, systemText(refused), priorityFix());
}

Text askForLockedMemory() {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  // Under a limit MCL_FUTURE would make later allocations fail: then only what is there is locked.
  const bool unlimited = limit.rlim_cur == RLIM_INFINITY || geteuid() == 0;
  if (mlockall(unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0) return {};
  return Text(
      "Memory is not locked (mlockall: %1), so ticks can be late while memory is swapped in. To allow it: %2",
      systemText(errno), lockedMemoryFix());
}

void sleepUntil(std::int64_t deadline) {
  const timespec until{static_cast<time_t>(deadline / 1'000'000'000), static_cast<long>(deadline % 1'000'000'000)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace

RealTimeRunner::RealTimeRunner(ForceLoop& loop, const RealTimeOptions& options) : loop_(loop), options_(options) {}

RealTimeRunner::~RealTimeRunner() {
  stop();
}

void RealTimeRunner::start() {
  HAPTICELL_DEMAND(!thread_.joinable());
  warnings_.clear();
  if (options_.lock_memory) {
    if (Text warning = askForLockedMemory(); !warning.empty()) warnings_.push_back(std::move(warning));
  }
  stopping_ = false;
  std::promise<Text> granted;
  auto priority_warning = granted.get_future();
  thread_ = std::thread([this, &granted] {
    pthread_setname_np(pthread_self(), "force-loop");
    prctl(PR_SET_TIMERSLACK, 1);
    granted.set_value(options_.fifo ? askForPriority(options_.priority) : Text());
    run();
  });
  if (Text warning = priority_warning.get(); !warning.empty()) warnings_.push_back(std::move(warning));
}

void RealTimeRunner::run() {
  const RealClock clock;
  const std::int64_t period = toNanoseconds(loop_.period());
  std::int64_t deadline = clock.now() + period;
  while (!stopping_.load(std::memory_order_relaxed)) {
    sleepUntil(deadline);
    const std::int64_t late = clock.now() - deadline;
    const std::int64_t skipped = late / period;
    loop_.tick({.late_ns = late, .skipped = static_cast<std::uint32_t>(skipped)});
    deadline += period * (1 + skipped);
  }
  loop_.shutDown();
}

void RealTimeRunner::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace hapticell::haptic
