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

namespace hapticell::manipulation {

/// One step of the manipulation loop, without a thread or a clock of its own.
///
/// Newest stylus and proxy -> mapping -> manipulator -> exact motion check -> accept, stop or slide -> constraint set
/// about the accepted pose -> server. The cell, what goes by itself, what a glove poses and the take are shared by the
/// stylus and a second one. Driven by ManipulationLoop in real time and by a session in virtual time. One thread.
class ManipulationEngine {
 public:
  /// `link` must outlive the engine.
  ManipulationEngine(haptic::HapticLink& link, const config::Configuration& configuration);

  /// From now on contacts are looked for in a thread of their own: a step never waits for them, the last set is held
  /// meanwhile. Without it every step does all that it needs, so that the same inputs give the same steps.
  void searchInThread() { holder_.searchInThread(); }

  /// The scene that counts from now on. What is held goes on being held if it still exists.
  void setScene(std::shared_ptr<const PreparedScene> scene);
  /// Takes a command; SetDocument prepares its meshes at once (ManipulationLoop does that beforehand).
  void apply(const Command& command);
  /// One step at `now_ns` of a steady clock that never goes back.
  void step(std::int64_t now_ns);

  /// A second stylus in the same cell; null: it is gone. It outlives its time here.
  void setSecond(StylusHolder* second) { second_ = second; }
  /// For a second stylus: the cell.
  CellState& cell() { return cell_; }
  /// After step(): the second stylus takes over what the first one moved, makes its own step, hands over what it moved.
  /// What either holds is in the other one's way where it stands now, or, where both hold the same mannequin, the other
  /// hand's doing, which goes as far as the exact check finds it free. Nothing is held by both but that: the second one
  /// lets go then and says so. There is a second one (contract).
  void stepSecond(std::int64_t now_ns);

  /// What happened since the last call, in order.
  std::vector<Result> takeResults() { return holder_.takeResults(); }

  const PreparedScene* scene() const { return cell_.scene().get(); }
  const std::shared_ptr<const PreparedScene>& sharedScene() const { return cell_.scene(); }
  const HeldEntity* held() const { return holder_.held(); }
  /// Where an entity stands now, moved or not. It exists (contract).
  EntityConfiguration placement(workcell::EntityId entity) const { return holder_.placement(entity); }
  const std::optional<haptic::HapticState>& hapticState() const { return holder_.input().state(); }

  const haptic::ServerStatistics& serverStatistics() const { return holder_.input().statistics(); }

  /// Nothing is held, posed, recorded or on its way, and forces are off: all there is to do is to watch the stylus.
  bool isIdle() const;

  /// Sequence of the newest set that was sent; 0 before the first.
  std::uint64_t sentSet() const { return holder_.sets().sent(); }

  /// Pairs of what is held that are at their boundary now: indices into held()->pairs().
  const std::vector<std::size_t>& contacts() const { return holder_.contacts().contacts(); }
  /// When the newest of them was felt first, by now_ns's clock; 0 before any.
  std::int64_t feltAt() const { return holder_.contacts().feltAt(); }

  /// Limits of what is held that are near, nearest first, and what else holds it back: why it does not follow.
  std::vector<LimitState> nearLimits() const { return holder_.nearLimits(); }

  /// The picture of the newest step, made here (distances are measured for it at most 30 times a second).
  void fillSnapshot(SceneSnapshot& snapshot);

 private:
  void stepHolder(StylusHolder& holder);
  void moveScripted(StylusHolder& holder);
  void takeOver(StylusHolder& to, const StylusHolder& from);
  std::vector<StylusHolder*> holders();

  CellState cell_;
  StylusHolder holder_;
  ScriptedEntities scripted_;
  PosedJoints posed_;
  TakeRecording recording_;
  StylusHolder* second_ = nullptr;
};

}  // namespace hapticell::manipulation
