// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/system/in_parallel.h"
#include "trajectory/editing/segment_distance.h"

namespace hapticell::trajectory {

/// The frame that is farthest off, of equal ones the first, and how far; frame 0 where none is farther than the given.
struct FarthestFrame {
  std::size_t at = 0;
  double off = 1.0;
};

/// Of the frames first + 1 … last - 1 of the range within the span.
template <typename Off>
FarthestFrame farthestFrame(const FrameSpan& span, std::size_t first, std::size_t last, const Off& off) {
  FarthestFrame worst;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double share = off(i, span);
    if (share > worst.off) worst = {i, share};
  }
  return worst;
}

/// Splits spans of frames at the frame that deviates most from the straight segment between the ends, until no
/// deviation is greater than 1. The split frames are added to `kept`, which is sorted at the end (Douglas & Peucker,
/// Cartographica 10(2), 1973). `off(i, span)` returns the deviation of frame i.
template <typename Off>
void splitAtFarthest(std::vector<FrameSpan> open, const Off& off, std::vector<std::size_t>& kept) {
  while (!open.empty()) {
    const FrameSpan span = open.back();
    open.pop_back();
    const std::size_t at = farthestFrame(span, span.first, span.last, off).at;
    if (at == 0) continue;
    kept.push_back(at);
    open.push_back({span.first, at});
    open.push_back({at, span.last});
  }
  std::sort(kept.begin(), kept.end());
}

/// Frames that are worth a thread of their own: at 0.1 us each or more that is 400 us, to start one takes 30. Half: the
/// start is felt; twice: short motions are split by one.
inline constexpr std::size_t kFramesForAThread = 4000;

/// The same frames on all cores, which call `off` at once: long spans are searched together, then each short one is
/// split by whoever is free.
template <typename Off>
void splitAtFarthestTogether(std::vector<FrameSpan> open, const Off& off, std::vector<std::size_t>& kept) {
  std::size_t all = 0;
  for (const FrameSpan& span : open) all += span.last - span.first;
  const std::size_t threads = geometry::rangesOf(all, kFramesForAThread);
  if (threads == 1) return splitAtFarthest(std::move(open), off, kept);
  const std::size_t is_short = std::max(kFramesForAThread, all / (8 * threads));
  std::vector<FrameSpan> rest;
  while (!open.empty()) {
    const FrameSpan span = open.back();
    open.pop_back();
    const std::size_t frames = span.last - span.first;
    if (frames <= is_short) {
      rest.push_back(span);
      continue;
    }
    std::vector<FarthestFrame> of_ranges(geometry::rangesOf(frames, kFramesForAThread));
    geometry::inRanges(frames, of_ranges.size(), [&](std::size_t number, std::size_t begin, std::size_t end) {
      // The first frame of a range is looked at too, but for the span's own.
      const std::size_t first = span.first + begin - (begin == 0 ? 0 : 1);
      of_ranges[number] = farthestFrame(span, first, span.first + end, off);
    });
    FarthestFrame worst;
    for (const FarthestFrame& one : of_ranges) {
      if (one.off > worst.off) worst = one;
    }
    if (worst.at == 0) continue;
    kept.push_back(worst.at);
    open.push_back({span.first, worst.at});
    open.push_back({worst.at, span.last});
  }
  std::atomic<std::size_t> next{0};
  std::vector<std::vector<std::size_t>> found(threads);
  geometry::inRanges(threads, threads, [&](std::size_t number, std::size_t, std::size_t) {
    for (std::size_t k = next++; k < rest.size(); k = next++) splitAtFarthest({rest[k]}, off, found[number]);
  });
  for (const auto& of_thread : found) kept.insert(kept.end(), of_thread.begin(), of_thread.end());
  std::sort(kept.begin(), kept.end());
}

}  // namespace hapticell::trajectory
