// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace hapticell::geometry {

void preferLargePages(const void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  // Large pages that the block must hold, as the whole of none is used at its ends. Half, twice: no effect.
  constexpr std::uintptr_t kLeast = 2;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) & ~(kPage - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kPage - 1);
  if (end < begin + kLeast * kPage) return;
  // What fails leaves small pages, which do as well.
  (void)::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
#else
  (void)memory;
  (void)bytes;
#endif
}

}  // namespace hapticell::geometry
