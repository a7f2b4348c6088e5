// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/detail_level.h"

#include <algorithm>

namespace hapticell::app {
namespace {

// Frames in time before a level that took over twice the budget is tried again: about half a minute at 10 Hz. Half:
// jerks twice as often; twice: a faster scene stays coarse.
constexpr int kLongPatience = 300;
// Triangles that are always allowed: some milliseconds without a graphics card; a figure needs 9000. Half: a figure is
// drawn coarse for nothing; twice: slow machines miss their 55 ms.
constexpr double kFewForAll = 12000.0;

}  // namespace

double allowedPixels(DetailLevel level) {
  switch (level) {
    case DetailLevel::kFull:
      return 0.35;
    case DetailLevel::kNoOcclusion:
    case DetailLevel::kPlain:
      return 0.7;
    case DetailLevel::kNoEdges:
      return 1.0;
    case DetailLevel::kHalfSize:
      return 1.5;
    case DetailLevel::kCoarse:
      break;
  }
  return kMostPixels;
}

void DetailGovernor::learnTriangles(double seconds, std::size_t triangles) {
  const auto drawn = static_cast<double>(triangles);
  const auto most = static_cast<double>(most_triangles_);
  if (seconds < 0.5 * budget_s_) {
    // Many fitted into a part of the time; a frame that used what it may tries more.
    const double grown = drawn > 0.7 * most ? 1.4 * most : most;
    most_triangles_ = static_cast<std::size_t>(std::clamp(std::max(grown, 1.2 * drawn), 0.0, 1e9));
  } else if (seconds > budget_s_ && level_ >= DetailLevel::kHalfSize) {
    // Above that level other things than triangles may take the time.
    const double share = std::max(0.7 * budget_s_ / seconds, 0.1);
    most_triangles_ = static_cast<std::size_t>(std::max(share * std::min(drawn, most), kFewForAll));
  }
}

void DetailGovernor::frameTook(double seconds, std::size_t triangles) {
  if (triangles > 0) learnTriangles(seconds, triangles);
  const int level = static_cast<int>(level_);
  const int last = static_cast<int>(DetailLevel::kCoarse);
  last_took_[level] = seconds;
  if (seconds > budget_s_) {
    // A step that was just given back was one too many: wait longer before the next try.
    patience_ = std::max(patience_, kPatience);
    if (just_raised_) patience_ = std::min(patience_ * 2, 600);
    const int steps = seconds > 2.5 * budget_s_ ? 2 : 1;
    level_ = static_cast<DetailLevel>(std::min(level + steps, last));
    good_frames_ = 0;
    just_raised_ = false;
    return;
  }
  good_frames_ = seconds < 0.5 * budget_s_ ? good_frames_ + 1 : 0;
  if (good_frames_ > 5) just_raised_ = false;
  if (level == 0) return;
  const bool was_far_too_slow = last_took_[level - 1] > 2.0 * budget_s_;
  if (good_frames_ < (was_far_too_slow ? std::max(patience_, kLongPatience) : patience_)) return;
  level_ = static_cast<DetailLevel>(level - 1);
  good_frames_ = 0;
  just_raised_ = true;
}

void FrameMeter::frame(double now_s, double took_s) {
  start_[count_ % kCapacity] = now_s;
  took_[count_ % kCapacity] = took_s;
  ++count_;
  last_took_ = took_s;
}

double FrameMeter::rate(double now_s) const {
  const std::size_t kept = std::min(count_, kCapacity);
  std::size_t recent = 0;
  double oldest = now_s;
  for (std::size_t i = 0; i < kept; ++i) {
    if (now_s - start_[i] > 1.0) continue;
    ++recent;
    oldest = std::min(oldest, start_[i]);
  }
  if (recent < 2 || now_s <= oldest) return static_cast<double>(recent);
  return static_cast<double>(recent) / std::max(now_s - oldest, 1e-6);
}

double FrameMeter::worstSeconds() const {
  const std::size_t kept = std::min(count_, kCapacity);
  return kept == 0 ? 0.0 : *std::max_element(took_, took_ + kept);
}

}  // namespace hapticell::app
