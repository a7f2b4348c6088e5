// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "agents/body/line_of_sight.h"
#include "agents/body/moved_body.h"
#include "agents/task/agent_task.h"
#include "agents/wishes/followed_way.h"

namespace hapticell::agents {

/// What agents see in a step. Everything is borrowed for the call.
struct AgentView {
  const MovedBody& body;
  std::span<const NearPair> near;  ///< All pairs within kLook of each other.
  const AgentGoal& goal;
  const LineOfSight& cell;
  double t = 0.0;    ///< s since the start.
  double dt = 0.02;  ///< s of a step.
  const FollowedWay* way = nullptr;  ///< The planner's, while one is followed; else null.
};

/// m: pairs nearer than this are measured in each step, so no agent sees farther. Half: arms run towards obstacles and
/// brake late; twice: more distances to measure.
inline constexpr double kLook = 0.15;

/// What an agent wants in a step.
struct Wish {
  std::vector<double> v;  ///< Velocities of the body's variables, rad/s or m/s; empty: nothing.
  dvec3 p_W{0.0};         ///< Where it acts, for an arrow,
  dvec3 arrow_W{0.0};     ///< and the velocity there, m/s.
};

/// One agent: a small class with one job. Belongs to one thread; what it remembers is of one run.
class Agent {
 public:
  virtual ~Agent() = default;
  /// The wish at this step. An agent that wants nothing leaves `wish` as it is.
  virtual void wish(const AgentView& view, Wish& wish) = 0;
  /// Called after a second without progress. True: this agent resolves the deadlock (the operator does).
  virtual bool onDeadlock(const AgentView& /*view*/) { return false; }
};

/// What is needed to make an agent.
struct AgentMaking {
  const AgentSection& section;
  const AgentTask& task;
  const MovedBody& body;                            ///< At the start.
  workcell::EntityId look_at = 0;                   ///< The entity of the goal's look_at; 0: none.
  std::span<const Clearances::Obstacle> obstacles;  ///< They outlive the agent.
  std::uint64_t seed = 0;
};

/// A kind of agent. A new one is one class and one line of agentKinds() (docs/library/agents.md).
struct AgentKind {
  const char* name;  ///< The value of `what`, and the name in results.
  /// Reads the section's own keys. Errors name file, line and key, or say what the entity lacks.
  Expected<std::unique_ptr<Agent>> (*make)(const AgentMaking&);
};

/// All kinds, in the order of the documentation.
std::span<const AgentKind> agentKinds();

/// An agent of a task with its switch and its weight.
struct WeightedAgent {
  std::string name;
  double weight = 1.0;
  bool enabled = true;
  std::unique_ptr<Agent> agent;
};

/// Makes the agent of a section. Errors also: an unknown kind.
Expected<WeightedAgent> makeAgent(const AgentMaking& making);

}  // namespace hapticell::agents
