// SPDX-License-Identifier: Apache-2.0
#include "manipulation/rest_pairs.h"

#include <algorithm>

#include "collision/proximity_query.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;

struct PlacedPart {
  const ScenePart* part = nullptr;
  Pose X_WP;
  geometry::Bounds bounds_W;
};

std::vector<PlacedPart> placedParts(const PreparedScene& scene, workcell::EntityId id) {
  std::vector<PlacedPart> placed;
  const Entity* entity = scene.find(id);
  for (const ScenePart& part : scene.parts()) {
    if (part.entity != id || !entity || !part.mesh.collider) continue;
    PlacedPart at{&part, PreparedScene::partPose(*entity, entity->X_WE, entity->joints, part.link), {}};
    at.bounds_W = geometry::transformed(at.X_WP, part.mesh.collider->bounds());
    placed.push_back(std::move(at));
  }
  return placed;
}

/// At most as far as the boxes are apart.
double leastDistance(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::length(glm::max(dvec3(0.0), glm::max(a.min - b.max, b.min - a.max)));
}

bool hangsOn(const PreparedScene& scene, const Entity& entity, const Entity& other) {
  const Entity* carrier = &entity;
  for (std::size_t steps = 0; carrier && !carrier->attachment.to.empty() && steps < scene.entities().size(); ++steps) {
    carrier = scene.find(carrier->attachment.to);
    if (carrier && carrier->id == other.id) return true;
  }
  return false;
}

bool leftOut(const PreparedScene& scene, const PlacedPart& a, const PlacedPart& b) {
  const workcell::PairRule* rule = scene.ruleFor(*a.part, *b.part);
  return rule && !rule->checked;
}

}  // namespace

std::vector<PairState> pairsAtRest(const PreparedScene& scene, workcell::EntityId moved, double limit) {
  std::vector<PairState> pairs;
  const Entity* entity = scene.find(moved);
  if (!entity) return pairs;
  const std::vector<PlacedPart> own = placedParts(scene, moved);
  for (const workcell::EffectivePair& rule : scene.pairsOf(moved, entity->on_contact)) {
    PairState nearest;
    nearest.moved = moved;
    nearest.other = rule.other;
    nearest.near_miss_distance = rule.near_miss;
    nearest.distance = limit;
    bool found = false;
    for (const PlacedPart& other : placedParts(scene, rule.other)) {
      for (const PlacedPart& part : own) {
        if (leastDistance(part.bounds_W, other.bounds_W) >= nearest.distance || leftOut(scene, part, other)) continue;
        const collision::DistanceResult result = collision::distance(
            part.part->mesh.collider, part.X_WP, other.part->mesh.collider, other.X_WP, nearest.distance);
        if (result.beyond_limit) continue;
        found = true;
        nearest.distance = result.distance;
        nearest.moved_part = part.part->name;
        nearest.other_part = other.part->name;
        nearest.p_WA = result.p_WA;
        nearest.p_WB = result.p_WB;
        nearest.contact = result.colliding || result.distance <= rule.safety_distance;
      }
    }
    nearest.near_miss = nearest.distance < rule.near_miss;
    if (found) pairs.push_back(std::move(nearest));
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return pairs;
}

std::vector<workcell::PairRule> touchingAtRest(const PreparedScene& scene, double tolerance) {
  std::vector<workcell::PairRule> rules;
  std::vector<std::vector<PlacedPart>> parts;
  for (const Entity& entity : scene.entities()) parts.push_back(placedParts(scene, entity.id));
  const auto index = [&](workcell::EntityId id) {
    return static_cast<std::size_t>(scene.find(id) - scene.entities().data());
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Entity& entity = scene.entities()[i];
    if (parts[i].empty()) continue;
    for (const workcell::EffectivePair& pair : scene.pairsOf(entity.id, entity.on_contact)) {
      const std::size_t j = index(pair.other);
      const Entity& other = scene.entities()[j];
      if (j < i || (entity.locked && other.locked) || hangsOn(scene, entity, other) || hangsOn(scene, other, entity))
        continue;
      for (const PlacedPart& a : parts[i]) {
        for (const PlacedPart& b : parts[j]) {
          if (leastDistance(a.bounds_W, b.bounds_W) > tolerance || leftOut(scene, a, b)) continue;
          collision::ProximityQuery query(a.part->mesh.collider, b.part->mesh.collider);
          if (!query.within(a.X_WP, b.X_WP, tolerance) && !query.collides(a.X_WP, b.X_WP)) continue;
          rules.push_back({entity.name, a.part->name, other.name, b.part->name, false, {}});
        }
      }
    }
  }
  return rules;
}

}  // namespace hapticell::manipulation
