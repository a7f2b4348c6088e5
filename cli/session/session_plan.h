// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/system/error.h"
#include "manipulation/session/session.h"

namespace hapticell::cli {

/// What the command session says about a planner beside the hand.
struct SessionPlanWords {
  std::string goal;   ///< "out", "frame:NAME", "pose:x,y,z,qw,qx,qy,qz", "joints:q1,q2,..."; empty: no planner.
  std::string hints;  ///< A motion (*.htraj, *.csv) whose frames a way may pass; empty: none.
};

/// Sets the planner of a session; nothing to do without a goal. `realtime`: it works in a thread of its own, else in
/// virtual time. Errors: an invalid goal, an unknown frame, a file that cannot be read, hints without a goal.
Expected<void> addPlanner(const SessionPlanWords& words, bool realtime, manipulation::SessionOptions& options);

/// "plan" of the result.
nlohmann::ordered_json planJson(const manipulation::SessionPlan& plan, const manipulation::SessionOptions& options);

}  // namespace hapticell::cli
