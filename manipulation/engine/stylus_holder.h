// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/contact_watch.h"
#include "manipulation/engine/felt_guides.h"
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

/// One stylus in a cell: what it holds follows it, and what that meets is felt. An engine steps one, or two in the same
/// cell. The manipulation thread's.
class StylusHolder {
 public:
  /// `link` and `cell` must outlive it.
  StylusHolder(haptic::HapticLink& link, CellState& cell);
  StylusHolder(const StylusHolder&) = delete;
  StylusHolder& operator=(const StylusHolder&) = delete;

  /// See ManipulationEngine::searchInThread().
  void searchInThread() { grip_.searchInThread(); }
  /// Takes a command that is for one stylus; those for the cell are the engine's.
  void apply(const Command& command);
  /// The cell has another scene. What is held goes on being held if it still exists.
  void takeScene();

  /// A step, one after the other: the newest state of the stylus, its buttons, ...
  void takeState();
  /// With a state (contract). `recording`: its second button may mark frames of it.
  void watchButtons(TakeRecording& recording);
  /// The edge of the workspace. With a state (contract).
  void driftAtEdge();
  /// ... what is held follows, and the next set is sent. With a state (contract).
  void follow(const ScriptedEntities& scripted);

  void grab(workcell::EntityId wanted);
  void release();
  /// Takes what is held anew, where it stands.
  void retake();
  /// What is held lets somebody else move its joints: it is taken anew for that where it must. False: it cannot.
  bool yieldJoints();
  /// Something that others move stands there; its way was free. True where that is news here.
  bool placeOther(workcell::EntityId id, const EntityConfiguration& at);
  /// Another stylus has what is held, or what it goes with: it is let go, and that is told. A mannequin's two hands may
  /// be held by both.
  void letGoOfWhatOtherHolds();
  /// The other hand has brought what both hold there: it is followed as far as the exact check finds the way free.
  void followOther(const EntityConfiguration& at);
  /// Others moved what is held or is in its way: what is felt is not true any more.
  void wantSetForOthers() { sets_.wantForOthers(cell_.clock().now()); }
  /// What is foreseen is not true any more.
  void wantSet() { sets_.want(); }

  const CellState& cell() const { return cell_; }
  const PreparedScene* scene() const { return cell_.scene().get(); }
  StylusGrip& grip() { return grip_; }
  const StylusGrip& grip() const { return grip_; }
  const HeldEntity* held() const { return grip_.held(); }
  EntityConfiguration placement(workcell::EntityId entity) const { return grip_.placement(entity); }
  const StylusInput& input() const { return input_; }
  const ContactWatch& contacts() const { return contacts_; }
  const SetScheduler& sets() const { return sets_; }
  ResultLog& log() { return log_; }
  std::vector<Result> takeResults() { return log_.take(); }
  /// See ManipulationEngine::nearLimits().
  std::vector<LimitState> nearLimits() const;
  /// As a take has it.
  TakeRecording::Hand hand() const;

  /// What it holds and feels, in a snapshot that is empty yet; then its one sentence.
  void addTo(SceneSnapshot& snapshot);
  void describe(SceneSnapshot& snapshot) const { snapshots_.describe(input_, grip_, snapshot); }

 private:
  bool hold(workcell::EntityId entity);
  void forgetFelt();
  void anchor();
  void updateMapping();
  void setClutched(bool clutched);
  void updateLoad();
  void tellWherePlain();
  Pose frameOfAxes();

  CellState& cell_;
  ResultLog log_;
  StylusInput input_;
  HandMapping hand_;
  StylusGrip grip_;
  FeltGuides guides_;
  ContactWatch contacts_;
  SetScheduler sets_;
  SnapshotMaker snapshots_;
  bool stopped_ = false;
  int hurried_joint_ = -1;  ///< Goes as fast as it can, and there is way left; -1: none does.
};

}  // namespace hapticell::manipulation
