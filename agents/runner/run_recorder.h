// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "agents/runner/agent_cell.h"
#include "agents/runner/agent_loop.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::agents {

/// The motion of a run and the wishes of all its steps: a mannequin as a whole, with all joints; a robot by its tool; a
/// solid by its middle. One thread.
class RunRecorder {
 public:
  explicit RunRecorder(const AgentCell& cell);
  /// The configuration now.
  void add(const AgentLoop& loop);
  /// The wishes of the last step.
  void addWishes(const AgentLoop& loop);
  const trajectory::Trajectory& motion() const { return motion_; }
  /// t, and for each agent x, y, z of its arrow (m/s) and its strength; CSV.
  const std::string& wishes() const { return csv_; }

 private:
  trajectory::Trajectory motion_;
  std::string csv_;
  bool whole_ = false;
};

}  // namespace hapticell::agents
