// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "manipulation/engine/felt_plan.h"
#include "planning/live/live_planner.h"

namespace hapticell::app {

class VirtualDesktopController;

/// The planner beside the hand: its goal, start and stop, its authority, and its state in words. The planner itself
/// works in threads of its own (planning::LivePlanner). GUI thread; never waits for a search.
class PlanControl {
 public:
  /// Where an entity is to go.
  struct Target {
    workcell::EntityId entity = 0;  ///< What is to go there; the planner rests while something else is held.
    planning::Goal goal;
    Pose X_WT;     ///< The goal as it is drawn; the present pose for *out of the cell*.
    QString name;  ///< "Slot / seat"
  };

  /// The owner must outlive it.
  explicit PlanControl(VirtualDesktopController& owner);
  ~PlanControl();

  const std::optional<Target>& target() const { return target_; }
  /// Sets where to go; a planner that works begins again. None: stops.
  void setTarget(std::optional<Target> target);
  bool isOn() const { return planner_ != nullptr; }
  /// Does nothing without a target.
  void start();
  void stop();
  /// 0 .. 1; limited.
  double authority() const { return authority_; }
  void setAuthority(double authority);

  /// Posts planner and authority to the loop, if there is one: with each new loop, and as often as wanted.
  void post();
  /// What works now; in the language of the window.
  QString sentence() const;

 private:
  VirtualDesktopController& owner_;
  std::optional<Target> target_;
  std::shared_ptr<planning::LivePlanner> planner_;
  double authority_;
  double clearance_ = 0.0;  ///< m, of the planner that works.
};

/// What of a planner's work is shown.
struct PlanFacts {
  bool on = false;           ///< It was started.
  bool has_target = false;
  bool held = false;         ///< The target's entity is held.
  bool forces_on = false;
  double clearance = 0.0;    ///< m that ways keep.
  manipulation::FeltPlan::State felt;
  std::optional<Text> failure;  ///< Of the newest search, if it found none.
  QString entity, target;       ///< Their names.
};

/// The state of a planner beside the hand in one or two sentences.
QString planSentence(const PlanFacts& facts);

}  // namespace hapticell::app
