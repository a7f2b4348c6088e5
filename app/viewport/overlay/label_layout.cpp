// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/label_layout.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

// s in which a label goes to its new place: seen as motion. Half: it jumps; twice: it swims behind.
constexpr double kMoveSeconds = 0.12;
constexpr double kBorder = 8.0;
constexpr double kPointRoom = 16.0;  // Free room round the point itself.

/// How much a place has to keep free; what comes last is given up first.
enum class Care { kBoxes, kPoints, kLines };

/// What is taken already.
struct Taken {
  std::vector<PixelBox> boxes, points, labels;
  const std::vector<PixelLine>& lines;
};

PixelBox boxAt(const LabelWish& wish, const glm::dvec2& offset) {
  return {wish.anchor + offset, wish.anchor + offset + wish.size};
}

PixelBox both(const PixelBox& a, const PixelBox& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

bool isClear(const PixelBox& box, const std::vector<PixelBox>& others) {
  return std::none_of(others.begin(), others.end(), [&](const PixelBox& other) { return box.overlaps(other); });
}

bool fits(const PixelBox& box, const Taken& taken, const ViewSize& size, Care care) {
  if (box.min.x < kBorder || box.min.y < kBorder || box.max.x > size.width - kBorder ||
      box.max.y > size.height - kBorder)
    return false;
  if (!isClear(box, taken.boxes) || !isClear(box, taken.labels)) return false;
  if (care == Care::kBoxes) return true;
  if (!isClear(box, taken.points)) return false;
  if (care == Care::kPoints) return true;
  return std::none_of(taken.lines.begin(), taken.lines.end(), [&](const PixelLine& line) { return line.reaches(box); });
}

struct Candidate {
  glm::dvec2 offset;
  bool right;
};

/// Right beside the point.
std::vector<Candidate> closeCandidates(const LabelWish& wish, bool right_first) {
  const glm::dvec2 half = 0.5 * wish.size;
  std::vector<Candidate> result;
  for (const double gap : {wish.gap, 2.0 * wish.gap}) {
    for (const bool right : {right_first, !right_first})
      result.push_back({{right ? gap : -gap - wish.size.x, -half.y}, right});
    result.push_back({{-half.x, -gap - wish.size.y}, right_first});
    result.push_back({{-half.x, gap}, right_first});
    for (const bool right : {right_first, !right_first})
      for (const double y : {-gap - wish.size.y, gap})
        result.push_back({{right ? 0.5 * gap : -0.5 * gap - wish.size.x, y}, right});
  }
  return result;
}

/// Places from near to far; the wanted side first, then above and below.
std::vector<Candidate> candidates(const LabelWish& wish, bool right_first) {
  if (wish.gap > 0.0) return closeCandidates(wish, right_first);
  std::vector<Candidate> result;
  for (const double gap : {70.0, 110.0, 170.0, 250.0}) {
    for (const bool right : {right_first, !right_first})
      for (const double rise : {-0.5, -1.6, 0.6, -2.8, 1.8})
        result.push_back({{right ? gap : -gap - wish.size.x, rise * wish.size.y}, right});
    for (const double y : {-gap - wish.size.y, gap}) result.push_back({{-0.5 * wish.size.x, y}, right_first});
  }
  return result;
}

/// Anywhere in the view, the nearest to the point.
std::optional<Candidate> anywhere(const LabelWish& wish, const Taken& taken, const ViewSize& size) {
  std::optional<Candidate> best;
  double nearest = 1e9;
  for (double y = kBorder; y + wish.size.y <= size.height - kBorder; y += 0.5 * wish.size.y)
    for (double x = kBorder; x + wish.size.x <= size.width - kBorder; x += 0.25 * wish.size.x) {
      const glm::dvec2 offset = glm::dvec2(x, y) - wish.anchor;
      const double away = glm::length(offset + 0.5 * wish.size);
      if (away >= nearest || !fits(boxAt(wish, offset), taken, size, Care::kBoxes)) continue;
      nearest = away;
      best = Candidate{offset, offset.x > -0.5 * wish.size.x};
    }
  return best;
}

/// The place to stay at or to go to; empty: no place.
std::optional<Candidate> choose(const LabelWish& wish, const std::optional<Candidate>& now, bool right,
                                const Taken& taken, const ViewSize& size) {
  const std::vector<Candidate> places = candidates(wish, right);
  for (const Care care : {Care::kLines, Care::kPoints, Care::kBoxes}) {
    const auto good = [&](const Candidate& at) { return fits(boxAt(wish, at.offset), taken, size, care); };
    if (now && good(*now)) return now;
    const auto found = std::find_if(places.begin(), places.end(), good);
    if (found != places.end()) return *found;
  }
  return wish.gap > 0.0 ? std::nullopt : anywhere(wish, taken, size);
}

}  // namespace

