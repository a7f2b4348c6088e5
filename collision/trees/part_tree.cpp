// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/part_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/system/assertion.h"

namespace hapticell::collision {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// More than one unit in the last place of any float: what is moved by this share lies outside for certain.
constexpr double kOutward = 1.2e-7;
/// By which a box is kept larger than given, as a share of its half diagonal: a step of a hand (some millimetres)
/// changes nothing. Half: the tree is changed twice as often; twice: more parts that are near by their box only.
constexpr double kLarger = 0.03;

float below(double x) {
  const auto f = static_cast<float>(x);
  return f - static_cast<float>(kOutward * std::abs(x));
}
float above(double x) {
  const auto f = static_cast<float>(x);
  return f + static_cast<float>(kOutward * std::abs(x));
}

/// Half the surface.
template <typename Box>
float areaOf(const Box& box) {
  const float x = box.max[0] - box.min[0], y = box.max[1] - box.min[1], z = box.max[2] - box.min[2];
  return x * y + y * z + z * x;
}

template <typename Box, typename Other>
void include(Box& box, const Other& other) {
  for (int k = 0; k < 3; ++k) {
    box.min[k] = std::min(box.min[k], other.min[k]);
    box.max[k] = std::max(box.max[k], other.max[k]);
  }
}

template <typename Box, typename Other>
bool holds(const Box& box, const Other& other) {
  for (int k = 0; k < 3; ++k) {
    if (other.min[k] < box.min[k] || other.max[k] > box.max[k]) return false;
  }
  return true;
}

}  // namespace

QueryBounds PartTree::queryBounds(const geometry::Bounds& box_W, double margin) {
  QueryBounds bounds;
  for (int k = 0; k < 3; ++k) {
    bounds.min[k] = below(box_W.min[k] - margin);
    bounds.max[k] = above(box_W.max[k] + margin);
  }
  return bounds;
}

PartTree::Entry PartTree::entryOf(const Node& node, int lane) {
  Entry entry{};
  for (int k = 0; k < 3; ++k) {
    entry.min[k] = node.boxes.min[k][lane];
    entry.max[k] = node.boxes.max[k][lane];
  }
  entry.child = node.child[lane];
  return entry;
}

/// The node as its parent's child.
PartTree::Entry PartTree::around(const Node& node, std::uint32_t index) {
  Entry entry{};
  for (int k = 0; k < 3; ++k) {
    float least = kInfinity, most = -kInfinity;
    for (int lane = 0; lane < kWidth; ++lane) {
      least = std::min(least, node.boxes.min[k][lane]);
      most = std::max(most, node.boxes.max[k][lane]);
    }
    entry.min[k] = least;
    entry.max[k] = most;
  }
  entry.child = index;
  return entry;
}

geometry::Bounds PartTree::bounds() const {
  geometry::Bounds bounds;
  if (size_ == 0) return bounds;
  const Entry all = around(nodes_[root_], root_);
  bounds.add(dvec3(all.min[0], all.min[1], all.min[2]));
  bounds.add(dvec3(all.max[0], all.max[1], all.max[2]));
  return bounds;
}

std::uint32_t PartTree::newNode(int level) {
  std::uint32_t index;
  if (unused_.empty()) {
    index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
  } else {
    index = unused_.back();
    unused_.pop_back();
  }
  Node& node = nodes_[index];
  node.parent = kNone;
  node.lane = 0;
  node.count = 0;
  node.level = level;
  for (int lane = 0; lane < kWidth; ++lane) clearLane(index, lane);
  return index;
}

void PartTree::setLane(std::uint32_t node, int lane, const Entry& entry) {
  Node& at = nodes_[node];
  for (int k = 0; k < 3; ++k) {
    at.boxes.min[k][lane] = entry.min[k];
    at.boxes.max[k][lane] = entry.max[k];
  }
  at.child[lane] = entry.child;
  if (at.level == 0) {
    where_[entry.child] = {node, static_cast<std::uint32_t>(lane)};
  } else {
    nodes_[entry.child].parent = node;
    nodes_[entry.child].lane = static_cast<std::uint32_t>(lane);
  }
}

