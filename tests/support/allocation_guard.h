// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::test {

/// Whether the two below do anything: not beneath clang's thread sanitizer. A test that needs them skips where not.
bool allocationsAreCounted();
inline constexpr const char* kNotCounted = "beneath clang's thread sanitizer allocations are not counted";

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

/// While it lives, the calling thread gets `granted` allocations of `smallest` bytes or more; all that follow of that
/// size throw std::bad_alloc. One at a time.
class MemoryShortage {
 public:
  explicit MemoryShortage(std::size_t granted, std::size_t smallest = 0);
  MemoryShortage(const MemoryShortage&) = delete;
  MemoryShortage& operator=(const MemoryShortage&) = delete;
  ~MemoryShortage();
};

}  // namespace hapticell::test
