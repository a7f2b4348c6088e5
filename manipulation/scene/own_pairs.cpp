// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/own_pairs.h"

#include <algorithm>
#include <set>

namespace hapticell::manipulation {

namespace {

using LinkPair = std::pair<int, int>;

LinkPair ordered(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

std::vector<OwnPair> ownPairs(const kinematics::RobotModel& model, std::span<const OwnPart> parts) {
  const std::vector<int> body = kinematics::rigidBodies(model);
  const auto bodyOf = [&](int link) { return body[static_cast<std::size_t>(link)]; };
  std::set<LinkPair> disabled, joined;
  for (const kinematics::DisabledPair& pair : model.disabled_pairs) disabled.insert(ordered(pair.first, pair.second));
  for (const kinematics::Joint& joint : model.joints) {
    joined.insert(ordered(bodyOf(joint.parent_link), bodyOf(joint.child_link)));
  }
  std::vector<OwnPair> pairs;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      const int a = bodyOf(parts[i].link), b = bodyOf(parts[k].link);
      if (a == b || (parts[i].carried && parts[k].carried)) continue;
      const bool own = !parts[i].carried && !parts[k].carried;
      const bool left_out = joined.count(ordered(a, b)) || disabled.count(ordered(parts[i].link, parts[k].link));
      if (!own || !left_out) pairs.push_back({i, k});
    }
  }
  return pairs;
}

}  // namespace hapticell::manipulation
