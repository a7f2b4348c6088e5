// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "agents/runner/agent_cell.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::agents {

/// The result of one run.
struct RunResult {
  std::uint64_t number = 0;  ///< Of the run; start and goal depend on it and the seed alone.
  RunMode mode = RunMode::kBoth;
  bool solved = false;
  Text reason;               ///< Why it is not solved, and who may continue.
  double time_s = 0.0;       ///< Until it was solved or given up, virtual time.
  double way_m = 0.0;        ///< Of the moved frame.
  double remaining_m = 0.0;  ///< At the end.
  double clearance_m = 0.0;  ///< Least distance to the cell in all steps, at most 0.15.
  int deadlocks = 0;
  int plans = 0;                            ///< Ways of the planner that were followed.
  std::vector<Text> handed_over;            ///< A sentence for each deadlock.
  std::map<std::string, double> strengths;  ///< Mean strength of each agent's wishes.
  // Of a mannequin, at the end; else 0.
  int rula = 0, reba = 0;
  int rula_worst = 0;      ///< Of all steps, looked at five times a second.
  double comfort = 0.0;    ///< Share of the joints in their comfortable range.
  double balance_m = 0.0;  ///< Least margin of the centre of mass inside the soles.
  double seen = 0.0;       ///< Share of what is looked at.
};

/// How runs are made.
struct RunOptions {
  std::uint64_t seed = 1;
  std::map<std::string, double> weights = {};  ///< By agent, instead of the task's; 0: off.
  bool planner = true;  ///< Whether a deadlock that no agent takes in hand goes to the planner.
};

/// A run with its motion and the wishes of all steps.
struct RecordedRun {
  RunResult result;
  trajectory::Trajectory motion;
  std::string wishes_csv;  ///< t, and for each agent x, y, z of its arrow (m/s) and its strength.
};

/// One run; the same number, mode and options give the same bits.
RunResult runOnce(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options);
RecordedRun recordRun(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options);

/// Error where `weights` names an agent that the task does not have.
Expected<void> checkWeights(const AgentTask& task, const RunOptions& options);

/// Runs 0 to count - 1 in each mode, on `jobs` threads (0: all cores). In the order of modes, then numbers. Empty when
/// cancelled. `progress` (done, total) is called from any thread, one call at a time.
std::vector<RunResult> runAgents(const AgentCell& cell, std::uint64_t count, const std::vector<RunMode>& modes,
                                 const RunOptions& options, int jobs, const std::atomic<bool>& cancelled,
                                 const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace hapticell::agents
