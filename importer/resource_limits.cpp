// SPDX-License-Identifier: Apache-2.0
#include "importer/resource_limits.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "geometry/system/sanitizers.h"

namespace hapticell::importer {

namespace {

void limit(int resource, std::uint64_t value) {
  rlimit bounds{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &bounds);
  if (bounds.rlim_max != RLIM_INFINITY && bounds.rlim_max < value) value = bounds.rlim_max;
  bounds.rlim_cur = value;
  ::setrlimit(static_cast<__rlimit_resource>(resource), &bounds);
}

}  // namespace

void limitResources(std::uint64_t bytes, std::uint64_t seconds) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() == 1) ::_exit(1);  // The parent was gone before it was asked for.
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, 2 * seconds);  // Of all threads together; the parent counts the time that passes.
#if !HAPTICELL_SANITIZED
  limit(RLIMIT_AS, bytes);  // The sanitizers reserve terabytes.
#else
  static_cast<void>(bytes);
#endif
}

}  // namespace hapticell::importer
