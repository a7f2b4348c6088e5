// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/unfolding.h"

#include <algorithm>
#include <utility>

namespace hapticell::geometry {

namespace {

enum class State : std::uint8_t { kNew, kOpen, kDone };

struct Node {
  State state = State::kNew;
  int depth = 0;            ///< Levels from it downwards, itself one; of those that are done.
  std::uint64_t count = 0;  ///< Nodes that it unfolds to, itself one.
};

struct Step {
  std::uint32_t node = 0;
  std::size_t next = 0;  ///< Among those below it.
};

constexpr std::uint64_t kEndless = std::uint64_t{1} << 60;

}  // namespace

Expected<void> checkUnfolding(const std::vector<std::vector<std::uint32_t>>& below,
                              const std::vector<std::uint32_t>& roots, const UnfoldingLimits& limits,
                              const std::function<Text(std::uint32_t)>& place_of) {
  const std::uint64_t most = std::max<std::uint64_t>(limits.most, 20 * below.size());
  const auto refuse = [&](std::uint32_t node, Text found, Text expected) {
    return makeError({.place = place_of(node),
                      .found = std::move(found),
                      .expected = std::move(expected),
                      .fix = "Export it again."});
  };
  std::vector<Node> nodes(below.size());
  std::vector<Step> way;
  std::uint64_t all = 0;
  for (const std::uint32_t root : roots) {
    if (root >= nodes.size()) continue;
    if (nodes[root].state == State::kNew) way.push_back({root, 0});
    while (!way.empty()) {
      Step& step = way.back();
      Node& node = nodes[step.node];
      node.state = State::kOpen;
      if (step.next == below[step.node].size()) {
        node.state = State::kDone;
        node.count = 1;
        for (const std::uint32_t child : below[step.node]) {
          if (child >= nodes.size()) continue;
          node.count = std::min(kEndless, node.count + nodes[child].count);
          node.depth = std::max(node.depth, nodes[child].depth);
        }
        if (++node.depth > limits.deepest)
          return refuse(step.node, Text("more than %1 nested levels", limits.deepest), Text("a tree without cycles"));
        way.pop_back();
        continue;
      }
      const std::uint32_t child = below[step.node][step.next++];
      if (child >= nodes.size() || nodes[child].state == State::kDone) continue;
      if (nodes[child].state == State::kOpen)
        return refuse(child, Text("it contains itself"), Text("a tree without cycles"));
      way.push_back({child, 0});
    }
    all = std::min(kEndless, all + nodes[root].count);
    if (all > most) return refuse(root, Text("it expands to more than %1 nodes", most), Text("fewer repeated nodes"));
  }
  return {};
}

}  // namespace hapticell::geometry
