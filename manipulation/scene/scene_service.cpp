// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/scene_service.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace hapticell::manipulation {

namespace {

/// Scenes that are kept while nobody holds them: the document's, and that of a question about it with other pairs.
/// Half: one of both is prepared again each time; twice: twice the memory.
constexpr std::size_t kScenesKept = 2;
constexpr std::chrono::milliseconds kLookForCancel{20};

}  // namespace

workcell::PairDefaults pairDefaults(const config::Configuration& configuration) {
  return {configuration.manipulation.safety_distance, configuration.manipulation.near_miss};
}

SceneSource sourceOf(const workcell::Document& document, const workcell::PairDefaults& defaults) {
  return {document.snapshotEntities(), document.state().pairPolicy(), defaults, document.revision()};
}

/// False when cancelled while somebody else prepares.
bool SceneService::beginPreparing(const PreparationProgress* progress) {
  while (!preparing_.try_lock_for(kLookForCancel)) {
    if (progress != nullptr && progress->build.cancelled) return false;
  }
  return true;
}

std::shared_ptr<const PreparedScene> SceneService::find(const SceneSource& source) {
  if (source.revision == 0) return nullptr;
  const std::lock_guard lock(mutex_);
  for (const Known& known : known_) {
    auto scene = known.revision == source.revision ? known.scene.lock() : nullptr;
    if (scene && scene->pairs() == source.pairs && scene->defaults() == source.defaults) return scene;
  }
  return nullptr;
}

std::vector<std::shared_ptr<const PreparedScene>> SceneService::alive() {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const PreparedScene>> scenes;
  std::erase_if(known_, [](const Known& known) { return known.scene.expired(); });
  for (auto known = known_.rbegin(); known != known_.rend(); ++known) {
    if (auto scene = known->scene.lock()) scenes.push_back(std::move(scene));
  }
  return scenes;
}

void SceneService::keep(const std::shared_ptr<const PreparedScene>& scene, std::uint64_t revision) {
  std::shared_ptr<const PreparedScene> dropped;  // Frees its meshes outside the lock.
  const std::lock_guard lock(mutex_);
  known_.push_back({scene, revision});
  newest_.push_front(scene);
  if (newest_.size() <= kScenesKept) return;
  dropped = std::move(newest_.back());
  newest_.pop_back();
}

std::shared_ptr<const PreparedScene> SceneService::prepare(SceneSource source, PreparationProgress* progress) {
  if (!beginPreparing(progress)) return nullptr;
  const std::lock_guard prepares(preparing_, std::adopt_lock);
  if (auto scene = find(source)) return scene;
  PreparationProgress unwatched;
  PreparationProgress& watched = progress != nullptr ? *progress : unwatched;
  const std::uint64_t revision = source.revision;
  auto scene =
      PreparedScene::prepare(std::move(source.entities), std::move(source.pairs), source.defaults, alive(), watched);
  if (scene)
    keep(scene, revision);
  else
    keep(std::exchange(watched.given_up, nullptr), 0);
  return scene;
}

void SceneService::setShown(std::shared_ptr<const PreparedScene> scene) {
  const std::lock_guard lock(mutex_);
  shown_.swap(scene);  // What was shown is freed outside the lock, with the argument.
}

std::shared_ptr<const PreparedScene> SceneService::shown() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

void SceneService::forget() {
  std::deque<std::shared_ptr<const PreparedScene>> dropped;
  std::shared_ptr<const PreparedScene> was_shown;
  const std::lock_guard lock(mutex_);
  dropped.swap(newest_);
  was_shown.swap(shown_);
}

}  // namespace hapticell::manipulation
