// SPDX-License-Identifier: Apache-2.0
#include "collision/trees/box_tree_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "collision/trees/box_fit.h"

namespace hapticell::collision {

namespace {

/// Places of a split that are weighed along each axis (surface area heuristic). Half: queries a little slower; twice: a
/// slower build, which has half of FCL's time to keep to (Performance).
constexpr std::size_t kMostBins = 16;
/// Below this depth nodes are halved by count, whatever the heuristic says: recursion stays under 24 + 32. Half: good
/// splits of large meshes are lost; twice: a deeper stack on hostile ones.
constexpr int kDepthOfHalving = 24;
/// A split is judged by every n-th triangle where there are more than this many, 256 a bin. Half: no worse on even
/// meshes; twice: a slower build of the upper nodes.
constexpr std::size_t kMostForSplit = 4096;
/// Subtrees of this many triangles, or a 64th of all, are built by one thread each: some ms. Half: more tasks to hand
/// out; twice: threads wait for the last one.
constexpr std::size_t kLeastTask = 8192;
/// Rounding in float, relative to the size of the whole mesh; all boxes are padded by it: 13 units of 6e-8, for some
/// sums each. Half: a box may miss its triangle; twice: boxes 1 um wider on 1 m.
constexpr float kPadding = 8e-7f;

/// A triangle and its extent along the axes of the node that is being split.
struct Projected {
  Extent extent;
  BuildItem item;
};

struct Part {
  std::size_t first = 0, count = 0;
  Extent extent;
};

struct Split {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  float below = 0.0f;  ///< Twice the middle of a triangle of the left side is less.
};

struct Task {
  std::uint32_t node = 0;
  int lane = 0;
  BuildItem* items = nullptr;
  std::size_t count = 0;
  FittedBox box;
  int depth = 0;
};

float leavesOf(std::size_t count) {
  const std::size_t leaves = (count + kLeafSize - 1) / kLeafSize;
  return static_cast<float>(leaves);
}

/// What all nodes of one build share.
struct BuildFrame {
  const geometry::TriangleMesh& mesh;
  dvec3 middle;  ///< Items are relative to this.
  float padding;
  std::size_t task_size;
  const BuildControl& control;

  bool isCancelled() const {
    return control.cancelled != nullptr && control.cancelled->load(std::memory_order_relaxed);
  }
};

class NodeBuilder {
 public:
  /// Where `tasks` is given, subtrees up to the task size are put there and not built.
  NodeBuilder(const BuildFrame& frame, TreeParts& parts, std::vector<Task>* tasks)
      : frame_(frame), parts_(parts), tasks_(tasks) {}

  /// The node over these items, whose box is given; its index.
  std::uint32_t build(BuildItem* items, std::size_t count, const FittedBox& box, int depth) {
    std::array<Part, kTreeWidth> divided;
    const int used = divide(items, count, box, depth, divided);
    const auto index = static_cast<std::uint32_t>(parts_.nodes.size());
    parts_.nodes.emplace_back(emptyNode(middleOf(box)));
    for (int lane = 0; lane < used; ++lane) {
      const Part& part = divided[static_cast<std::size_t>(lane)];
      const FittedBox fitted = fitBox(items + part.first, part.count, box.axes, part.extent);
      attach({index, lane, items + part.first, part.count, fitted, depth + 1});
    }
    return index;
  }

  /// Puts what is to be built into its lane of its node.
  void attach(const Task& task) {
    setLane(parts_.nodes[task.node], task.lane, task.box);
    if (tasks_ != nullptr && task.count <= frame_.task_size) {
      tasks_->push_back(task);
      return;
    }
    const std::uint32_t child = subtree(task);
    parts_.nodes[task.node].child[task.lane] = child;
  }

  std::uint32_t subtree(const Task& task) {
    if (frame_.isCancelled()) return BoxTree::kLeafBit;
    if (task.count > kLeafSize) return build(task.items, task.count, task.box, task.depth);
    if (frame_.control.done != nullptr) frame_.control.done->fetch_add(task.count, std::memory_order_relaxed);
    return leaf(task);
  }

