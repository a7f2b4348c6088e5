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

/// The source of a scene: the entities and the pairs to check.
struct SceneSource {
  std::vector<workcell::Entity> entities;
  workcell::PairPolicy pairs;
  workcell::PairDefaults defaults;
  /// Of the document (workcell::Document::revision()): the same revision with the same pairs means the same scene. 0:
  /// unknown.
  std::uint64_t revision = 0;
};

/// Configured distances, for pairs that no pair set names.
workcell::PairDefaults pairDefaults(const config::Configuration& configuration);
/// The present document, with all its pair sets and rules.
SceneSource sourceOf(const workcell::Document& document, const workcell::PairDefaults& defaults);

/// The only owner of prepared scenes: all code that needs the cell for queries (loop, jog, drags, checks, pictures)
/// gets it here. So each mesh is prepared once, and no cell is prepared without its pair rules. Any thread.
///
/// One scene is prepared at a time, on all the machine's cores; other callers wait, because they mostly need the same
/// scene.
class SceneService {
 public:
  SceneService() = default;
  SceneService(const SceneService&) = delete;
  SceneService& operator=(const SceneService&) = delete;

  /// The scene of this source: the existing one, or a new one that reuses known meshes. Null if cancelled
  /// (PreparationProgress::build); meshes prepared until then are kept for the next one.
  std::shared_ptr<const PreparedScene> prepare(SceneSource source, PreparationProgress* progress = nullptr);

  /// The scene that the running loop uses and shows, for other code that measures the cell; null: nothing runs.
  void setShown(std::shared_ptr<const PreparedScene> scene);
  std::shared_ptr<const PreparedScene> shown() const;

  /// The document is closed: drops its scenes here (other owners keep theirs).
  void forget();

 private:
  /// A scene that was returned. The newest are kept; for others, tells whether they are still in use.
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
