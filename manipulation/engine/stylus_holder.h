// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/contact_watch.h"
#include "manipulation/engine/felt_guides.h"
#include "manipulation/engine/felt_plan.h"
#include "manipulation/engine/hand_mapping.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/result_log.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/engine/set_scheduler.h"
#include "manipulation/engine/snapshot_maker.h"
#include "manipulation/engine/stylus_grip.h"
#include "manipulation/engine/stylus_input.h"
#include "manipulation/engine/take_recording.h"

namespace hapticell::manipulation {

/// One stylus in a cell: the held entity follows it, and its contacts are felt. An engine steps one, or two in the same
/// cell. Manipulation thread only.
class StylusHolder {
 public:
  /// `link` and `cell` must outlive it.
  StylusHolder(haptic::HapticLink& link, CellState& cell);
  StylusHolder(const StylusHolder&) = delete;
  StylusHolder& operator=(const StylusHolder&) = delete;

  /// See ManipulationEngine::searchInThread().
  void searchInThread() { grip_.searchInThread(); }
  /// Executes a command for one stylus; the engine executes those for the cell.
  void apply(const Command& command);
  /// The cell has a new scene. A held entity stays held if it still exists.
  void takeScene();

  /// A step consists of these calls in order: takes the newest state of the stylus, then its buttons, ...
  void takeState();
  /// Contract: there is a state. `recording`: the second button may mark its frames.
  void watchButtons(TakeRecording& recording);
  /// Drift at the edge of the workspace. Contract: there is a state.
  void driftAtEdge();
  /// ... moves the held entity and sends the next set. Contract: there is a state.
  void follow(const ScriptedEntities& scripted);

  void grab(workcell::EntityId wanted);
  void release();
  /// Takes the held entity again at its present placement.
  void retake();
  /// Lets something else move the held entity's joints; takes the entity again if necessary. False: impossible.
  bool yieldJoints();
  /// An entity moved by others has a new placement; its way was free. Returns true if that changes something here.
  bool placeOther(workcell::EntityId id, const EntityConfiguration& at);
  /// If another stylus holds the same entity, or one that moves with it, releases it and reports that. Two styluses may
  /// hold the two hands of one mannequin.
  void letGoOfWhatOtherHolds();
  /// The other hand has moved the entity that both hold: follows as far as the exact check finds the way free.
  void followOther(const EntityConfiguration& at);
  /// Others moved the held entity or an obstacle, so the set is out of date.
  void wantSetForOthers() { sets_.wantForOthers(cell_.clock().now()); }
  /// The set's assumptions are no longer valid.
  void wantSet() { sets_.want(); }

  const CellState& cell() const { return cell_; }
  const PreparedScene* scene() const { return cell_.scene().get(); }
  StylusGrip& grip() { return grip_; }
  const StylusGrip& grip() const { return grip_; }
  const HeldEntity* held() const { return grip_.held(); }
  EntityConfiguration placement(workcell::EntityId entity) const { return grip_.placement(entity); }
  const StylusInput& input() const { return input_; }
  const ContactWatch& contacts() const { return contacts_; }
  /// The planner beside the hand, as it is felt.
  const FeltPlan::State& plan() const { return plan_.state(); }
  const SetScheduler& sets() const { return sets_; }
  ResultLog& log() { return log_; }
  std::vector<Result> takeResults() { return log_.take(); }
  /// See ManipulationEngine::nearLimits().
  std::vector<LimitState> nearLimits() const;
  /// This stylus for a take.
  TakeRecording::Hand hand() const;

  /// Adds what it holds and feels to an empty snapshot, and the status sentence.
  void addTo(SceneSnapshot& snapshot);
  void describe(SceneSnapshot& snapshot) const { snapshots_.describe(input_, grip_, snapshot); }

 private:
  bool hold(workcell::EntityId entity);
  void forgetFelt();
  void anchor();
  void updateMapping();
  void setClutched(bool clutched);
  void updateLoad();
  void noticeSimplifiedContacts();
  Pose frameOfAxes();

  CellState& cell_;
  ResultLog log_;
  StylusInput input_;
  HandMapping hand_;
  StylusGrip grip_;
  FeltGuides guides_;
  FeltPlan plan_;
  ContactWatch contacts_;
  SetScheduler sets_;
  SnapshotMaker snapshots_;
  bool stopped_ = false;
  int hurried_joint_ = -1;  ///< Joint that moves at its greatest speed and has not arrived; -1: no such joint.
};

}  // namespace hapticell::manipulation