void PartTree::clearLane(std::uint32_t node, int lane) {
  for (int k = 0; k < 3; ++k) {
    nodes_[node].boxes.min[k][lane] = kInfinity;
    nodes_[node].boxes.max[k][lane] = -kInfinity;
  }
}

/// The node of that level whose box grows least.
std::uint32_t PartTree::chooseNode(const Entry& entry, int level) const {
  std::uint32_t at = root_;
  while (nodes_[at].level > level) {
    const Node& node = nodes_[at];
    alignas(64) float growth[kWidth], area[kWidth];
    for (int lane = 0; lane < kWidth; ++lane) {
      float size[3], grown[3];
      for (int k = 0; k < 3; ++k) {
        size[k] = node.boxes.max[k][lane] - node.boxes.min[k][lane];
        grown[k] = std::max(node.boxes.max[k][lane], entry.max[k]) - std::min(node.boxes.min[k][lane], entry.min[k]);
      }
      area[lane] = size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
      growth[lane] = grown[0] * grown[1] + grown[1] * grown[2] + grown[2] * grown[0] - area[lane];
    }
    int best = 0;
    for (int lane = 1; lane < node.count; ++lane) {
      if (growth[lane] < growth[best] || (growth[lane] == growth[best] && area[lane] < area[best])) best = lane;
    }
    at = node.child[best];
  }
  return at;
}

void PartTree::growAbove(std::uint32_t node, const Entry& entry) {
  for (std::uint32_t at = node; nodes_[at].parent != kNone; at = nodes_[at].parent) {
    const int lane = static_cast<int>(nodes_[at].lane);
    Entry whole = entryOf(nodes_[nodes_[at].parent], lane);
    if (holds(whole, entry)) return;
    include(whole, entry);
    setLane(nodes_[at].parent, lane, whole);
  }
}

void PartTree::shrinkAbove(std::uint32_t node) {
  for (std::uint32_t at = node; nodes_[at].parent != kNone; at = nodes_[at].parent) {
    const int lane = static_cast<int>(nodes_[at].lane);
    const Entry now = around(nodes_[at], at), before = entryOf(nodes_[nodes_[at].parent], lane);
    if (holds(now, before)) return;
    setLane(nodes_[at].parent, lane, now);
  }
}

void PartTree::add(std::uint32_t node, const Entry& entry) {
  if (nodes_[node].count == kWidth) return split(node, entry);
  setLane(node, nodes_[node].count++, entry);
  growAbove(node, entry);
}

/// In two, across the axis and at the place that give the least surface together.
void PartTree::split(std::uint32_t node, const Entry& extra) {
  constexpr int kAll = kWidth + 1;
  std::array<Entry, kAll> entries;
  for (int lane = 0; lane < kWidth; ++lane) entries[static_cast<std::size_t>(lane)] = entryOf(nodes_[node], lane);
  entries.back() = extra;
  std::array<std::array<int, kAll>, 3> order;
  float least = kInfinity;
  std::size_t best_axis = 0;
  int best_first = kAll / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::iota(order[axis].begin(), order[axis].end(), 0);
    const auto middle = [&](int i) {
      const Entry& entry = entries[static_cast<std::size_t>(i)];
      return entry.min[axis] + entry.max[axis];
    };
    std::sort(order[axis].begin(), order[axis].end(), [&](int a, int b) { return middle(a) < middle(b); });
    const auto in_order = [&](int i) -> const Entry& {
      return entries[static_cast<std::size_t>(order[axis][static_cast<std::size_t>(i)])];
    };
    std::array<float, kAll> area_from;
    Entry whole = in_order(kAll - 1);
    for (int i = kAll - 1; i >= 0; --i) {
      include(whole, in_order(i));
      area_from[static_cast<std::size_t>(i)] = areaOf(whole);
    }
    whole = in_order(0);
    for (int first = 1; first <= kAll - kLeastSplit; ++first) {
      include(whole, in_order(first - 1));
      if (first < kLeastSplit) continue;
      const float sum = areaOf(whole) + area_from[static_cast<std::size_t>(first)];
      if (sum >= least) continue;
      least = sum;
      best_axis = axis;
      best_first = first;
    }
  }
  const std::uint32_t other = newNode(nodes_[node].level);
  for (int lane = 0; lane < kWidth; ++lane) clearLane(node, lane);
  nodes_[node].count = 0;
  for (int i = 0; i < kAll; ++i) {
    const std::uint32_t to = i < best_first ? node : other;
    setLane(to, nodes_[to].count++, entries[static_cast<std::size_t>(order[best_axis][static_cast<std::size_t>(i)])]);
  }
  const Entry split_off = around(nodes_[other], other);
  if (nodes_[node].parent == kNone) {
    root_ = newNode(nodes_[node].level + 1);
    nodes_[root_].count = 2;
    setLane(root_, 0, around(nodes_[node], node));
    setLane(root_, 1, split_off);
    return;
  }
  // The half that stayed is smaller than before, and both together reach as far as `extra`.
  const std::uint32_t parent = nodes_[node].parent;
  setLane(parent, static_cast<int>(nodes_[node].lane), around(nodes_[node], node));
  growAbove(parent, extra);
  add(parent, split_off);
}

