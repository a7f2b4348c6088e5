// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/scores/work_task.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/guide.h"

namespace hapticell::trajectory {
class Trajectory;
}

namespace hapticell::workcell {

/// The last view of the cell.
struct SavedView {
  dvec3 p_WEye{2.0, -2.0, 1.5};
  dvec3 p_WTarget{0.0};
};

/// A trajectory of the cell, in a separate file (*.htraj).
struct TrajectoryReference {
  std::string name;  ///< Unique among them.
  std::string path;  ///< Absolute in memory; written relative to the document.
  /// Its content if it was made or read already; shared, never changed. The document itself does not read it.
  std::shared_ptr<const trajectory::Trajectory> motion = {};
};

/// The content of a document, as a value. Entities are shared between copies and never changed in place, so a copy
/// costs one pointer per entity: undo keeps whole states, and a state can be passed to another thread.
struct DocumentState {
  std::vector<std::shared_ptr<const Entity>> entities;  ///< In the order of the tree; ids and names are unique.
  std::vector<PairSet> pair_sets;                       ///< Names unique.
  std::vector<PairRule> pair_rules;                     ///< At most one for each pair of sides.
  std::vector<Guide> guides;                            ///< Names unique; each belongs to an existing entity.
  std::vector<ergonomics::WorkTask> work_tasks;         ///< Tasks of mannequins; names unique.
  std::optional<SavedView> view;
  std::vector<TrajectoryReference> trajectories;

  /// All settings for the pairs to check, for preparing a scene.
  PairPolicy pairPolicy() const { return PairPolicy(pair_sets, pair_rules); }

  /// Null if it does not exist.
  const Entity* find(EntityId id) const;
  const Entity* findByName(std::string_view name) const;
  const PairSet* findPairSet(std::string_view name) const;
  const Guide* findGuide(std::string_view name) const;
  const TrajectoryReference* findTrajectory(std::string_view name) const;
  const ergonomics::WorkTask* findWorkTask(std::string_view name) const;
  /// The first task that names the mannequin, else the first that names none; null if there is neither.
  const ergonomics::WorkTask* workTaskOf(std::string_view mannequin) const;
};

/// True if `entity` is `carrier`, or is attached to it, directly or through others.
bool isCarriedBy(const DocumentState& state, const Entity& entity, EntityId carrier);

/// The entity and everything below it in the tree (by `parent`), itself first. Empty if it does not exist.
std::vector<EntityId> familyOf(const DocumentState& state, EntityId id);

}  // namespace hapticell::workcell
