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

/// The joints of an entity that a glove poses: through the stylus that holds the entity or, if no stylus holds it,
/// through its own held entity. Manipulation thread only.
class PosedJoints {
 public:
  /// Both outlive it.
  PosedJoints(CellState& cell, ResultLog& log) : cell_(cell), log_(log) {}

  /// Sets the target values of the joints; see command::PoseJoints.
  void want(const command::PoseJoints& wanted);
  /// The entity to pose; 0: no entity.
  workcell::EntityId wanted() const { return wanted_ ? wanted_->entity : 0; }

  /// The own held entity; null if a stylus holds the entity, or nothing is posed.
  const HeldEntity* posed() const { return posed_.get(); }
  bool poses(workcell::EntityId id) const { return posed_ && posed_->id() == id; }
  /// A stylus has taken the posed entity.
  void letGo() { posed_.reset(); }
  /// The cell has a new scene: the entity is taken again at the next step.
  void takeScene();

  /// Moves the joints to the glove's values as far as the way is free, through `stylus` or through the own held entity.
  /// Not at every step.
  void follow(StylusHolder& stylus);
  /// An entity moved by a stylus has a new placement; its way did not collide with the posed entity.
  void placeOther(workcell::EntityId id, const EntityConfiguration& at);

  /// A take begins.
  void beginTake() { moved_ = false; }
  /// The own held entity, if it has moved since the take began; else null.
  const HeldEntity* movedInTake() const { return moved_ ? posed_.get() : nullptr; }

  /// Adds the contacts and near pairs of the own held entity, for the window and the glove's vibrators.
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
