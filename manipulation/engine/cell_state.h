// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "config/configuration.h"
#include "manipulation/engine/step_clock.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// The cell that all styluses and hands of one engine share: its scene, where things stand that do not stand as in the
/// document, and the time. The manipulation thread's.
class CellState {
 public:
  explicit CellState(const config::Configuration& configuration) : configuration_(configuration) {}
  CellState(const CellState&) = delete;
  CellState& operator=(const CellState&) = delete;

  const config::Configuration& configuration() const { return configuration_; }

  /// Null before the first document.
  const std::shared_ptr<const PreparedScene>& scene() const { return scene_; }
  /// The scene that counts from now on; `kept`: what stands elsewhere than in its document.
  void setScene(std::shared_ptr<const PreparedScene> scene, Placements kept);
  /// Null where there is no scene, or no such entity in it.
  const workcell::Entity* find(workcell::EntityId id) const { return scene_ ? scene_->find(id) : nullptr; }
  const workcell::Entity* find(const std::string& name) const { return scene_ ? scene_->find(name) : nullptr; }
  /// Whether an entity is `below`, or hangs on it, directly or by others. With a scene (contract).
  bool standsOn(workcell::EntityId entity, workcell::EntityId below) const;

  /// What does not stand as in the document; of what is held, where it stood when it was taken or told last.
  const Placements& placements() const { return placements_; }
  /// Where an entity stands by placements() and the document. It exists (contract).
  EntityConfiguration placement(workcell::EntityId id) const;
  void place(workcell::EntityId id, EntityConfiguration at) { placements_[id] = std::move(at); }

  const StepClock& clock() const { return clock_; }
  /// A step at `now_ns` begins; steps at the same time are one.
  void tick(std::int64_t now_ns);

 private:
  const config::Configuration configuration_;
  std::shared_ptr<const PreparedScene> scene_;  // Shared with the thread that prepares the next one.
  Placements placements_;
  StepClock clock_;
};

/// The same place and joints, to the last digit.
bool areSame(const EntityConfiguration& a, const EntityConfiguration& b);

}  // namespace hapticell::manipulation
