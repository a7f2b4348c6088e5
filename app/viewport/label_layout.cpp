// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/label_layout.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

constexpr double kMoveSeconds = 0.12;
constexpr double kBorder = 8.0;
constexpr double kPointRoom = 16.0;  // Free room round the point itself.

PixelBox boxAt(const LabelWish& wish, const glm::dvec2& offset) {
  return {wish.anchor + offset, wish.anchor + offset + wish.size};
}

bool fits(const PixelBox& box, const LabelWish& wish, const std::vector<PixelBox>& taken, const ViewSize& size) {
  if (box.min.x < kBorder || box.min.y < kBorder || box.max.x > size.width - kBorder ||
      box.max.y > size.height - kBorder)
    return false;
  const PixelBox point{wish.anchor - kPointRoom, wish.anchor + kPointRoom};
  if (box.overlaps(point)) return false;
  return std::none_of(taken.begin(), taken.end(), [&](const PixelBox& other) { return box.overlaps(other); });
}

struct Candidate {
  glm::dvec2 offset;
  bool right;
};

/// Places from near to far; the wanted side first.
std::vector<Candidate> candidates(const LabelWish& wish, bool right_first) {
  std::vector<Candidate> result;
  for (const double gap : {70.0, 110.0, 170.0, 250.0})
    for (const bool right : {right_first, !right_first})
      for (const double rise : {-0.5, -1.6, 0.6, -2.8, 1.8})
        result.push_back({{right ? gap : -gap - wish.size.x, rise * wish.size.y}, right});
  return result;
}

}  // namespace

std::vector<PlacedLabel> LabelLayout::place(const std::vector<LabelWish>& wishes,
                                            const std::vector<PixelBox>& keep_free, const ViewSize& size,
                                            double seconds, bool motion) {
  std::vector<PixelBox> taken = keep_free;
  std::vector<Memory> next;
  std::vector<PlacedLabel> result;
  moving_ = false;
  // The labels' own points are kept free for all of them.
  for (const LabelWish& wish : wishes) taken.push_back({wish.anchor - kPointRoom, wish.anchor + kPointRoom});
  for (const LabelWish& wish : wishes) {
    const auto old =
        std::find_if(memories_.begin(), memories_.end(), [&](const Memory& m) { return m.key == wish.key; });
    const bool known = old != memories_.end();
    Memory memory;
    memory.key = wish.key;
    if (known) memory = *old;
    if (!known) memory.right = wish.anchor.x < 0.5 * size.width;
    if (!known || !fits(boxAt(wish, memory.offset), wish, taken, size)) {
      const std::vector<Candidate> places = candidates(wish, memory.right);
      const auto good = std::find_if(places.begin(), places.end(), [&](const Candidate& c) {
        return fits(boxAt(wish, c.offset), wish, taken, size);
      });
      const Candidate& chosen = good != places.end() ? *good : places.front();
      memory.offset = chosen.offset;
      memory.right = chosen.right;
    }
    if (!known || !motion) memory.shown = memory.offset;
    const double share = std::clamp(seconds / kMoveSeconds * 2.0, 0.0, 1.0);
    memory.shown += share * (memory.offset - memory.shown);
    if (glm::length(memory.offset - memory.shown) < 0.5) memory.shown = memory.offset;
    moving_ = moving_ || memory.shown != memory.offset;
    const PixelBox box = boxAt(wish, memory.shown);
    taken.push_back(boxAt(wish, memory.offset));
    next.push_back(memory);
    result.push_back({wish.key, box, wish.anchor, memory.right});
  }
  memories_ = std::move(next);
  return result;
}

std::vector<glm::dvec2> leaderOf(const PlacedLabel& label) {
  const double y = 0.5 * (label.box.min.y + label.box.max.y);
  const bool box_is_right = label.box.min.x > label.anchor.x;
  const glm::dvec2 start(box_is_right ? label.box.min.x : label.box.max.x, y);
  const double run = std::min(24.0, 0.4 * std::abs(start.x - label.anchor.x));
  return {start, {start.x + (box_is_right ? -run : run), y}, label.anchor};
}

}  // namespace hapticell::app
