// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "agents/task/section_reader.h"
#include "agents/wishes/agent_makers.h"

namespace hapticell::agents {

/// The error if an agent for mannequins is used with another kind of entity.
inline Expected<void> needFigure(const AgentMaking& making) {
  if (making.body.figure() != nullptr) return {};
  return makeError(making.section.fault(Text("the entity '%1' is no mannequin", making.task.entity),
                                        Text("a mannequin"), Text("Remove this agent from the task.")));
}

/// One number a variable, by the region of the body: place and turn of the pelvis, spine, arms, neck.
inline std::vector<double> byRegion(const MovedBody& body, const std::array<double, 5>& values) {
  std::vector<double> all(body.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = values[static_cast<std::size_t>(regionOf(v))];
  return all;
}

}  // namespace hapticell::agents
