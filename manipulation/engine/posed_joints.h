// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "manipulation/engine/cell_state.h"
#include "manipulation/engine/manipulation_command.h"
#include "manipulation/engine/result_log.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

class StylusHolder;

/// The joints of a cell's entity that a glove poses, through the stylus that holds the entity or, where none does, in a
/// hand of their own. The manipulation thread's.
class PosedJoints {
 public:
  /// Both outlive it.
  PosedJoints(CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// Where the glove has them from now on; see command::PoseJoints.
  void want(const command::PoseJoints& wanted);
  /// What is wanted is of this entity; 0: nothing is.
  workcell::EntityId wanted() const { return wanted_ ? wanted_->entity : 0; }

  /// The own hand; null while a stylus poses, or nothing is posed.
  const HeldEntity* posed() const { return posed_.get(); }
  bool poses(workcell::EntityId id) const { return posed_ && posed_->id() == id; }
  /// A stylus has taken what was posed.
  void letGo() { posed_.reset(); }
  /// The cell has another scene: the hand is taken anew at the next step.
  void takeScene();

  /// Brings the joints where they are wanted, as far as the way is free: those of what `stylus` holds, or those in the
  /// own hand. Not at every step.
  void follow(StylusHolder& stylus);
  /// Something that a stylus moves stands there now; its way was free of what is posed.
  void placeOther(workcell::EntityId id, const EntityConfiguration& at);

  /// A take begins: nothing has moved in it yet.
  void beginTake() { moved_ = false; }
  /// The own hand, where it has moved since the take began; else null.
  const HeldEntity* movedInTake() const { return moved_ ? posed_.get() : nullptr; }

  /// Adds what the own hand touches and is near, as the window and a glove's vibrators want it.
  void addTo(SceneSnapshot& snapshot) const;

 private:
  HeldEntity* poser(StylusHolder& stylus);
  HeldEntity* ownHand();

  CellState& cell_;
  ResultLog& log_;
  std::unique_ptr<HeldEntity> posed_;
  std::optional<command::PoseJoints> wanted_;
  std::int64_t posed_ns_ = -1'000'000'000;
  bool moved_ = false;  // Since the take began.
};

}  // namespace hapticell::manipulation
