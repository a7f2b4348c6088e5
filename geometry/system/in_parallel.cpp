// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/in_parallel.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace hapticell::geometry {

std::size_t rangesOf(std::size_t count, std::size_t least) {
  // Threads: memory is the limit before that. Half: large machines wait longer; twice: no gain.
  constexpr std::size_t kMost = 8;
  // Asked once: each time reads a file of the system, and every mesh that is looked at asks.
  static const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  return std::clamp<std::size_t>(count / std::max<std::size_t>(least, 1), 1, std::min(cores, kMost));
}

void inRanges(std::size_t count, std::size_t ranges,
              const std::function<void(std::size_t number, std::size_t begin, std::size_t end)>& work) {
  std::vector<std::exception_ptr> thrown(ranges);
  const auto one = [&](std::size_t number) {
    try {
      work(number, count * number / ranges, count * (number + 1) / ranges);
    } catch (...) {
      thrown[number] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(ranges);
  std::size_t started = 1;
  try {
    for (; started < ranges; ++started) threads.emplace_back(one, started);
  } catch (const std::system_error&) {  // No more threads: the rest is done here.
  }
  one(0);
  for (std::size_t number = started; number < ranges; ++number) one(number);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& fault : thrown) {
    if (fault) std::rethrow_exception(fault);
  }
}

}  // namespace hapticell::geometry