  static BoxNode emptyNode(const dvec3& middle) {
    BoxNode node{};
    for (int lane = 0; lane < kTreeWidth; ++lane) {
      node.u[0][lane] = node.v[1][lane] = 1.0f;
      node.center[0][lane] = 1e18f;
      node.child[lane] = BoxTree::kLeafBit;
    }
    for (int i = 0; i < 3; ++i) node.origin[i] = static_cast<float>(middle[i]);
    return node;
  }

  dvec3 middleOf(const FittedBox& box) const {
    const Float4 middle = 0.5f * (box.extent.low + box.extent.high);
    const Float4 axes[3]{box.axes.x, box.axes.y, box.axes.z};
    dvec3 p = frame_.middle;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) p[i] += double{axes[i][k]} * double{middle[k]};
    return p;
  }

 private:
  /// The box in its lane.
  void setLane(BoxNode& node, int lane, const FittedBox& box) const {
    const dvec3 middle = middleOf(box);
    const Float4 half = 0.5f * (box.extent.high - box.extent.low) + frame_.padding;
    const Float4 axes[3]{box.axes.x, box.axes.y, box.axes.z};
    for (int i = 0; i < 3; ++i) {
      node.u[i][lane] = axes[i][0];
      node.v[i][lane] = axes[i][1];
      node.center[i][lane] = static_cast<float>(middle[i] - double{node.origin[i]});
      node.half[i][lane] = half[i];
    }
    node.count = std::max(node.count, static_cast<std::uint32_t>(lane + 1));
  }

  std::uint32_t leaf(const Task& task) {
    LeafBlock block{};
    const dvec3 middle = middleOf(task.box);
    for (int i = 0; i < 3; ++i) block.origin[i] = static_cast<float>(middle[i]);
    block.count = static_cast<std::uint32_t>(task.count);
    for (int lane = 0; lane < kLeafSize; ++lane) {
      const std::size_t from = std::min(static_cast<std::size_t>(lane), task.count - 1);
      const std::uint32_t triangle = task.items[from].triangle;
      block.triangle[lane] = triangle;
      const int widest = widestCorner(triangle);
      for (int c = 0; c < 3; ++c) {
        const dvec3 p = frame_.mesh.corner(triangle, (widest + c) % 3);
        for (int i = 0; i < 3; ++i) block.corner[3 * c + i][lane] = static_cast<float>(p[i] - double{block.origin[i]});
      }
    }
    parts_.leaves.push_back(block);
    return static_cast<std::uint32_t>(parts_.leaves.size() - 1) | BoxTree::kLeafBit;
  }

  /// The corner that faces the longest edge.
  int widestCorner(std::uint32_t triangle) const {
    int widest = 0;
    double longest = -1.0;
    for (int i = 0; i < 3; ++i) {
      const dvec3 side = frame_.mesh.corner(triangle, (i + 2) % 3) - frame_.mesh.corner(triangle, (i + 1) % 3);
      if (glm::dot(side, side) <= longest) continue;
      longest = glm::dot(side, side);
      widest = i;
    }
    return widest;
  }

  /// Sorts the items into up to eight parts that follow each other.
  int divide(BuildItem* items, std::size_t count, const FittedBox& box, int depth,
             std::array<Part, kTreeWidth>& parts) {
    projected_.resize(std::max(projected_.size(), count));
    for (std::size_t i = 0; i < count; ++i) projected_[i] = {extentOf(items[i], box.axes), items[i]};
    parts[0] = {0, count, box.extent};
    int used = 1;
    while (used < kTreeWidth) {
      const int widest = nextToSplit(parts, used);
      if (widest < 0) break;
      Part& part = parts[static_cast<std::size_t>(widest)];
      parts[static_cast<std::size_t>(used++)] = splitOff(part, depth);
    }
    for (std::size_t i = 0; i < count; ++i) items[i] = projected_[i].item;
    return used;
  }