bool PixelLine::reaches(const PixelBox& box) const {
  // The part of the line, from 0 to 1, that lies between the box's sides.
  const glm::dvec2 low = box.min - room, high = box.max + room, along = to - from;
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] == 0.0) {
      if (from[axis] <= low[axis] || from[axis] >= high[axis]) return false;
      continue;
    }
    const double a = (low[axis] - from[axis]) / along[axis], b = (high[axis] - from[axis]) / along[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}

const LabelLayout::Memory* LabelLayout::remembered(std::uint64_t key) const {
  const auto found = std::find_if(memories_.begin(), memories_.end(), [key](const Memory& m) { return m.key == key; });
  return found == memories_.end() ? nullptr : &*found;
}

/// On its way it passes over no other label.
bool LabelLayout::mayGlide(const LabelWish& wish, const Memory& memory, const std::vector<LabelWish>& wishes) const {
  const PixelBox way = both(boxAt(wish, memory.shown), boxAt(wish, memory.offset));
  return std::none_of(wishes.begin(), wishes.end(), [&](const LabelWish& other) {
    const Memory* known = other.key == wish.key ? nullptr : remembered(other.key);
    return known && way.overlaps(both(boxAt(other, known->shown), boxAt(other, known->offset)));
  });
}

std::vector<PlacedLabel> LabelLayout::place(const std::vector<LabelWish>& wishes, const KeptFree& keep_free,
                                            const ViewSize& size, double seconds, bool motion) {
  Taken taken{keep_free.boxes, {}, {}, keep_free.lines};
  std::vector<Memory> next;
  std::vector<PlacedLabel> result;
  moving_ = false;
  for (const LabelWish& wish : wishes)
    if (wish.gap == 0.0) taken.points.push_back({wish.anchor - kPointRoom, wish.anchor + kPointRoom});
  for (const LabelWish& wish : wishes) {
    const Memory* old = remembered(wish.key);
    Memory memory = old ? *old : Memory{wish.key, {}, {}, wish.gap > 0.0 || wish.anchor.x < 0.5 * size.width};
    const auto now = old ? std::optional(Candidate{old->offset, old->right}) : std::nullopt;
    const auto chosen = choose(wish, now, memory.right, taken, size);
    if (!chosen) continue;
    memory.offset = chosen->offset;
    memory.right = chosen->right;
    const PixelBox way = both(boxAt(wish, memory.shown), boxAt(wish, memory.offset));
    if (!old || !motion || wish.gap > 0.0 || !isClear(way, taken.labels) || !mayGlide(wish, memory, wishes))
      memory.shown = memory.offset;
    const double share = std::clamp(seconds / kMoveSeconds * 2.0, 0.0, 1.0);
    memory.shown += share * (memory.offset - memory.shown);
    if (glm::length(memory.offset - memory.shown) < 0.5) memory.shown = memory.offset;
    moving_ = moving_ || memory.shown != memory.offset;
    const PixelBox box = boxAt(wish, memory.shown);
    taken.labels.push_back(both(box, boxAt(wish, memory.offset)));
    next.push_back(memory);
    result.push_back({wish.key, box, wish.anchor, memory.right});
  }
  memories_ = std::move(next);
  return result;
}

std::vector<glm::dvec2> leaderOf(const PlacedLabel& label) {
  const double y = 0.5 * (label.box.min.y + label.box.max.y);
  if (label.anchor.x > label.box.min.x && label.anchor.x < label.box.max.x)  // It is above or below.
    return {{label.anchor.x, label.anchor.y > y ? label.box.max.y : label.box.min.y}, label.anchor};
  const bool box_is_right = label.box.min.x > label.anchor.x;
  const glm::dvec2 start(box_is_right ? label.box.min.x : label.box.max.x, y);
  const double run = std::min(24.0, 0.4 * std::abs(start.x - label.anchor.x));
  return {start, {start.x + (box_is_right ? -run : run), y}, label.anchor};
}

}  // namespace hapticell::app
