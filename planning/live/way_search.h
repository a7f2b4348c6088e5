// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "manipulation/engine/plan_source.h"
#include "planning/live/live_planner.h"

namespace hapticell::planning {

/// One search of a LivePlanner: from the newest state of the hand to a way of the moved frame. Keeps the space of its
/// scene between searches; for a mannequin it is made from each posture. One thread.
class WaySearch {
 public:
  WaySearch(const LiveOptions& options, const config::Configuration& configuration)
      : options_(options), configuration_(configuration) {}

  struct Found {
    PlanResult result;
    std::vector<Pose> X_WM;     ///< Empty: no way.
    std::vector<EntityConfiguration> postures;  ///< As PlannedWay::postures.
    double length = 0.0;        ///< m, with 0.1 m a radian.
    std::uint64_t answers = 0;  ///< As PlannedWay::answers,
    std::uint64_t hold = 0;     ///< and as PlannedWay::hold.
    std::vector<EntityConfiguration> waypoints;  ///< Of it, from where the entity stood; straight between.
    Pose X_TM;                                   ///< The moved frame in the tool's (of a solid: its own) frame.
  };
  /// `stop` ends it early, without a way.
  Found find(const manipulation::PlanView& view, const std::atomic<bool>* stop);

  /// Lets a way begin where the entity is by now: straight onto it as far on as that is free, or back along the trail.
  /// Contract: `now` is of the hold that the way was searched for.
  void join(Found& found, const manipulation::PlanView& now);

  /// Of the space that was made last; null before the first search.
  const FreeSpace* space() const { return space_ ? &*space_ : nullptr; }

 private:
  Expected<void> prepare(const manipulation::PlanView& view);
  std::optional<EntityConfiguration> freeStart(const EntityConfiguration& at);
  std::vector<EntityConfiguration> startOf(const manipulation::PlanView& view);
  std::optional<Pose> passedByHand(const manipulation::PlanView& view, const EntityConfiguration& start);
  std::vector<EntityConfiguration> hintsFor(const manipulation::PlanView& view) const;
  void sample(Found& found) const;

  const LiveOptions options_;
  const config::Configuration configuration_;
  std::shared_ptr<const manipulation::PreparedScene> scene_;
  workcell::EntityId entity_ = 0;
  std::optional<mannequin::Side> hand_;
  std::optional<FreeSpace> space_;
  std::uint64_t searches_ = 0;
};

}  // namespace hapticell::planning
