// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "agents/task/agent_task.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// What the user chose for a run of agents.
struct AgentSetup {
  workcell::EntityId entity = 0;
  bool left_hand = false;          ///< Of a mannequin.
  dvec3 p_WG{0.0};                 ///< m
  workcell::EntityId look_at = 0;  ///< What a mannequin's eyes must see at the end; 0: nothing.
  double clearance = 0.004;        ///< m
};

/// Whether agents can move it; mere shapes without a mesh, frames and locked entities they cannot.
bool canBeMovedByAgents(const workcell::Entity& entity);
/// The kinds of agents that suit it, in the order of the documentation.
std::vector<std::string> agentKindsFor(const workcell::Entity& entity);
/// The middle of an entity's shape in the cell; a robot's or mannequin's: of its frame.
dvec3 middleOf(const workcell::Entity& entity);
/// Name of an agent for the user.
QString agentName(const std::string& kind);

/// The task of a setup, as its file would say it. Errors: an entity that is not there.
Expected<agents::AgentTask> taskOf(const AgentSetup& setup, const workcell::DocumentState& state);

}  // namespace hapticell::app