void PartTree::insert(const Entry& entry, int level) {
  if (root_ == kNone) root_ = newNode(0);
  add(chooseNode(entry, level), entry);
}

/// Takes what is there out of its node; the place of the last one is then free.
void PartTree::take(Place place) {
  Node& node = nodes_[place.node];
  const int last = --node.count, lane = static_cast<int>(place.lane);
  if (lane != last) setLane(place.node, lane, entryOf(node, last));
  clearLane(place.node, last);
}

/// A node without children.
void PartTree::drop(std::uint32_t node) {
  const std::uint32_t parent = nodes_[node].parent;
  unused_.push_back(node);
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  take({parent, nodes_[node].lane});
  if (nodes_[parent].count == 0) return drop(parent);
  shrinkAbove(parent);
}

void PartTree::remove(std::uint32_t part) {
  if (!contains(part)) return;
  const Place place = where_[part];
  where_[part] = {};
  --size_;
  take(place);
  const std::uint32_t leaf = place.node;
  if (nodes_[leaf].parent == kNone || nodes_[leaf].count >= kLeastLeaf) {
    if (nodes_[leaf].count == 0) return drop(leaf);
    return shrinkAbove(leaf);
  }
  std::array<Entry, kLeastLeaf> rest;
  const int count = nodes_[leaf].count;
  for (int lane = 0; lane < count; ++lane) rest[static_cast<std::size_t>(lane)] = entryOf(nodes_[leaf], lane);
  drop(leaf);
  while (root_ != kNone && nodes_[root_].level > 0 && nodes_[root_].count == 1) {
    unused_.push_back(root_);
    root_ = nodes_[root_].child[0];
    nodes_[root_].parent = kNone;
  }
  for (int i = 0; i < count; ++i) insert(rest[static_cast<std::size_t>(i)], 0);
}

void PartTree::place(std::uint32_t part, const geometry::Bounds& box_W) {
  HAPTICELL_DEMAND(!box_W.isEmpty());
  const QueryBounds exact = queryBounds(box_W, 0.0);
  const QueryBounds larger = queryBounds(box_W, kLarger * box_W.radius());
  Entry entry{};
  std::copy_n(larger.min, 3, entry.min);
  std::copy_n(larger.max, 3, entry.max);
  entry.child = part;
  if (contains(part)) {
    const Place at = where_[part];
    if (holds(entryOf(nodes_[at.node], static_cast<int>(at.lane)), exact)) return;
    // Within what its leaf covers it stays there.
    const std::uint32_t parent = nodes_[at.node].parent;
    if (parent == kNone || holds(entryOf(nodes_[parent], static_cast<int>(nodes_[at.node].lane)), entry))
      return setLane(at.node, static_cast<int>(at.lane), entry);
    remove(part);
  }
  if (where_.size() <= part) where_.resize(part + std::size_t{1});
  ++size_;
  insert(entry, 0);
}

}  // namespace hapticell::collision
