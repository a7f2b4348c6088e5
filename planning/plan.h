// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "planning/free_space.h"
#include "planning/problem.h"

namespace hapticell::planning {

/// How well a motion passes a pose, for Plan::X_WThrough and X_WGoal: a millimetre and a hundredth of a radian. What a
/// user takes for exact; half: slower at corners; twice: a tool visibly beside a frame.
struct Passing {
  static constexpr double kPosition = 1e-3;  ///< m
  static constexpr double kTurn = 1e-2;      ///< rad
};

/// A motion without times, free with the clearance that was asked: straight between neighbouring waypoints
/// (FreeSpace::between), first the start, last the goal.
struct Plan {
  std::vector<EntityConfiguration> waypoints;
  /// Indices of the waypoints at the poses of Problem::through.
  std::vector<std::size_t> through;
  std::vector<Pose> X_WThrough;      ///< Problem::through.
  std::optional<Pose> X_WGoal = {};  ///< Of goal::ToPose.
  std::optional<mannequin::Side> hand = {};  ///< Problem::hand
  double length = 0.0;         ///< Way of the tool (of a solid's origin), m.
  /// m, the least distance at the waypoints, up to twice the clearance that was planned with; see writtenPlanPromises().
  double clearance_min = 0.0;
  /// m: it was planned with so much more than the clearance, so that its corners may be rounded off (timedMotion()).
  double slack = 0.0;
  /// Its first and last piece may be nearer than the clearance, by LeavingRule (Problem::leaves_contact).
  bool leaves_contact = false;
};

/// Why there is no plan.
struct Failure {
  enum class Kind {
    kStart,    ///< The start is not free with this clearance.
    kReach,    ///< No joints bring the tool to the goal.
    kLimit,    ///< Only joint limits prevent it.
    kBlocked,  ///< The goal is not free: something is there.
    kNoWay,    ///< Start and goal are free, but no way was found within the checks or the time.
    kCancelled,
  };
  Kind kind = Kind::kNoWay;
  Text reason;             ///< A sentence for the user.
  std::string blocked_by;  ///< Name of the entity that blocks most; empty if none does.
  /// The reachable and free configuration nearest to the goal that was found, and its tool.
  std::optional<EntityConfiguration> nearest;
  std::optional<Pose> X_WT_nearest;
  double nearest_distance = 0.0;  ///< m between that tool's origin and the goal's.
};

/// "start", "reach", "limit", "blocked", "no_way", "cancelled".
const char* toString(Failure::Kind kind);

/// The answer to a problem. Either plan or failure is set.
struct PlanResult {
  std::optional<Plan> plan;
  std::optional<Failure> failure;
  std::size_t checks = 0;  ///< Configurations and motions checked by the search that won and what followed it.
  double seconds = 0.0;    ///< Wall time.
  std::string planner;     ///< Of the search that won: "rrt_connect".
  Text note;               ///< FreeSpace::note()
  bool isSolved() const { return plan.has_value(); }
};

/// Plans a motion. The same problem gives the same result to the bit, whatever the number of threads and the speed of
/// the machine, unless the time limit or a stop ends it. Errors: no such entity, one that cannot be planned for,
/// numbers of joints that do not fit, numbers that are not finite; a problem without a solution is a Failure. Any
/// thread.
Expected<PlanResult> plan(const Problem& problem, const config::Configuration& configuration = {});

/// The same in a space made beforehand by FreeSpace::create() for the problem's scene, entity and placements: saves
/// that time to those who plan again and again. `space` itself is not used for queries.
Expected<PlanResult> plan(const Problem& problem, const FreeSpace& space);

}  // namespace hapticell::planning
