// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticell::geometry {

/// Asks the system to back memory that nothing was written to yet by large pages (of 2 MB on x86-64) in place of
/// thousands of small ones, each of which costs an interruption at its first use and an entry of the tables by which
/// addresses are looked up. A wish only: has no effect on contents, on small blocks, or where the system has no such
/// pages. Any thread.
void preferLargePages(const void* memory, std::size_t bytes);

/// container.reserve(count), on large pages: a vector or string of plain values.
template <typename Container>
void reserveLarge(Container& container, std::size_t count) {
  if (count <= container.capacity()) return;
  container.reserve(count);
  preferLargePages(container.data(), count * sizeof(typename Container::value_type));
}

/// container.resize(count, value), on large pages.
template <typename Container>
void resizeLarge(Container& container, std::size_t count, const typename Container::value_type& value = {}) {
  reserveLarge(container, count);
  container.resize(count, value);
}

}  // namespace hapticell::geometry
