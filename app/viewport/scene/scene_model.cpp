// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/scene_model.h"

#include <algorithm>
#include <cmath>

#include "mannequin/shape/figure_model.h"
#include "workcell/entity/pair_policy.h"

namespace hapticell::app {
namespace {

// m and rad: a stylus that is held still trembles by its encoder's steps. Half: an idle scene is drawn for it; twice:
// slow motions are seen in steps.
constexpr double kSeen = 1.5e-4;

bool sameScene(const manipulation::SceneSnapshot& a, const manipulation::SceneSnapshot& b) {
  const auto samePose = [](const Pose& x, const Pose& y) {
    return glm::length(x.p - y.p) < kSeen && std::abs(glm::dot(x.q, y.q)) > 1.0 - 1e-7;
  };
  const auto sameJoint = [](double x, double y) { return std::abs(x - y) < kSeen; };
  const auto sameEntity = [&](const manipulation::EntityState& x, const manipulation::EntityState& y) {
    return x.id == y.id && samePose(x.X_WE, y.X_WE) &&
           std::equal(x.joints.begin(), x.joints.end(), y.joints.begin(), y.joints.end(), sameJoint);
  };
  const auto samePair = [](const manipulation::PairState& x, const manipulation::PairState& y) {
    return x.other == y.other && x.other_part == y.other_part && x.contact == y.contact && x.near_miss == y.near_miss;
  };
  // Pairs that touch equally hard change places all the time; what is drawn is who is marked.
  const auto sameMarks = [&](const manipulation::SceneSnapshot& x, const manipulation::SceneSnapshot& y) {
    return std::all_of(x.pairs.begin(), x.pairs.end(), [&](const auto& p) {
      return !(p.contact || p.near_miss) ||
             std::any_of(y.pairs.begin(), y.pairs.end(), [&](const auto& q) { return samePair(p, q); });
    });
  };
  const auto secondPen = [](const manipulation::SceneSnapshot& s) {
    return s.second && s.second->connected ? s.second->X_WStylus : Pose::identity();
  };
  return samePose(a.stylus.X_WStylus, b.stylus.X_WStylus) && samePose(secondPen(a), secondPen(b)) &&
         a.stylus.held == b.stylus.held && a.stylus.connected == b.stylus.connected &&
         std::equal(a.entities.begin(), a.entities.end(), b.entities.begin(), b.entities.end(), sameEntity) &&
         sameMarks(a, b) && sameMarks(b, a);
}

}  // namespace

bool GhostPose::operator==(const GhostPose& other) const {
  return entity == other.entity && X_WE.p == other.X_WE.p && X_WE.q == other.X_WE.q && joints == other.joints &&
         touches == other.touches;
}

SceneModel::SceneModel() : stylus_(makeStylusMesh()) {}

void SceneModel::setEntities(std::vector<workcell::Entity> entities) {
  entities_ = std::move(entities);
  std::map<std::shared_ptr<const geometry::TriangleMesh>, geometry::Bounds> bounds;
  const auto note = [&](const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
    if (mesh && !bounds.contains(mesh)) bounds.emplace(mesh, boundsOf_M(mesh));
  };
  for (const workcell::Entity& entity : entities_) {
    note(entity.mesh());
    if (!entity.robot()) continue;
    for (const kinematics::Link& link : entity.robot()->links)
      for (const auto& shape : link.visuals.empty() ? link.collisions : link.visuals) note(shape.mesh);
  }
  mesh_bounds_ = std::move(bounds);
  ++revision_;
}

void SceneModel::setPairSets(std::vector<workcell::PairSet> sets) {
  pair_sets_ = std::move(sets);
  coloured_sets_.clear();
  for (const workcell::PairSet& set : pair_sets_)
    if ((set.contact_color || set.near_miss_color) && coloured_sets_.size() + 1 < kSetColors)
      coloured_sets_.push_back(set);
  ++revision_;
}

/// Which set's colours the pair has, as bits of the state.
std::uint32_t SceneModel::setColorOf(const manipulation::PairState& pair) const {
  if (coloured_sets_.empty()) return 0;
  const workcell::PairSet* set = workcell::lastSetFor(entities_, pair_sets_, pair.moved, pair.other);
  const auto own = std::find_if(coloured_sets_.begin(), coloured_sets_.end(),
                                [&](const auto& coloured) { return set && coloured.name == set->name; });
  if (own == coloured_sets_.end()) return 0;
  return static_cast<std::uint32_t>(own - coloured_sets_.begin() + 1) << kSetColorShift;
}

void SceneModel::setSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  // Against what was shown, not against the one before: slow motion adds up.
  const bool same = snapshot.has_value() == shown_.has_value() && (!snapshot || sameScene(*snapshot, *shown_));
  snapshot_ = snapshot;
  if (same) return;
  shown_ = snapshot;
  ++revision_;
}

