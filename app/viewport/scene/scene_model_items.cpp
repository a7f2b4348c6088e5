// SPDX-License-Identifier: Apache-2.0
// What is drawn of the scene, and which parts keep their shape in motion.
#include <algorithm>
#include <cmath>

#include "app/viewport/scene/part_colors.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/scene/scene_model.h"
#include "kinematics/model/robot_model.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// m: a ghost so near is not drawn, as kSeen of scene_model.cpp. Half: it flickers in the part; twice: 0.3 mm are not
// seen anyway.
constexpr double kSamePlace = 1.5e-4;

}  // namespace

/// What a stylus holds, or what is chosen alone: what the hand or the eye is at; with all that hangs on it.
std::vector<workcell::EntityId> SceneModel::held() const {
  std::vector<workcell::EntityId> ids;
  if (snapshot_ && snapshot_->stylus.held != 0) ids.push_back(snapshot_->stylus.held);
  if (snapshot_ && snapshot_->second && snapshot_->second->held != 0) ids.push_back(snapshot_->second->held);
  if (selected_.size() == 1) ids.push_back(selected_.front());
  const auto has = [&ids](workcell::EntityId id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const workcell::Entity* carrier = find(ids[i]);
    if (!carrier) continue;
    for (const workcell::Entity& entity : entities_)
      if (!entity.attachment.to.empty() && entity.attachment.to == carrier->name && !has(entity.id))
        ids.push_back(entity.id);
  }
  return ids;
}

/// What is held, and all that is near a part of it.
void SceneModel::markKept(std::vector<RenderItem>& items) const {
  const std::vector<workcell::EntityId> ids = held();
  std::vector<geometry::Bounds> boxes;
  for (RenderItem& item : items) {
    item.keeps_shape = std::find(ids.begin(), ids.end(), item.entity) != ids.end();
    if (item.keeps_shape && !item.unseen) boxes.push_back(geometry::transformed(item.X_WM, item.bounds_M));
  }
  if (boxes.empty()) return;
  for (RenderItem& item : items) {
    const geometry::Bounds box = geometry::transformed(item.X_WM, item.bounds_M);
    item.keeps_shape = item.keeps_shape || std::any_of(boxes.begin(), boxes.end(), [&](const geometry::Bounds& one) {
                         const dvec3 apart = glm::max(glm::max(one.min - box.max, box.min - one.max), dvec3(0.0));
                         return glm::length(apart) < kNearHeld;
                       });
  }
}

void SceneModel::appendShapes(const workcell::Entity& entity, const Pose& X_WE, std::vector<double> joints,
                              std::vector<RenderItem>& items) const {
  const auto add = [&](const std::shared_ptr<const geometry::TriangleMesh>& mesh, const Pose& X_WM,
                       const std::array<float, 3>& color, int link) {
    if (!mesh) return;
    RenderItem item;
    item.mesh = mesh;
    item.bounds_M = boundsOf_M(mesh);
    item.X_WM = X_WM;
    item.color = partColor(color);
    item.entity = entity.id;
    item.link = link;
    items.push_back(std::move(item));
  };
  add(entity.mesh(), X_WE, entity.color, -1);
  if (!entity.robot()) return;
  joints.resize(entity.robot()->dof(), 0.0);
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*entity.robot(), joints, X_BL);
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i) {
    const kinematics::Link& link = entity.robot()->links[i];
    for (const kinematics::LinkShape& shape : link.visuals.empty() ? link.collisions : link.visuals)
      add(shape.mesh, X_WE * X_BL[i] * shape.X_LS, {shape.color[0], shape.color[1], shape.color[2]},
          static_cast<int>(i));
  }
}

