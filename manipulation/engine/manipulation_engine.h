// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "config/configuration.h"
#include "haptic/transport/haptic_link.h"
#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/posed_joints.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/engine/stylus_holder.h"
#include "manipulation/engine/take_recording.h"
#include "manipulation/scene/scene_service.h"

namespace hapticell::manipulation {

/// One step of the manipulation loop, without a thread or a clock of its own.
///
/// Newest stylus and proxy -> mapping -> manipulator -> exact motion check -> accept, stop or slide -> constraint set
/// around the accepted pose -> server. The stylus and a second one share the cell, the entities with their own motion,
/// the joints posed by a glove and the take. Driven by ManipulationLoop in real time and by a session in virtual time.
/// One thread.
class ManipulationEngine {
 public:
  /// `link` must outlive the engine.
  ManipulationEngine(haptic::HapticLink& link, const config::Configuration& configuration);

  /// Moves the search for contacts to a separate thread. A step then never waits for it; until the answer arrives the
  /// last set stays in use. Without this call every step does all its work, so the same inputs give the same steps.
  void searchInThread() { holder_.searchInThread(); }

  /// Sets the current scene. A held entity stays held if it still exists.
  void setScene(std::shared_ptr<const PreparedScene> scene);
  /// Executes a command; SetDocument prepares its meshes at once (ManipulationLoop does that beforehand).
  void apply(const Command& command);
  /// One step at `now_ns` of a steady clock that never goes back.
  void step(std::int64_t now_ns);

  /// Sets a second stylus in the same cell; null removes it. It must exist until it is removed.
  void setSecond(StylusHolder* second) { second_ = second; }
  /// For a second stylus: the cell.
  CellState& cell() { return cell_; }
  /// After step(): the second stylus gets what the first one moved, makes its own step and passes back what it moved.
  /// What one holds is an obstacle for the other at its present place. If both hold the same mannequin, the other
  /// hand's motion is followed as far as the exact check finds the way free. In all other cases, if both would hold the
  /// same entity, the second one releases it and reports that. Contract: there is a second stylus.
  void stepSecond(std::int64_t now_ns);

  /// Results since the last call, in order.
  std::vector<Result> takeResults() { return holder_.takeResults(); }

  const PreparedScene* scene() const { return cell_.scene().get(); }
  const std::shared_ptr<const PreparedScene>& sharedScene() const { return cell_.scene(); }
  const HeldEntity* held() const { return holder_.held(); }
  /// An entity's present placement, moved or not. Contract: it exists.
  EntityConfiguration placement(workcell::EntityId entity) const { return holder_.placement(entity); }
  /// Placements that may differ from the document; all other entities stand as it says.
  const Placements& placements() const { return cell_.placements(); }
  const std::optional<haptic::HapticState>& hapticState() const { return holder_.input().state(); }

  const haptic::ServerStatistics& serverStatistics() const { return holder_.input().statistics(); }

  /// True if nothing is held, posed, recorded or moving and forces are off, so the engine only watches the stylus.
  bool isIdle() const;

  /// Sequence of the newest set that was sent; 0 before the first.
  std::uint64_t sentSet() const { return holder_.sets().sent(); }

  /// Pairs of the held entity that are at their boundary now: indices into held()->pairs().
  const std::vector<std::size_t>& contacts() const { return holder_.contacts().contacts(); }
  /// When the newest contact was first felt, by now_ns's clock; 0 before the first.
  std::int64_t feltAt() const { return holder_.contacts().feltAt(); }

  /// The planner beside the hand, as it is felt.
  const FeltPlan::State& plan() const { return holder_.plan(); }

  /// Why the held entity does not follow: its near limits, nearest first, and what else holds it back.
  std::vector<LimitState> nearLimits() const { return holder_.nearLimits(); }

  /// Fills the snapshot of the newest step (its distances are measured at most 30 times a second).
  void fillSnapshot(SceneSnapshot& snapshot);

 private:
  void stepHolder(StylusHolder& holder);
  void moveScripted(StylusHolder& holder);
  void takeOver(StylusHolder& to, const StylusHolder& from);
  std::vector<StylusHolder*> holders();

  SceneService scenes_;  ///< For documents that were not prepared beforehand.
  CellState cell_;
  StylusHolder holder_;
  ScriptedEntities scripted_;
  PosedJoints posed_;
  TakeRecording recording_;
  StylusHolder* second_ = nullptr;
};

}  // namespace hapticell::manipulation
