// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/prepared_scene.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "collision/surfaces/hollow_relief.h"
#include "collision/surfaces/mesh_facing.h"

namespace hapticell::manipulation {

namespace {

/// Triangles of a mesh whose tree is kept on disk (some 50 ms to build), and of one whose surfaces are (Performance).
/// Half: more small files; twice: cells open slower by that.
constexpr std::size_t kWorthAFile = 50000, kSurfacesWorthAFile = 3000;
/// Triangles; of larger meshes only what is near is cut into pieces (Contacts), as a million took 41 s. Half: more are
/// cut while in use; twice: opening takes seconds more.
constexpr std::size_t kCutAsAWhole = 60000;
constexpr std::size_t kStages = 3;  ///< Surfaces, tree, pieces.
/// m: a surface's mesh that is this near to the part's own (1 um, and rounding) stands for it. Half: every part has a
/// tree twice; twice: the check may be off by 2 um.
constexpr double kWeldedByLittle = 1.1e-6;

/// Made for the contacts, so it must not leave out or move what the exact check is to see.
bool standsFor(const collision::SurfaceModel& surfaces, const geometry::TriangleMesh& mesh) {
  return surfaces.surface().mesh.triangles.size() == mesh.triangles.size() &&
         geometry::weldTolerance(mesh) <= kWeldedByLittle;
}

/// False when cancelled.
bool makeReady(const geometry::TriangleMesh& as_read, PreparationProgress& progress, PreparedMesh& prepared) {
  const std::size_t triangles = as_read.triangles.size();
  const geometry::TriangleMesh mesh = collision::feltMesh(as_read, &prepared.bodies_turned);
  collision::ColliderBuild how;
  how.progress = &progress.build;
  if (triangles >= kSurfacesWorthAFile) how.cache_folder = collision::userCacheFolder();
  prepared.surfaces = collision::SurfaceModel::build(mesh, how);
  if (progress.build.cancelled) return false;
  progress.done += triangles;
  how.cache_folder = triangles >= kWorthAFile ? collision::userCacheFolder() : std::filesystem::path();
  const bool relieved = collision::hasHollows(prepared.surfaces->surface());
  prepared.collider = relieved || standsFor(*prepared.surfaces, mesh) ? prepared.surfaces->sharedCollider()
                                                                      : collision::MeshCollider::build(mesh, how);
  if (progress.build.cancelled) return false;
  progress.done += triangles;
  prepared.pieces = triangles > kCutAsAWhole ? collision::ConvexPieces::onDemand(prepared.collider)
                                             : collision::ConvexPieces::build(mesh);
  progress.done += triangles;
  return !progress.build.cancelled;
}

geometry::TriangleMesh wholeOf(const kinematics::Link& link) {
  geometry::TriangleMesh whole;
  for (const kinematics::LinkShape& shape : link.collisions) {
    if (shape.mesh) geometry::append(whole, *shape.mesh, shape.X_LS);
  }
  return whole;
}

}  // namespace

/// A link's shapes are put together only where they are not known already: studies prepare a scene for each variant.
struct PreparedScene::Job {
  MeshKey key;
  std::shared_ptr<const geometry::TriangleMesh> mesh;  ///< Null: the link's, which belongs to the scene's entities.
  const kinematics::Link* link = nullptr;
  std::size_t triangles = 0;
};

std::shared_ptr<const PreparedScene> PreparedScene::prepare(std::vector<workcell::Entity> entities,
                                                            workcell::PairPolicy pairs,
                                                            const workcell::PairDefaults& defaults,
                                                            const PreparedScene* previous,
                                                            PreparationProgress* progress) {
  PreparationProgress unwatched;
  std::vector<std::shared_ptr<const PreparedScene>> known;
  // It outlives the call and is not owned here.
  if (previous != nullptr) known.emplace_back(std::shared_ptr<void>(), previous);
  return prepare(std::move(entities), std::move(pairs), defaults, known, progress != nullptr ? *progress : unwatched);
}

std::shared_ptr<const PreparedScene> PreparedScene::prepare(
    std::vector<workcell::Entity> entities, workcell::PairPolicy pairs, const workcell::PairDefaults& defaults,
    std::span<const std::shared_ptr<const PreparedScene>> previous, PreparationProgress& progress) {
  std::shared_ptr<PreparedScene> scene(new PreparedScene);
  scene->entities_ = std::move(entities);
  scene->pairs_ = std::move(pairs);
  scene->defaults_ = defaults;
  scene->index();
  std::vector<Job> jobs;
  for (const workcell::Entity& entity : scene->entities_) {
    const std::size_t first = scene->parts_.size();
    scene->addParts(entity, jobs);
    // Of two with one id the first counts.
    Known& known = scene->by_id_.at(entity.id);
    if (&scene->entities_[known.entity] == &entity)
      known.first_part = first, known.parts = scene->parts_.size() - first;
  }
  scene->run(jobs, previous, progress);
  if (!progress.build.cancelled) return scene;
  scene->dropUnfinished();
  progress.given_up = std::move(scene);
  return nullptr;
}

void PreparedScene::index() {
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    by_id_.try_emplace(entities_[i].id, Known{i, 0, 0});
    by_name_.emplace(entities_[i].name, i);
  }
  for (const workcell::PairRule& rule : pairs_.rules) {
    rules_of_[rule.first].push_back(rule);
    if (rule.second != rule.first) rules_of_[rule.second].push_back(rule);
  }
}

void PreparedScene::dropUnfinished() {
  for (auto& [id, known] : by_id_) known.first_part = known.parts = 0;
  parts_.clear();
  keys_.clear();
  std::erase_if(meshes_, [](const auto& entry) {
    const PreparedMesh& mesh = entry.second;
    return !mesh.surfaces || !mesh.collider || !mesh.pieces;
  });
}