void SceneModel::appendSkin(const workcell::Entity& entity, const Skin& skin, std::vector<RenderItem>& items) const {
  const auto looks = looks_.find(entity.id);
  std::vector<PosedSkin::BodyLook> bodies(mannequin::kBodies);
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i) {
    const int body = skin.bodies[i];
    if (body < 0) continue;
    PosedSkin::BodyLook& look = bodies[static_cast<std::size_t>(body)];
    look.state = marks(entity, entity.robot()->links[i].name);
    if (looks == looks_.end()) continue;
    if (const auto own = looks->second.find(static_cast<int>(i)); own != looks->second.end()) look.own = own->second;
  }
  std::vector<double> now = joints(entity);
  now.resize(entity.robot()->dof(), 0.0);
  const Pose X_WE = placement_W(entity);
  for (const RenderItem& item :
       skin.skin->items(mannequin::toPosture(*entity.figure(), {Pose::identity(), now}), bodies)) {
    items.push_back(item);
    items.back().X_WM = X_WE;
    items.back().entity = entity.id;
  }
}

void SceneModel::appendItems(const workcell::Entity& entity, std::vector<RenderItem>& items) const {
  if (const Skin* skin = skinOf(entity)) return appendSkin(entity, *skin, items);
  const std::size_t first = items.size();
  appendShapes(entity, placement_W(entity), joints(entity), items);
  for (std::size_t i = first; i < items.size(); ++i) {
    const int link = items[i].link;
    const auto looks = looks_.find(entity.id);
    if (looks != looks_.end()) {
      if (const auto look = looks->second.find(link); look != looks->second.end()) {
        items[i].color = look->second.color;
        items[i].pattern = look->second.pattern;
      }
    }
    items[i].state =
        marks(entity, link < 0 ? std::string() : entity.robot()->links[static_cast<std::size_t>(link)].name);
  }
}

void SceneModel::appendGhost(const GhostPose& ghost, std::vector<RenderItem>& items) const {
  const workcell::Entity* entity = find(ghost.entity);
  if (!entity) return;
  std::vector<RenderItem> real, ghostly;
  appendShapes(*entity, placement_W(*entity), joints(*entity), real);
  appendShapes(*entity, ghost.X_WE, ghost.joints, ghostly);
  for (std::size_t i = 0; i < ghostly.size(); ++i) {
    // Two shapes in the same place would flicker; the one that is there is enough.
    const Pose X_RG = real[i].X_WM.inverse() * ghostly[i].X_WM;
    if (glm::length(X_RG.p) < kSamePlace && std::abs(X_RG.q.w) > 1.0 - 1e-8) continue;
    ghostly[i].entity = 0;
    ghostly[i].ghost = ghost.touches ? Ghost::kTouches : Ghost::kFree;
    ghostly[i].casts_shadow = false;
    items.push_back(std::move(ghostly[i]));
  }
}

std::vector<RenderItem> SceneModel::items(const StylusLook& stylus) const {
  std::vector<RenderItem> result;
  for (const workcell::Entity& entity : entities_)
    if (entity.visible) appendItems(entity, result);
  markKept(result);
  for (const auto& [owner, ghosts] : ghosts_)
    for (const GhostPose& ghost : ghosts) appendGhost(ghost, result);
  for (const auto& [owner, extras] : extras_) result.insert(result.end(), extras.begin(), extras.end());
  if (stylus.length <= 0.0 || !snapshot_ || !snapshot_->stylus.connected) return result;
  appendStylus(stylus, snapshot_->stylus.X_WStylus, result);
  if (!snapshot_->second || !snapshot_->second->connected) return result;
  static const StylusMesh second = makeSecondStylusMesh();
  const bool dark_theme = stylus.body == penColor(false, true);
  for (const bool band : {false, true}) {
    RenderItem item = result[result.size() - 2];
    item.mesh = band ? second.band : second.body;
    item.bounds_M = item.mesh->bounds();
    item.X_WM = snapshot_->second->X_WStylus;
    if (!band) item.color = penColor(true, dark_theme);
    result.push_back(std::move(item));
  }
  return result;
}

void SceneModel::appendStylus(const StylusLook& look, const Pose& X_WS, std::vector<RenderItem>& items) const {
  for (const bool band : {false, true}) {
    RenderItem item;
    item.mesh = band ? stylus_.band : stylus_.body;
    item.bounds_M = item.mesh->bounds();
    item.X_WM = X_WS;
    item.scale = look.length;
    item.color = band ? look.band : look.body;
    item.casts_shadow = false;
    item.over_scene = true;
    items.push_back(std::move(item));
  }
}

}  // namespace hapticell::app
