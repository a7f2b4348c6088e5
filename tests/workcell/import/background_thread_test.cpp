// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/background_thread.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <thread>

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace hapticell::workcell {
namespace {

int niceness() {
  errno = 0;
  return getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
}

TEST(BackgroundThread, LowersItsOwnThreadAndThoseItStartsOnly) {
  const int before = niceness();
  int lowered = -100, below = -100, again = -100;
  std::thread([&] {
    lowerThreadPriority();
    lowered = niceness();
    std::thread([&] { below = niceness(); }).join();
    lowerThreadPriority();
    again = niceness();
  }).join();
  EXPECT_EQ(lowered, before < 10 ? 10 : before) << "never raised";
  EXPECT_EQ(below, lowered);
  EXPECT_EQ(again, lowered);
  EXPECT_EQ(niceness(), before);
}

}  // namespace
}  // namespace hapticell::workcell
#endif
