// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "agents/runner/agent_runs.h"

namespace hapticell::cli {

/// A run as JSON: `run`, `mode`, `solved`, `reason`, `time_s`, ...; of a mannequin also its scores.
nlohmann::ordered_json runJson(const agents::AgentCell& cell, const agents::RunResult& run);

/// A mode's runs in figures: `solved` of `runs`, medians of those that are solved, least clearance of all, deadlocks.
nlohmann::ordered_json summaryOf(const agents::AgentCell& cell, agents::RunMode mode,
                                 const std::vector<agents::RunResult>& runs);

}  // namespace hapticell::cli
