// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "config/configuration.h"
#include "manipulation/engine/step_clock.h"
#include "manipulation/holding/held_entity.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::manipulation {

/// The cell that all styluses and hands of one engine share: its scene, the placements that differ from the document,
/// and the time. Manipulation thread only.
class CellState {
 public:
  explicit CellState(const config::Configuration& configuration) : configuration_(configuration) {}
  CellState(const CellState&) = delete;
  CellState& operator=(const CellState&) = delete;

  const config::Configuration& configuration() const { return configuration_; }

  /// Null before the first document.
  const std::shared_ptr<const PreparedScene>& scene() const { return scene_; }
  /// Sets the current scene; `kept`: placements that differ from its document.
  void setScene(std::shared_ptr<const PreparedScene> scene, Placements kept);
  /// Null if there is no scene, or no such entity in it.
  const workcell::Entity* find(workcell::EntityId id) const { return scene_ ? scene_->find(id) : nullptr; }
  const workcell::Entity* find(const std::string& name) const { return scene_ ? scene_->find(name) : nullptr; }
  /// Whether an entity is `below`, or attached to it directly or through others. Contract: there is a scene.
  bool standsOn(workcell::EntityId entity, workcell::EntityId below) const;

  /// Placements that differ from the document; for held entities, the placement when they were taken or last reported.
  const Placements& placements() const { return placements_; }
  /// An entity's placement by placements() and the document. Contract: it exists.
  EntityConfiguration placement(workcell::EntityId id) const;
  void place(workcell::EntityId id, EntityConfiguration at) { placements_[id] = std::move(at); }

  const StepClock& clock() const { return clock_; }
  /// Begins a step at `now_ns`; steps at the same time count as one.
  void tick(std::int64_t now_ns);

 private:
  const config::Configuration configuration_;
  std::shared_ptr<const PreparedScene> scene_;  // Shared with the thread that prepares the next one.
  Placements placements_;
  StepClock clock_;
};

/// Whether placement and joints are exactly equal.
bool areSame(const EntityConfiguration& a, const EntityConfiguration& b);

}  // namespace hapticell::manipulation
