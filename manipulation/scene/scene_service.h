// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "config/configuration.h"
#include "manipulation/scene/prepared_scene.h"
#include "workcell/document/document.h"

namespace hapticell::manipulation {

/// What a scene is prepared of: the entities together with what is checked against what.
struct SceneSource {
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  workcell::PairDefaults defaults;
  /// Of the document (workcell::Document::revision()): the same revision with the same pairs is the same scene. 0: not
  /// known.
  std::uint64_t revision = 0;
};

/// Distances for pairs that no set names, as configured.
workcell::PairDefaults pairDefaults(const config::Configuration& configuration);
/// The document as it stands, with all its pair sets and rules.
SceneSource sourceOf(const workcell::Document& document, const workcell::PairDefaults& defaults);

/// The one owner of prepared scenes: whoever needs the cell for queries (loop, jog, drags, checks, pictures) asks here,
/// so that a mesh is made ready once and nobody prepares a cell without its pair rules. Any thread.
///
/// One scene is prepared at a time, on all the machine's cores; who asks meanwhile waits, as what it needs is mostly
/// what is being made ready.
class SceneService {
 public:
  SceneService() = default;
  SceneService(const SceneService&) = delete;
  SceneService& operator=(const SceneService&) = delete;

  /// The scene of this source: the one that is there, or a new one with the meshes that are known. Null when cancelled
  /// (PreparationProgress::build); what was made ready until then is kept for the next one.
  std::shared_ptr<const PreparedScene> prepare(SceneSource source, PreparationProgress* progress = nullptr);

  /// The scene that what runs steps and shows now, for whoever measures the cell beside it; null: nothing runs.
  void setShown(std::shared_ptr<const PreparedScene> scene);
  std::shared_ptr<const PreparedScene> shown() const;

  /// The document is closed: nothing of it is kept here (who holds a scene goes on holding it).
  void forget();

 private:
  /// A scene that was handed out. The newest are kept, of others it is known whether somebody holds them yet.
  struct Known {
    std::weak_ptr<const PreparedScene> scene;
    std::uint64_t revision = 0;
  };
  bool beginPreparing(const PreparationProgress* progress);
  std::shared_ptr<const PreparedScene> find(const SceneSource& source);
  std::vector<std::shared_ptr<const PreparedScene>> alive();
  void keep(const std::shared_ptr<const PreparedScene>& scene, std::uint64_t revision);

  std::timed_mutex preparing_;                               // Held by whoever prepares.
  mutable std::mutex mutex_;                                 // Guards what follows; held only while pointers are moved.
  std::deque<std::shared_ptr<const PreparedScene>> newest_;  ///< The newest first.
  std::vector<Known> known_;
  std::shared_ptr<const PreparedScene> shown_;
};

}  // namespace hapticell::manipulation
