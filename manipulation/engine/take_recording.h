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

/// The take of a cell that is recorded, a step of the loop at a time: what any stylus or glove moves and what goes by
/// itself. The manipulation thread's.
class TakeRecording {
 public:
  /// A stylus as it is recorded.
  struct Hand {
    const StylusGrip& grip;
    dvec3 force_W{0.0};                        ///< N on it.
    const std::vector<std::size_t>& contacts;  ///< Pairs of what it holds.
  };

  /// Both outlive it.
  TakeRecording(const CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// One that goes on is finished first.
  void start(const command::StartRecording& wanted);
  /// Tells what was recorded, where one goes on.
  void stop();
  bool isOn() const { return recorder_ != nullptr; }
  /// It is on, and a stylus's second button adds a frame.
  bool isMarkedByButton() const { return recorder_ && mark_by_button_; }
  /// Adds a frame by hand at the next step, of everything that moves.
  void mark() { mark_wanted_ = true; }

  /// A step of the first stylus, of what a glove poses and nobody holds (null: nothing has moved so), and of what goes
  /// by itself.
  void step(const Hand& hand, const HeldEntity* posed, const ScriptedEntities& scripted);
  /// What a second stylus moves (it holds something: contract); of a mannequin that `first` holds too, what it touches.
  void addOther(const Hand& other, const StylusGrip& first);

  /// As the window shows it.
  SceneSnapshot::Recording shown() const;

 private:
  TakeRecorder::Sample sampleOf(const Hand& hand, const EntityConfiguration& at) const;
  void addHeld(const Hand& hand, bool by_hand);
  void addBeside(workcell::EntityId id, bool by_hand);

  const CellState& cell_;
  ResultLog& log_;
  std::unique_ptr<TakeRecorder> recorder_;
  bool mark_by_button_ = false, mark_wanted_ = false;
  std::int64_t marked_ns_ = -1;  ///< The step that the newest mark belongs to.
};

}  // namespace hapticell::manipulation
