// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/edge_uses.h"

#include <algorithm>

#include "geometry/system/assertion.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::geometry {

namespace {

using Use = EdgeUses::Use;

bool comesBefore(const Use& a, const Use& b) {
  return a.high != b.high ? a.high < b.high : a.code < b.code;
}

/// Mostly some six of them.
void sortFew(std::span<Use> uses) {
  // Uses from which on std::sort() is quicker. Half, twice: no effect.
  constexpr std::size_t kFew = 24;
  if (uses.size() > kFew) return std::sort(uses.begin(), uses.end(), comesBefore);
  for (std::size_t k = 1; k < uses.size(); ++k) {
    const Use use = uses[k];
    std::size_t at = k;
    for (; at > 0 && comesBefore(use, uses[at - 1]); --at) uses[at] = uses[at - 1];
    uses[at] = use;
  }
}

}  // namespace

EdgeUses::EdgeUses(std::span<const Triangle> triangles, std::size_t vertices) {
  begin_.resize(vertices + 1);
  constexpr std::size_t kMost = 700'000'000;
  HAPTICELL_DEMAND(triangles.size() <= kMost);
  // Each thread looks at all triangles and writes what belongs to its vertices, since to write here and there is what
  // takes long. Vertices for a thread to be worth it. Half, twice: no effect.
  constexpr std::size_t kLeastVertices = 20'000;
  const std::size_t ranges = rangesOf(vertices, kLeastVertices);
  inRanges(vertices, ranges, [&](std::size_t, std::size_t first, std::size_t last) {
    for (const Triangle& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = t[k], to = t[k == 2 ? 0 : k + 1], low = std::min(from, to);
        if (from != to && low - first < last - first) ++begin_[low];
      }
    }
  });
  std::uint32_t sum = 0;  // Each place becomes the end of its uses, from where they are filled in backwards.
  for (std::uint32_t& place : begin_) place = sum += place;
  uses_.resize(sum);
  inRanges(vertices, ranges, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t t = triangles.size(); t-- > 0;) {
      for (std::size_t k = 3; k-- > 0;) {
        const std::uint32_t from = triangles[t][k], to = triangles[t][k == 2 ? 0 : k + 1], low = std::min(from, to);
        if (from == to || low - first >= last - first) continue;
        const bool up = from < to;
        uses_[--begin_[low]] = {up ? to : from, static_cast<std::uint32_t>(2 * (3 * t + k) + (up ? 1u : 0u))};
      }
    }
  });
  inRanges(vertices, ranges, [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t low = first; low < last; ++low) {
      sortFew(std::span(uses_).subspan(begin_[low], begin_[low + 1] - begin_[low]));
    }
  });
}

}  // namespace hapticell::geometry
