// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/in_parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hapticell::geometry {
namespace {

TEST(InParallel, EachItemIsOfOneRange) {
  for (std::size_t count : {0u, 1u, 5u, 1000u}) {
    std::vector<int> seen(count, 0);
    inRanges(count, 7, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++seen[k];
    });
    EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0), static_cast<int>(count));
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count));
  }
}

TEST(InParallel, LittleWorkIsOneRange) {
  EXPECT_EQ(rangesOf(0, 100), 1u);
  EXPECT_EQ(rangesOf(99, 100), 1u);
  EXPECT_LE(rangesOf(1'000'000, 1), 8u);
}

/// How often this process has read from a file; none where the system does not say.
std::optional<long> readsOfThisProcess() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  for (long count = 0; counts >> name >> count;)
    if (name == "syscr:") return count;
  return std::nullopt;
}

TEST(InParallel, AsksTheSystemForItsProcessorsOnce) {
  rangesOf(1000, 1);
  const auto before = readsOfThisProcess();
  for (int i = 0; i < 1000; ++i) rangesOf(1000, 1);
  const auto after = readsOfThisProcess();
  if (!before || !after) GTEST_SKIP() << "the system does not count reads";
  EXPECT_LT(*after - *before, 100) << "but for the counts themselves";
}

TEST(InParallel, WhatIsThrownComesBack) {
  EXPECT_THROW(inRanges(10, 3, [](std::size_t, std::size_t begin, std::size_t) {
                 if (begin > 0) throw std::runtime_error("no");
               }),
               std::runtime_error);
}

}  // namespace
}  // namespace hapticell::geometry
