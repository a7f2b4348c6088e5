// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/runner/agent_cell.h"
#include "agents/runner/agent_loop.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::agents {

/// A run that a person watches and leads, in a thread of its own and at most as fast as real time. It begins where the
/// entity stands, without the spread of the task. Any thread may call it.
class AgentSession {
 public:
  enum class Phase {
    kPaused,
    kRunning,
    kDeadlocked,  ///< No progress; it waits for askPlanner(), takeByHand() or run().
    kPlanning,    ///< The planner is asked; a mannequin may draw back first, along the way that it came.
    kArrived,     ///< At the goal, and what is looked at is seen.
  };
  /// What there is to be shown.
  struct State {
    Phase phase = Phase::kPaused;
    Text says;  ///< The deadlock, or the planner's answer, in a sentence; else empty.
    double t = 0.0, remaining = 0.0, nearest = 0.0;  ///< s, m, m.
    manipulation::EntityConfiguration at;
    Pose X_WM;
    std::vector<ShownWish> wishes;
    std::vector<dvec3> way_W;  ///< Stops of the planner's way that is followed.
    std::size_t steps = 0;
    int deadlocks = 0, plans = 0;
  };

  AgentSession(std::shared_ptr<const AgentCell> cell, std::uint64_t seed);
  /// Waits for the step, or the plan, that is being made; a plan is cancelled.
  ~AgentSession();
  AgentSession(const AgentSession&) = delete;
  AgentSession& operator=(const AgentSession&) = delete;

  void run();
  void pause();
  /// One step, then it pauses.
  void stepOnce();
  /// From the next step on; an agent that the task does not have is no change.
  void setAgent(const std::string& name, bool enabled, double weight);
  /// What a person's hand wants of the moved frame (m/s, rad/s); it stays until the next call. Empty: the hand is away.
  void setHand(const std::optional<Twist>& velocity);
  /// Also at the deadlocks on its way, kMostPlans times in all or until the hand leads, pause() or takeByHand().
  void askPlanner();
  /// Goes on, and waits for the hand: no deadlock counts for ten seconds.
  void takeByHand();

  State state() const;
  /// Blocks until the state is as asked, at most for `seconds`; false: it is not. It is looked at after each step, plan and
  /// call; `is_so` calls nothing of the session.
  bool waitUntil(const std::function<bool(const State&)>& is_so, double seconds) const;
  /// The run so far.
  trajectory::Trajectory motion() const;
  std::string wishes() const;
  const AgentCell& cell() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace hapticell::agents
