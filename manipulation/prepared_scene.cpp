// SPDX-License-Identifier: Apache-2.0
#include "manipulation/prepared_scene.h"

#include <algorithm>

namespace hapticell::manipulation {

std::shared_ptr<const PreparedScene> PreparedScene::prepare(std::vector<workcell::Entity> entities,
                                                            std::vector<workcell::PairSet> pair_sets,
                                                            const workcell::PairDefaults& defaults,
                                                            const PreparedScene* previous) {
  std::shared_ptr<PreparedScene> scene(new PreparedScene);
  scene->entities_ = std::move(entities);
  scene->pair_sets_ = std::move(pair_sets);
  scene->defaults_ = defaults;
  for (const workcell::Entity& entity : scene->entities_) scene->addParts(entity, previous);
  return scene;
}

PreparedMesh PreparedScene::prepared(const MeshKey& key, const geometry::TriangleMesh& mesh,
                                     const PreparedScene* previous) {
  if (const auto found = meshes_.find(key); found != meshes_.end()) return found->second;
  PreparedMesh result;
  if (previous != nullptr && previous->meshes_.count(key) != 0) {
    result = previous->meshes_.at(key);
  } else {
    result = {collision::MeshCollider::build(mesh), collision::ConvexPieces::build(mesh)};
  }
  meshes_[key] = result;
  return result;
}

void PreparedScene::addParts(const workcell::Entity& entity, const PreparedScene* previous) {
  if (entity.kind == workcell::EntityKind::kSolid) {
    if (!entity.mesh || entity.mesh->triangles.empty()) return;
    parts_.push_back({entity.id, -1, "", prepared({entity.mesh.get(), -1}, *entity.mesh, previous)});
    return;
  }
  if (!entity.robot) return;
  for (std::size_t i = 0; i < entity.robot->links.size(); ++i) {
    const kinematics::Link& link = entity.robot->links[i];
    geometry::TriangleMesh whole;
    for (const kinematics::LinkShape& shape : link.collisions) {
      if (shape.mesh) geometry::append(whole, *shape.mesh, shape.X_LS);
    }
    if (whole.triangles.empty()) continue;
    const MeshKey key{entity.robot.get(), static_cast<int>(i)};
    parts_.push_back({entity.id, static_cast<int>(i), link.name, prepared(key, whole, previous)});
  }
}

const workcell::Entity* PreparedScene::find(workcell::EntityId id) const {
  const auto found = std::find_if(entities_.begin(), entities_.end(), [&](const auto& e) { return e.id == id; });
  return found == entities_.end() ? nullptr : &*found;
}

const workcell::Entity* PreparedScene::find(const std::string& name) const {
  const auto found = std::find_if(entities_.begin(), entities_.end(), [&](const auto& e) { return e.name == name; });
  return found == entities_.end() ? nullptr : &*found;
}

Pose PreparedScene::partPose(const workcell::Entity& entity, const Pose& X_WE, const std::vector<double>& joints,
                             int link) {
  if (link < 0 || !entity.robot) return X_WE;
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*entity.robot, joints, X_EL);
  return X_WE * X_EL[static_cast<std::size_t>(link)];
}

std::vector<workcell::EffectivePair> PreparedScene::pairsOf(workcell::EntityId moved,
                                                            workcell::OnContact on_contact) const {
  std::vector<workcell::Entity> entities = entities_;
  for (workcell::Entity& entity : entities) {
    if (entity.id == moved) entity.on_contact = on_contact;
  }
  return workcell::effectivePairs(entities, pair_sets_, moved, defaults_);
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
