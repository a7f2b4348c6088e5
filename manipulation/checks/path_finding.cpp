// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/path_finding.h"

#include <algorithm>
#include <array>

namespace hapticell::manipulation {

const char* toString(PathFinding::Kind kind) {
  constexpr std::array<const char*, 6> kNames{"collision",   "joint_limit", "joint_speed",
                                              "singularity", "off_pose",    "configuration"};
  return kNames[static_cast<std::size_t>(kind)];
}

void FindingList::add(PathFinding::Kind kind, const std::string& name, double t, double worst) {
  auto& open = open_[{kind, name}];
  if (!open) {
    open = PathFinding{kind, t, t, name, {}, worst, {}};
  }
  open->t_out = t;
  open->worst = std::max(open->worst, worst);
  touched_.push_back({kind, name});
}

void FindingList::endFrame(PathCheckResult& result) {
  for (auto& [key, open] : open_) {
    if (!open || std::find(touched_.begin(), touched_.end(), key) != touched_.end()) continue;
    result.findings.push_back(*open);
    open.reset();
  }
  touched_.clear();
}

}  // namespace hapticell::manipulation
