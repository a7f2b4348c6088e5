// SPDX-License-Identifier: Apache-2.0
#include "access/removal_scene.h"

#include <algorithm>
#include <map>
#include <set>

#include "access/ordered.h"
#include "access/thinned_mesh.h"
#include "geometry/system/in_parallel.h"
#include "geometry/system/listed.h"

namespace hapticell::access {

namespace {

using manipulation::PreparedScene;
using manipulation::ScenePart;
using workcell::Entity;
using workcell::EntityId;
using workcell::EntityKind;

/// m beyond the box's side at which a part counts as out. Half and twice: not felt.
constexpr double kBeyond = 1e-3;
/// Entities above each other; a chain that is longer is a ring. Half and twice: no document has so many.
constexpr int kMostLevels = 1000;

/// What `entity` is below, itself first: by its parents, up to the topmost name.
std::vector<std::string> chainOf(const PreparedScene& scene, const Entity& entity) {
  std::vector<std::string> names{entity.name};
  const Entity* at = &entity;
  for (int level = 0; level < kMostLevels && at != nullptr && !at->parent.empty(); ++level) {
    names.push_back(at->parent);
    at = scene.find(at->parent);
  }
  return names;
}

/// What carries it, in the end; `part` is carried by nobody, because it is taken off.
const Entity& rootOf(const PreparedScene& scene, const Entity& entity, const Entity& part) {
  const Entity* at = &entity;
  for (int level = 0; level < kMostLevels && at->id != part.id && !at->attachment.to.empty(); ++level) {
    const Entity* carrier = scene.find(at->attachment.to);
    if (carrier == nullptr) break;
    at = carrier;
  }
  return *at;
}

tl::unexpected<Error> wrongPart(Text found, Text expected, Text fix = {}) {
  return makeError({.place = "--part", .found = std::move(found), .expected = std::move(expected), .fix = std::move(fix)});
}

double gapOf(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::length(glm::max(glm::max(a.min - b.max, b.min - a.max), dvec3(0.0)));
}

Expected<const Entity*> partNamed(const PreparedScene& scene, const std::string& name) {
  const Entity* part = scene.find(name);
  if (part == nullptr) {
    std::vector<std::string> solids;
    for (const Entity& one : scene.entities())
      if (one.kind() == EntityKind::kSolid) solids.push_back(one.name);
    return wrongPart(Text("no part is named '%1'", name), Text("one of %1", listed(solids)));
  }
  if (part->kind() != EntityKind::kSolid || scene.partsOf(part->id).empty())
    return wrongPart(Text("'%1' has no shape of its own that can be taken out", name), Text("a solid"));
  if (part->locked)
    return wrongPart(Text("'%1' is locked", name), Text("a part that can be moved"),
                     Text("Unlock it, or ask for another part."));
  return part;
}

}  // namespace

Expected<RemovalScene> RemovalScene::make(std::shared_ptr<const PreparedScene> scene, const std::string& part,
                                          const std::string& within, double tolerance) {
  const auto entity = partNamed(*scene, part);
  HAPTICELL_TRY(entity);
  RemovalScene made;
  made.scene_ = std::move(scene);
  made.tolerance_ = tolerance;
  HAPTICELL_TRY(made.choose(**entity, within));
  made.addUnits(**entity);
  made.thin(tolerance);
  return made;
}

Expected<void> RemovalScene::choose(const Entity& part, const std::string& within) {
  const auto chain = chainOf(*scene_, part);
  const std::string top = within.empty() && chain.size() > 1 ? chain.back() : within;
  const bool known = top.empty() || std::any_of(scene_->entities().begin(), scene_->entities().end(), [&](const auto& one) {
    return one.name == top || one.parent == top;
  });
  if (!known)
    return makeError({.place = "--within",
                      .found = Text("no assembly is named '%1'", top),
                      .expected = Text("an assembly that holds '%1'", part.name)});
  if (!top.empty() && std::find(chain.begin(), chain.end(), top) == chain.end())
    return makeError({.place = "--within",
                      .found = Text("'%1' is not below '%2'", part.name, top),
                      .expected = Text("an assembly that holds '%1'", part.name)});
  for (const Entity& entity : scene_->entities()) {
    if (entity.kind() != EntityKind::kSolid || !entity.checked) continue;
    const auto names = chainOf(*scene_, entity);
    if (top.empty() || std::find(names.begin(), names.end(), top) != names.end()) assembly_.push_back(entity.id);
  }
  return {};
}

void RemovalScene::addUnits(const Entity& part) {
  std::map<EntityId, RemovalUnit> units;
  for (const ScenePart& one : scene_->parts()) {
    const Entity& owner = *scene_->find(one.entity);
    const Entity& root = rootOf(*scene_, owner, part);
    if (!owner.checked || root.kind() == EntityKind::kMannequin || owner.kind() == EntityKind::kMannequin) continue;
    RemovalUnit& unit = units[root.id];
    unit.entity = root.id;
    unit.name = root.name;
    RemovalUnit::Part placed{&one, PreparedScene::partPose(owner, owner.X_WE, owner.joints(), one.link), nullptr, {}};
    placed.bounds_W = geometry::transformed(placed.X_WP, one.mesh.collider->bounds());
    if (placed.bounds_W.isEmpty()) continue;
    unit.bounds_W.add(placed.bounds_W);
    if (std::find(assembly_.begin(), assembly_.end(), owner.id) != assembly_.end()) box_W_.add(placed.bounds_W);
    unit.parts.push_back(std::move(placed));
  }
  const auto isMovable = [&](const RemovalUnit& unit) {
    const Entity& entity = *scene_->find(unit.entity);
    return unit.entity == part.id ||
           (entity.kind() == EntityKind::kSolid && !entity.locked &&
            std::find(assembly_.begin(), assembly_.end(), unit.entity) != assembly_.end());
  };
  const geometry::Bounds about = units[part.id].bounds_W;
  std::vector<RemovalUnit> standing;
  for (auto& [id, unit] : units) {
    if (unit.parts.empty()) continue;
    (isMovable(unit) ? units_ : standing).push_back(std::move(unit));
  }
  // The part itself first, then the nearest: beyond kMostMovable they count as fixed.
  units_ = ordered(std::move(units_), [&](const RemovalUnit& unit) {
    return std::pair(unit.entity != part.id, gapOf(unit.bounds_W, about));
  });
  movable_ = std::min(units_.size(), kMostMovable);
  if (units_.size() > movable_)
    notes_.push_back(Text("Only the %1 nearest parts of %2 can go first in this answer; the others count as fixed.",
                          movable_, units_.size()));
  units_.insert(units_.end(), std::make_move_iterator(standing.begin()), std::make_move_iterator(standing.end()));
}

void RemovalScene::thin(double tolerance) {
  std::vector<RemovalUnit::Part*> parts;
  for (std::size_t u = 0; u < movable_; ++u)
    for (RemovalUnit::Part& part : units_[u].parts) parts.push_back(&part);
  geometry::inRanges(parts.size(), geometry::rangesOf(parts.size(), 1),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) {
                         const auto& mesh = parts[i]->part->mesh.collider->mesh();
                         parts[i]->thin = collision::MeshCollider::build(thinned(mesh, tolerance));
                       }
                     });
}

bool RemovalScene::areChecked(const RemovalUnit::Part& a, const RemovalUnit::Part& b) const {
  const workcell::PairRule* rule = scene_->ruleFor(*a.part, *b.part);
  return rule == nullptr || rule->checked;
}

double RemovalScene::wayOut(std::size_t unit, const dvec3& direction_W) const {
  const geometry::Bounds& own = units_[unit].bounds_W;
  double way = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (direction_W[i] > 1e-6) way = std::min(way, (box_W_.max[i] - own.min[i]) / direction_W[i]);
    if (direction_W[i] < -1e-6) way = std::min(way, (own.max[i] - box_W_.min[i]) / -direction_W[i]);
  }
  return way + kBeyond;
}

}  // namespace hapticell::access
