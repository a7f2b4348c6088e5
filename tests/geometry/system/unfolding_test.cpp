// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/unfolding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hapticell::geometry {
namespace {

using ::testing::HasSubstr;
using Graph = std::vector<std::vector<std::uint32_t>>;

std::string said(const Graph& below, const std::vector<std::uint32_t>& roots, const UnfoldingLimits& limits = {}) {
  const auto checked =
      checkUnfolding(below, roots, limits, [](std::uint32_t node) { return "node " + std::to_string(node); });
  return checked ? "" : checked.error().message();
}

TEST(Unfolding, TreesAndWhatStandsInSeveralPlacesAreGood) {
  EXPECT_EQ(said({}, {}), "");
  EXPECT_EQ(said({{1, 2}, {}, {}}, {0}), "");
  EXPECT_EQ(said({{1, 1, 1, 2}, {2, 2}, {}}, {0, 1, 1}), "");
  EXPECT_EQ(said({{7}, {}}, {0, 9}), "") << "what is not there is left to the reader";
}

TEST(Unfolding, CirclesAreFoundWhereverTheyAre) {
  EXPECT_THAT(said({{0}}, {0}), HasSubstr("node 0: it contains itself"));
  EXPECT_THAT(said({{1}, {2}, {3, 1}, {}}, {0}), HasSubstr("node 1: it contains itself"));
  EXPECT_EQ(said({{1}, {}, {2}}, {0}), "") << "one that no root leads to";
}

TEST(Unfolding, IsCountedNotDone) {
  Graph doubled;
  for (std::uint32_t k = 0; k < 60; ++k) doubled.push_back({k + 1, k + 1});
  doubled.push_back({});
  EXPECT_THAT(said(doubled, {0}), HasSubstr("node 0: it expands to more than 200000 nodes"));
  EXPECT_EQ(said(doubled, {45}), "") << "2^16 - 1 nodes";
  EXPECT_NE(said(doubled, {43}), "") << "2^18 - 1";
  Graph wide(1, std::vector<std::uint32_t>(300'000, 1));
  wide.push_back({});
  EXPECT_NE(said(wide, {0}), "");
  Graph all(1);
  for (std::uint32_t k = 1; k < 300'000; ++k) all[0].push_back(k);
  all.resize(300'000);
  EXPECT_EQ(said(all, {0}), "") << "a file may state as many as it has room for";
}

TEST(Unfolding, DepthIsBoundedWithoutRecursion) {
  Graph chain;
  for (std::uint32_t k = 0; k < 500'000; ++k) chain.push_back({k + 1});
  chain.push_back({});
  EXPECT_THAT(said(chain, {0}), HasSubstr("more than 200 nested levels"));
  EXPECT_EQ(said(chain, {499'801}), "") << "200 levels";
  EXPECT_NE(said(chain, {499'800}), "");
}

}  // namespace
}  // namespace hapticell::geometry
