// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace hapticell::geometry {

/// How many threads inRanges() uses for work of this size, of which one needs at least `least` items to be worth it:
/// at most one a core and eight in all, at least one.
std::size_t rangesOf(std::size_t count, std::size_t least);

/// Cuts 0 … count - 1 into `ranges` ranges of nearly the same length and calls work(number, begin, end) for each, on a
/// thread each, the caller's among them. Returns when all have ended. Where no thread can be started the caller does
/// its work. An exception of `work` is thrown again here; if several ranges threw, that of the first range.
void inRanges(std::size_t count, std::size_t ranges,
              const std::function<void(std::size_t number, std::size_t begin, std::size_t end)>& work);

}  // namespace hapticell::geometry