void SceneModel::setSelected(std::vector<workcell::EntityId> entities) {
  if (entities == selected_) return;
  selected_ = std::move(entities);
  ++revision_;
}

void SceneModel::setHovered(workcell::EntityId entity) {
  if (entity == hovered_) return;
  hovered_ = entity;
  ++revision_;
}

bool SceneModel::isSelected(workcell::EntityId entity) const {
  return std::find(selected_.begin(), selected_.end(), entity) != selected_.end();
}

void SceneModel::setGhosts(const std::string& owner, std::vector<GhostPose> ghosts) {
  const auto known = ghosts_.find(owner);
  if (known == ghosts_.end() ? ghosts.empty() : known->second == ghosts) return;
  ghosts_[owner] = std::move(ghosts);
  ++revision_;
}

std::vector<GhostPose> SceneModel::ghosts() const {
  std::vector<GhostPose> all;
  for (const auto& [owner, ghosts] : ghosts_) all.insert(all.end(), ghosts.begin(), ghosts.end());
  return all;
}

void SceneModel::setLinkLooks(workcell::EntityId entity, std::map<int, LinkLook> looks) {
  const auto known = looks_.find(entity);
  if (known == looks_.end() ? looks.empty() : known->second == looks) return;
  if (looks.empty()) {
    looks_.erase(entity);
  } else {
    looks_[entity] = std::move(looks);
  }
  ++revision_;
}

std::map<int, LinkLook> SceneModel::linkLooks(workcell::EntityId entity) const {
  const auto known = looks_.find(entity);
  return known == looks_.end() ? std::map<int, LinkLook>{} : known->second;
}

void SceneModel::setExtras(const std::string& owner, std::vector<RenderItem> extras) {
  if (extras.empty() && !extras_.contains(owner)) return;
  for (RenderItem& item : extras) {
    item.bounds_M = item.mesh->bounds();
    item.entity = 0;
    item.casts_shadow = false;
  }
  if (extras.empty()) {
    extras_.erase(owner);
  } else {
    extras_[owner] = std::move(extras);
  }
  ++revision_;
}

void SceneModel::setSkin(const workcell::Entity& entity, std::shared_ptr<const mannequin::FigureSkin> skin) {
  ++revision_;
  skins_.erase(entity.id);
  if (!skin || !entity.robot() || !entity.figure()) return;
  Skin& own = skins_[entity.id];
  own.figure = entity.figure();
  for (std::size_t i = 0; i < entity.robot()->links.size(); ++i)
    own.bodies.push_back(mannequin::bodyOfLink(*entity.robot(), static_cast<int>(i)));
  own.skin = std::make_shared<PosedSkin>(std::move(skin));
}

const SceneModel::Skin* SceneModel::skinOf(const workcell::Entity& entity) const {
  const auto found = skins_.find(entity.id);
  if (found == skins_.end() || !entity.robot() || found->second.figure != entity.figure()) return nullptr;
  if (found->second.bodies.size() != entity.robot()->links.size()) return nullptr;
  return &found->second;
}

void SceneModel::forgetCell() {
  ghosts_.clear();
  looks_.clear();
  extras_.clear();
  skins_.clear();
  played_.clear();
  hovered_ = 0;
  ++revision_;
}

void SceneModel::setPlayed(std::vector<GhostPose> played) {
  if (played == played_) return;
  played_ = std::move(played);
  ++revision_;
}

const GhostPose* SceneModel::playedOf(workcell::EntityId id) const {
  const auto found = std::find_if(played_.begin(), played_.end(), [id](const auto& p) { return p.entity == id; });
  return found == played_.end() ? nullptr : &*found;
}