  /// The largest part of those that need more than a node below; if there is no such part, the one that needs the
  /// fewest leaves, so that nodes are filled. -1 when all are leaves.
  static int nextToSplit(const std::array<Part, kTreeWidth>& parts, int used) {
    int largest = -1, fewest = -1;
    for (int i = 0; i < used; ++i) {
      const Part& part = parts[static_cast<std::size_t>(i)];
      if (part.count <= kLeafSize) continue;
      const auto better = [&](int than, auto measure) {
        return than < 0 || measure(part) > measure(parts[static_cast<std::size_t>(than)]);
      };
      if (part.count > std::size_t{kLeafSize} * kTreeWidth) {
        if (better(largest, [](const Part& p) { return p.extent.surface(); })) largest = i;
      } else if (better(fewest, [](const Part& p) { return -leavesOf(p.count); })) {
        fewest = i;
      }
    }
    return largest >= 0 ? largest : fewest;
  }

  /// Takes the right side off a part and returns it; neither is empty.
  Part splitOff(Part& part, int depth) {
    Projected* begin = &projected_[part.first];
    Projected* end = begin + part.count;
    const Split split = depth < kDepthOfHalving ? bestSplit(part) : Split{};
    Projected* middle = begin;
    if (split.axis >= 0) {
      middle = std::partition(begin, end, [&](const Projected& p) {
        return p.extent.low[split.axis] + p.extent.high[split.axis] < split.below;
      });
    }
    if (middle == begin || middle == end) middle = halved(part, begin, end);
    const auto left = static_cast<std::size_t>(middle - begin);
    Part right{part.first + left, part.count - left, {}};
    part.count = left;
    part.extent = extentOfProjected(part);
    right.extent = extentOfProjected(right);
    return right;
  }

  static Projected* halved(const Part& part, Projected* begin, Projected* end) {
    const Float4 size = part.extent.high - part.extent.low;
    int axis = size[0] >= size[1] ? 0 : 1;
    if (size[2] > size[axis]) axis = 2;
    // Whole leaves on the left.
    const std::size_t half = (part.count / 2 + kLeafSize - 1) / kLeafSize * kLeafSize;
    Projected* middle = begin + std::min(half, part.count - 1);
    std::nth_element(begin, middle, end, [axis](const Projected& a, const Projected& b) {
      const float x = a.extent.low[axis] + a.extent.high[axis], y = b.extent.low[axis] + b.extent.high[axis];
      return x != y ? x < y : a.item.triangle < b.item.triangle;
    });
    return middle;
  }

  Extent extentOfProjected(const Part& part) const {
    Extent extent;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) extent.add(projected_[i].extent);
    return extent;
  }

  struct Bin {
    Extent extent;
    std::size_t count = 0;
  };

  Split bestSplit(const Part& part) const {
    const std::size_t stride = part.count / kMostForSplit + 1;
    const std::size_t bins = part.count <= 16 ? 8 : kMostBins;
    const Float4 low = 2.0f * part.extent.low, size = 2.0f * (part.extent.high - part.extent.low);
    Float4 scale;
    for (int i = 0; i < 4; ++i) scale[i] = i < 3 && size[i] > 0.0f ? static_cast<float>(bins) / size[i] : 0.0f;
    Bin table[3][kMostBins];
    for (std::size_t i = part.first; i < part.first + part.count; i += stride) {
      const Extent& extent = projected_[i].extent;
      const Float4 where = (extent.low + extent.high - low) * scale;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at =
            static_cast<std::size_t>(std::clamp(static_cast<int>(where[axis]), 0, static_cast<int>(bins) - 1));
        table[axis][at].extent.add(extent);
        ++table[axis][at].count;
      }
    }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (scale[axis] == 0.0f) continue;
      const std::size_t before = sweep(table[axis], bins, best);
      if (before == 0) continue;
      best.axis = axis;
      best.below = low[axis] + static_cast<float>(before) / scale[axis];
    }
    return best;
  }

  /// The number of bins left of the best place, when that is better than `best`; else 0.
  static std::size_t sweep(const Bin* table, std::size_t bins, Split& best) {
    std::array<float, kMostBins + 1> above{};
    Extent extent;
    std::size_t count = 0;
    for (std::size_t i = bins - 1; i > 0; --i) {
      extent.add(table[i].extent);
      count += table[i].count;
      above[i] = count == 0 ? std::numeric_limits<float>::infinity() : extent.surface() * leavesOf(count);
    }
    extent = {};
    count = 0;
    std::size_t found = 0;
    for (std::size_t i = 1; i < bins; ++i) {
      extent.add(table[i - 1].extent);
      count += table[i - 1].count;
      if (count == 0) continue;
      const float cost = extent.surface() * leavesOf(count) + above[i];
      if (cost >= best.cost) continue;
      best.cost = cost;
      found = i;
    }
    return found;
  }

  const BuildFrame& frame_;
  TreeParts& parts_;
  std::vector<Task>* tasks_;
  std::vector<Projected> projected_;
};

