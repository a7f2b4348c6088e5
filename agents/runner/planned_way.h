// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "agents/runner/agent_cell.h"
#include "agents/wishes/followed_way.h"

namespace hapticell::agents {

/// Ways that are asked for in a row. Half: gives up where the third way works; twice: no more runs are solved.
inline constexpr int kMostPlans = 6;

/// m to draw back along the way that it came, before the planner is asked once more: after the first way that led to
/// nothing, and ever farther. Only for a mannequin, whose body may be caught where the way of its hand is free; 0 for the
/// others, whose ways begin exactly where they are.
double backBeforePlan(const MovedBody& body, int plans_before);

/// What the planner answered to agents that are stuck.
struct PlannedWay {
  std::optional<FollowedWay> way;
  Text why;  ///< Why there is no way; empty with one.
};

/// Asks `planning/` for a way from where the body is to the goal. Robots are planned by joints, solids by pose. For a
/// mannequin a ball as large as its hand is planned for, from where it is or, where it is caught, from a place on the way
/// back; the body follows, so a way of the hand may still be none for the arm. Clearance of the others: the task's, or
/// half of it, or none, the first that has a way; what is followed keeps the task's whatever the way has. The same arguments give the same way. Any thread; `stop` may be null.
PlannedWay planWay(const AgentCell& cell, const MovedBody& body, const AgentGoal& goal, std::uint64_t seed,
                   const std::atomic<bool>* stop = nullptr);

}  // namespace hapticell::agents
