// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/result_log.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/engine/stylus_grip.h"
#include "manipulation/engine/take_recorder.h"

namespace hapticell::manipulation {

/// Records a take of the cell, once per step of the loop: what styluses or gloves move, and scripted motions.
/// Manipulation thread only.
class TakeRecording {
 public:
  /// The data of a stylus for the recording.
  struct Hand {
    const StylusGrip& grip;
    dvec3 force_W{0.0};                        ///< Force on the hand, N.
    const std::vector<std::size_t>& contacts;  ///< Contacts of the held entity.
  };

  /// Both outlive it.
  TakeRecording(const CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// Starts a recording; a running one is finished first.
  void start(const command::StartRecording& wanted);
  /// Ends a running recording and reports it.
  void stop();
  bool isOn() const { return recorder_ != nullptr; }
  /// Whether a recording runs in which a stylus's second button adds a frame.
  bool isMarkedByButton() const { return recorder_ && mark_by_button_; }
  /// Adds a frame by hand at the next step, of everything that moves.
  void mark() { mark_wanted_ = true; }

  /// Records a step of the first stylus, of an entity posed by a glove only (null: none has moved), and of scripted
  /// motions.
  void step(const Hand& hand, const HeldEntity* posed, const ScriptedEntities& scripted);
  /// Records what a second stylus moves; for a mannequin that `first` also holds, only its contacts. Contract: the
  /// second stylus holds something.
  void addOther(const Hand& other, const StylusGrip& first);

  /// The recording's state for the window.
  SceneSnapshot::Recording shown() const;

 private:
  TakeRecorder::Sample sampleOf(const Hand& hand, const EntityConfiguration& at) const;
  void addHeld(const Hand& hand, bool by_hand);
  void addBeside(workcell::EntityId id, bool by_hand);

  const CellState& cell_;
  ResultLog& log_;
  std::unique_ptr<TakeRecorder> recorder_;
  bool mark_by_button_ = false, mark_wanted_ = false;
  std::int64_t marked_ns_ = -1;  ///< Step of the newest mark.
};

}  // namespace hapticell::manipulation