const workcell::Entity* SceneModel::find(workcell::EntityId id) const {
  const auto found = std::find_if(entities_.begin(), entities_.end(), [id](const auto& e) { return e.id == id; });
  return found == entities_.end() ? nullptr : &*found;
}

const manipulation::EntityState* SceneModel::stateOf(workcell::EntityId id) const {
  if (!snapshot_) return nullptr;
  const auto& states = snapshot_->entities;
  const auto found = std::find_if(states.begin(), states.end(), [id](const auto& s) { return s.id == id; });
  return found == states.end() ? nullptr : &*found;
}

Pose SceneModel::placement_W(const workcell::Entity& entity) const {
  if (const GhostPose* played = playedOf(entity.id)) return played->X_WE;
  const manipulation::EntityState* state = stateOf(entity.id);
  return state ? state->X_WE : entity.X_WE;
}

std::vector<double> SceneModel::joints(const workcell::Entity& entity) const {
  if (const GhostPose* played = playedOf(entity.id)) return played->joints;
  const manipulation::EntityState* state = stateOf(entity.id);
  return state && state->joints.size() == entity.joints().size() ? state->joints : entity.joints();
}

std::uint32_t SceneModel::marks(const workcell::Entity& entity, const std::string& part) const {
  std::uint32_t state = kPlain;
  const bool held = snapshot_ && snapshot_->stylus.held == entity.id;
  if (held || std::find(selected_.begin(), selected_.end(), entity.id) != selected_.end()) state |= kSelected;
  if (entity.id == hovered_) state |= kHovered;
  if (!snapshot_) return state;
  for (const auto& pair : snapshot_->pairs) {
    if (pair.other != entity.id || (!pair.other_part.empty() && pair.other_part != part)) continue;
    if (!pair.contact && !pair.near_miss) continue;
    // A contact is louder than a near miss of another set.
    if (pair.contact && !(state & kContact)) state &= (1u << kSetColorShift) - 1;
    if (!(state >> kSetColorShift) && (pair.contact || !(state & kContact))) state |= setColorOf(pair);
    state |= pair.contact ? kContact : kNearMiss;
  }
  return state;
}

geometry::Bounds SceneModel::boundsOf_M(const std::shared_ptr<const geometry::TriangleMesh>& mesh) const {
  const auto known = mesh_bounds_.find(mesh);
  return known != mesh_bounds_.end() ? known->second : mesh->bounds();
}

geometry::Bounds SceneModel::bounds_W() const {
  geometry::Bounds bounds;
  for (const workcell::Entity& entity : entities_)  // A frame has nothing that is lit or cut.
    if (entity.visible && entity.kind() != workcell::EntityKind::kFrame) bounds.add(boundsOf_W(entity.id));
  return bounds;
}

std::vector<dvec3> SceneModel::corners_W() const {
  std::vector<dvec3> corners;
  for (const RenderItem& item : items({})) {
    const geometry::Bounds& box = item.bounds_M;
    if (box.isEmpty()) continue;
    for (int i = 0; i < 8; ++i) {
      corners.push_back(item.X_WM * dvec3((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                                          (i & 4) ? box.max.z : box.min.z));
    }
  }
  for (const workcell::Entity& entity : entities_)
    if (entity.visible && entity.kind() == workcell::EntityKind::kFrame) corners.push_back(placement_W(entity).p);
  return corners;
}

geometry::Bounds SceneModel::boundsOf_W(workcell::EntityId id) const {
  geometry::Bounds bounds;
  const workcell::Entity* entity = find(id);
  if (!entity) return bounds;
  if (entity->kind() == workcell::EntityKind::kFrame) {  // What one sees of it when it is looked for.
    // m about a thing without shape, to zoom to; our choice. Half, twice: nearer or farther.
    constexpr dvec3 kAround{0.1};
    const dvec3 p_W = placement_W(*entity).p;
    bounds.add(p_W - kAround);
    bounds.add(p_W + kAround);
    return bounds;
  }
  std::vector<RenderItem> items;
  appendItems(*entity, items);
  for (const RenderItem& item : items) bounds.add(geometry::transformed(item.X_WM, item.bounds_M));
  return bounds;
}

std::string SceneModel::nameOf(workcell::EntityId id, const std::string& part) const {
  const workcell::Entity* entity = find(id);
  if (!entity) return part;
  return part.empty() ? entity->name : entity->name + ", " + part;
}

}  // namespace hapticell::app
