// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "config/configuration.h"
#include "manipulation/engine/plan_source.h"
#include "planning/plan.h"

namespace hapticell::planning {

/// Settings of a planner that works while the hand moves the entity.
struct LiveOptions {
  Goal goal;
  double clearance = 0.002;      ///< m that a way keeps from everything.
  std::vector<Pose> hints = {};  ///< Poses of the tool (of a solid: of its frame) that a way may pass, as from frames
                                 ///< of a recording.
  std::uint64_t seed = 1;
  double period_s = 0.1;             ///< s from the end of one search to the start of the next one.
  std::size_t most_checks = 20'000;  ///< Problem::most_checks of a search.
  double most_seconds = 5.0;         ///< Wall time of one search; not in virtual time, where its checks alone end it.
  /// True: look() itself searches, and the path becomes available after `cost_s` of the search, in seconds of the
  /// loop's clock. The same motion of the hand then gives the same paths.
  bool in_virtual_time = false;
  /// s that a search counts for in virtual time; empty: its checks at 20 us each.
  std::function<double(const PlanResult&)> cost_s = {};
};

/// Plans the held entity's way to a goal again and again from where it is, and gives the newest one that is worth a
/// change.
///
/// A way stays as long as it is followed, unless a new one is a fifth shorter. If the hand insists on another way, the
/// next plan must pass a place towards which the hand pushes; where the hand has been is given to every search as a
/// hint. A robot is planned for by its joints if the hand holds its tool, a mannequin by its posture if the hand holds
/// one of its hands. A start that is nearer to something than the
/// clearance is left first. Calls of PlanSource by the manipulation thread; the figures by any thread.
class LivePlanner final : public manipulation::PlanSource {
 public:
  /// Starts the thread, unless in virtual time.
  explicit LivePlanner(LiveOptions options, const config::Configuration& configuration = {});
  /// Stops a running search and joins the thread.
  ~LivePlanner() override;
  LivePlanner(const LivePlanner&) = delete;
  LivePlanner& operator=(const LivePlanner&) = delete;

  void look(const manipulation::PlanView& view) override;
  std::shared_ptr<const manipulation::PlannedWay> newest() override;
  bool isReached(const manipulation::PlanView& view) const override;

  /// What happened so far.
  struct Figures {
    std::uint64_t searches = 0;      ///< Ended searches,
    std::uint64_t found = 0;         ///< those that found a way,
    std::uint64_t given = 0;         ///< and the ways that were given to the hand.
    double seconds = 0.0;            ///< Wall time of all searches.
    std::optional<Failure> failure;  ///< Of the newest search, if it found none.
  };
  Figures figures() const;

 private:
  struct Worker;
  std::unique_ptr<Worker> worker_;
};

/// True at the goal: within 2 mm and 2 degrees of a pose, within 0.02 rad (or 2 mm) of joints, in the region; outside
/// of `obstacles` (FreeSpace::obstacleBounds) by the margin with all of a sphere of `radius` around X_WT.
bool isAtGoal(const Goal& goal, const Pose& X_WT, const std::vector<double>& joints, const geometry::Bounds& obstacles,
              double radius);

}  // namespace hapticell::planning
