// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "agents/task/agent_section.h"
#include "agents/wishes/agent_makers.h"
#include "geometry/system/listed.h"

namespace hapticell::agents {

std::span<const AgentKind> agentKinds() {
  static constexpr AgentKind kKinds[] = {
      {"goal", makeGoalAgent},       {"obstacles", makeObstacleAgent}, {"limits", makeLimitAgent},
      {"balance", makeBalanceAgent}, {"comfort", makeComfortAgent},    {"sight", makeSightAgent},
      {"reach", makeReachAgent},     {"operator", makeOperatorAgent},
  };
  return kKinds;
}

Expected<WeightedAgent> makeAgent(const AgentMaking& making) {
  const AgentSection& section = making.section;
  const auto kinds = agentKinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const AgentKind& one) { return section.kind == one.name; });
  if (kind == kinds.end()) {
    const std::string known = listed(kinds, [](const AgentKind& one) { return std::string(one.name); });
    return makeError(section.fault(Text("what = \"%1\"", section.kind), Text("one of %1", known)));
  }
  auto agent = kind->make(making);
  HAPTICELL_TRY(agent);
  return WeightedAgent{section.kind, section.weight, section.enabled, std::move(*agent)};
}

}  // namespace hapticell::agents
