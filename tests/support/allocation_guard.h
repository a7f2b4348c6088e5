// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::test {

/// Counts what the calling thread takes from the heap while it lives.
///
/// Link hapticell_allocation_guard: it replaces operator new for the whole test program. Guards may nest; each sees the
/// allocations since it was made.
class AllocationGuard {
 public:
  AllocationGuard();
  /// Allocations by this thread since this guard was made.
  std::size_t count() const;

 private:
  std::size_t at_start_;
};

}  // namespace hapticell::test
