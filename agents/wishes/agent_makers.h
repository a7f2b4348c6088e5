// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "agents/wishes/agent.h"

// The makers of agentKinds(), one a kind.
namespace hapticell::agents {

using MadeAgent = Expected<std::unique_ptr<Agent>>;

MadeAgent makeGoalAgent(const AgentMaking& making);
MadeAgent makeObstacleAgent(const AgentMaking& making);
MadeAgent makeLimitAgent(const AgentMaking& making);
MadeAgent makeBalanceAgent(const AgentMaking& making);
MadeAgent makeComfortAgent(const AgentMaking& making);
MadeAgent makeSightAgent(const AgentMaking& making);
MadeAgent makeReachAgent(const AgentMaking& making);
MadeAgent makeOperatorAgent(const AgentMaking& making);

}  // namespace hapticell::agents