std::vector<BuildItem> itemsOf(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
                               const dvec3& middle) {
  std::vector<BuildItem> items(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    items[i].triangle = triangles[i];
    for (int c = 0; c < 3; ++c) {
      const dvec3 p = mesh.corner(triangles[i], c) - middle;
      for (int k = 0; k < 3; ++k) items[i].corner[3 * c + k] = static_cast<float>(p[k]);
    }
  }
  return items;
}

/// Runs the tasks, each into parts of its own, so that nothing depends on who ran which.
std::vector<TreeParts> runTasks(const BuildFrame& frame, const std::vector<Task>& tasks,
                                std::vector<std::uint32_t>& children) {
  std::vector<TreeParts> results(tasks.size());
  children.resize(tasks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      NodeBuilder builder(frame, results[i], nullptr);
      children[i] = builder.subtree(tasks[i]);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < frame.control.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return results;
}

/// Appends a task's nodes and leaves, and shifts their indices.
void append(TreeParts& whole, TreeParts& part, const Task& task, std::uint32_t child) {
  const auto nodes = static_cast<std::uint32_t>(whole.nodes.size()),
             leaves = static_cast<std::uint32_t>(whole.leaves.size());
  const auto shifted = [&](std::uint32_t index) { return index + (BoxTree::isLeaf(index) ? leaves : nodes); };
  for (BoxNode& node : part.nodes) {
    for (std::uint32_t lane = 0; lane < node.count; ++lane) node.child[lane] = shifted(node.child[lane]);
  }
  whole.nodes[task.node].child[task.lane] = shifted(child);
  whole.nodes.insert(whole.nodes.end(), part.nodes.begin(), part.nodes.end());
  whole.leaves.insert(whole.leaves.end(), part.leaves.begin(), part.leaves.end());
  part = {};
}

}  // namespace

TreeParts buildTree(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
                    const BuildControl& control) {
  geometry::Bounds bounds;
  for (const std::uint32_t t : triangles) {
    for (int c = 0; c < 3; ++c) bounds.add(mesh.corner(t, c));
  }
  const BuildFrame frame{mesh, bounds.center(), kPadding * static_cast<float>(bounds.radius()),
                         std::max(kLeastTask, triangles.size() / 64), control};
  std::vector<BuildItem> items = itemsOf(mesh, triangles, frame.middle);
  TreeParts whole;
  std::vector<Task> tasks;
  NodeBuilder builder(frame, whole, &tasks);
  whole.nodes.push_back(NodeBuilder::emptyNode(frame.middle));
  Extent extent;
  for (const BuildItem& item : items) extent.add(extentOf(item, {}));
  builder.attach({0, 0, items.data(), items.size(), fitBox(items.data(), items.size(), {}, extent), 0});
  std::vector<std::uint32_t> children;
  std::vector<TreeParts> results = runTasks(frame, tasks, children);
  for (std::size_t i = 0; i < tasks.size(); ++i) append(whole, results[i], tasks[i], children[i]);
  if (frame.isCancelled()) return {};
  return whole;
}

}  // namespace hapticell::collision
