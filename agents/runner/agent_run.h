// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "agents/runner/agent_loop.h"
#include "agents/runner/agent_runs.h"
#include "agents/runner/deadlock_watch.h"

namespace hapticell::agents {

/// One seeded run, step by step. One thread.
class AgentRun {
 public:
  AgentRun(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options);

  const AgentLoop& loop() const { return loop_; }
  /// One step; false once it is over.
  bool step();
  /// When it is over.
  RunResult finish();

 private:
  void judge();
  void look();
  void onDeadlock();
  bool giveToAgent();
  void askPlanner();
  void giveUp(const Text& why);
  bool followPlan(Text& why);
  double remaining() const;

  const AgentCell& cell_;
  RunMode mode_;
  std::uint64_t seed_;
  bool planner_;
  bool on_way_ = false, drew_back_ = false;
  int plans_asked_ = 0;
  RunResult result_;
  AgentLoop loop_;
  DeadlockWatch watch_;
  bool over_ = false;
  int steps_ = 0;
  // At the last deadlock.
  Text::Length left_;
  Text nearest_;
};

}  // namespace hapticell::agents
