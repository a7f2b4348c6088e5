// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "agents/body/moved_body.h"

namespace hapticell::agents {

/// A way that the planner found, as an attraction: the goal agent follows it stop by stop in place of the straight way.
/// A robot follows the joints of its stops, everything else their frames. One thread.
class FollowedWay {
 public:
  /// A stop; `joints` as in the body's configuration, or empty: only X_WM counts.
  struct Stop {
    Pose X_WM;
    std::vector<double> joints;
  };
  FollowedWay() = default;
  /// `with_turn`: the turns of X_WM are followed too.
  FollowedWay(std::vector<Stop> stops, bool with_turn) : stops_(std::move(stops)), with_turn_(with_turn) {}

  bool isDone() const { return next_ >= stops_.size(); }
  const std::vector<Stop>& stops() const { return stops_; }
  /// What is left, rad and m added up.
  double remaining(const MovedBody& body) const;
  /// Passes over stops that are reached.
  void update(const MovedBody& body);
  /// Velocities of the variables towards the next stop, one a variable. @pre !isDone()
  std::vector<double> velocities(const MovedBody& body, double speed, double turn_speed) const;

 private:
  double distanceTo(const Stop& stop, const MovedBody& body) const;
  std::vector<Stop> stops_;
  bool with_turn_ = false;
  std::size_t next_ = 0;
};

}  // namespace hapticell::agents
