// SPDX-License-Identifier: Apache-2.0
#include "workcell/import/background_thread.h"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace hapticell::workcell {

void lowerThreadPriority() {
#ifdef __linux__
  // Of 19: in the middle, so that a busy machine's window and loops go first. Half: reading takes from them; twice: it
  // stands still beside other work.
  constexpr int kNice = 10;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  if (getpriority(PRIO_PROCESS, thread) < kNice) setpriority(PRIO_PROCESS, thread, kNice);
#endif
}

}  // namespace hapticell::workcell