void PreparedScene::addPart(ScenePart part, const MeshKey& key, std::shared_ptr<const geometry::TriangleMesh> mesh,
                            std::vector<Job>& jobs) {
  part.body = workcell::rigidBodyOf(entities_, *find(part.entity), part.link);
  if (meshes_.emplace(key, PreparedMesh{}).second) {
    const std::size_t triangles = mesh ? mesh->triangles.size() : 0;
    jobs.push_back({key, std::move(mesh), nullptr, triangles});
  }
  parts_.push_back(std::move(part));
  keys_.push_back(key);
}

/// The largest meshes first, each by whoever is free: what comes of it does not depend on who does it.
void PreparedScene::run(const std::vector<Job>& jobs, std::span<const std::shared_ptr<const PreparedScene>> previous,
                        PreparationProgress& progress) {
  std::vector<const Job*> order;
  std::size_t steps = 0;
  for (const Job& job : jobs) {
    const auto has_it = [&](const auto& scene) { return scene->meshes_.count(job.key) != 0; };
    const auto known = std::find_if(previous.begin(), previous.end(), has_it);
    if (known != previous.end()) {
      meshes_[job.key] = (*known)->meshes_.at(job.key);
    } else {
      order.push_back(&job);
      steps += kStages * job.triangles;
    }
  }
  progress.steps = steps;
  std::stable_sort(order.begin(), order.end(),
                   [](const Job* a, const Job* b) { return a->triangles > b->triangles; });
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < order.size(); i = next++) {
      const Job& job = *order[i];
      PreparedMesh& prepared = meshes_.find(job.key)->second;
      const geometry::TriangleMesh whole = job.mesh ? geometry::TriangleMesh() : wholeOf(*job.link);
      if (!makeReady(job.mesh ? *job.mesh : whole, progress, prepared)) return;
    }
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < std::min(cores, order.size()); ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].mesh = meshes_.at(keys_[i]);
}

void PreparedScene::addParts(const workcell::Entity& entity, std::vector<Job>& jobs) {
  switch (entity.kind()) {
    case workcell::EntityKind::kSolid:
      if (const auto& mesh = workcell::checkedMesh(entity); mesh && !mesh->triangles.empty())
        addPart({.entity = entity.id}, {mesh.get(), -1}, mesh, jobs);
      return;
    case workcell::EntityKind::kRobot:
    case workcell::EntityKind::kMechanism:
    case workcell::EntityKind::kMannequin:
      return addLinks(entity, jobs);
    case workcell::EntityKind::kAssembly:
    case workcell::EntityKind::kFrame:
      return;  // Without a shape.
  }
}

void PreparedScene::addLinks(const workcell::Entity& entity, std::vector<Job>& jobs) {
  if (!entity.robot()) return;
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i) {
    const kinematics::Link& link = entity.robot()->links[i];
    std::size_t triangles = 0;
    for (const kinematics::LinkShape& shape : link.collisions) {
      if (shape.mesh) triangles += shape.mesh->triangles.size();
    }
    if (triangles == 0) continue;
    const MeshKey key{entity.robot().get(), static_cast<int>(i)};
    const std::size_t known = jobs.size();
    addPart({.entity = entity.id, .link = static_cast<int>(i), .name = link.name}, key, nullptr, jobs);
    if (jobs.size() == known) continue;
    jobs.back().link = &link;
    jobs.back().triangles = triangles;
  }
}

const workcell::Entity* PreparedScene::find(workcell::EntityId id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &entities_[found->second.entity];
}

const workcell::Entity* PreparedScene::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &entities_[found->second];
}

std::span<const ScenePart> PreparedScene::partsOf(workcell::EntityId id) const {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return {};
  return std::span(parts_).subspan(found->second.first_part, found->second.parts);
}

Pose PreparedScene::partPose(const workcell::Entity& entity, const Pose& X_WE, const std::vector<double>& joints,
                             int link) {
  if (link < 0 || !entity.robot()) return X_WE;
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*entity.robot(), joints, X_EL);
  return X_WE * X_EL[static_cast<std::size_t>(link)];
}

std::vector<workcell::EffectivePair> PreparedScene::pairsOf(workcell::EntityId moved,
                                                            workcell::OnContact on_contact) const {
  return workcell::effectivePairs(entities_, pairs_.sets, moved, defaults_, on_contact);
}

const workcell::PairRule* PreparedScene::ruleFor(const ScenePart& a, const ScenePart& b) const {
  if (rules_of_.empty()) return nullptr;
  const std::string &first = find(a.entity)->name, &second = find(b.entity)->name;
  const auto of_first = rules_of_.find(first), of_second = rules_of_.find(second);
  if (of_first == rules_of_.end() || of_second == rules_of_.end()) return nullptr;
  const auto& fewer = of_first->second.size() < of_second->second.size() ? of_first->second : of_second->second;
  return workcell::ruleFor(fewer, {first, a.name}, {second, b.name});
}

bool PreparedScene::isChecked(const ScenePart& a, const ScenePart& b) const {
  if (a.body == b.body) return false;
  const workcell::PairRule* rule = ruleFor(a, b);
  return rule == nullptr || rule->checked;
}

PreparedScene::FoundFrame PreparedScene::findFrame(const std::string& name) const {
  for (const workcell::Entity& entity : entities_) {
    if (entity.name == name) return {&entity, Pose::identity()};
    for (const workcell::Frame& frame : entity.frames) {
      if (frame.name == name) return {&entity, frame.X_EF};
    }
  }
  return {};
}

}  // namespace hapticell::manipulation
