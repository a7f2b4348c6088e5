// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/rest_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "collision/queries/freeing_shift.h"
#include "collision/queries/proximity_query.h"
#include "collision/trees/part_tree.h"
#include "geometry/system/in_parallel.h"

namespace hapticell::manipulation {

namespace {

using workcell::Entity;

/// Pairs that are worth a thread of their own, of some 2 us each or more: starting one takes 30 us. Half: small cells take
/// longer; twice: cells of a few large parts are searched by one.
constexpr std::size_t kWorthAThread = 16;

/// rad: joints without limits are tried up to here. Half, twice: as well.
constexpr double kFullTurn = 6.28;

struct PlacedPart {
  const Entity* entity = nullptr;
  const ScenePart* part = nullptr;
  Pose X_WP;
  geometry::Bounds bounds_W;
};

std::vector<PlacedPart> placedParts(const PreparedScene& scene, workcell::EntityId id) {
  std::vector<PlacedPart> placed;
  const Entity* entity = scene.find(id);
  for (const ScenePart& part : scene.partsOf(id)) {
    if (!part.mesh.collider || part.mesh.collider->isEmpty()) continue;
    PlacedPart at{entity, &part, PreparedScene::partPose(*entity, entity->X_WE, entity->joints(), part.link), {}};
    at.bounds_W = geometry::transformed(at.X_WP, part.mesh.collider->bounds());
    placed.push_back(std::move(at));
  }
  return placed;
}

/// At most as far as the boxes are apart.
double leastDistance(const geometry::Bounds& a, const geometry::Bounds& b) {
  return glm::length(glm::max(dvec3(0.0), glm::max(a.min - b.max, b.min - a.max)));
}

/// The entity and all that hangs on it, directly or by others.
std::vector<const Entity*> familyOf(const PreparedScene& scene, const Entity& entity) {
  std::vector<const Entity*> family{&entity};
  for (std::size_t k = 0; k < family.size(); ++k) {
    for (const Entity& other : scene.entities()) {
      const bool known = std::find(family.begin(), family.end(), &other) != family.end();
      if (!known && other.attachment.to == family[k]->name) family.push_back(&other);
    }
  }
  return family;
}

using EntitiesByName = std::unordered_map<std::string_view, workcell::EntityId>;

std::optional<PlacedPart> placedPart(const PreparedScene& scene, const EntitiesByName& ids, const std::string& entity,
                                     const std::string& part) {
  const auto id = ids.find(entity);
  if (id == ids.end()) return std::nullopt;
  for (PlacedPart& one : placedParts(scene, id->second)) {
    if (one.part->name == part) return std::move(one);
  }
  return std::nullopt;
}

Pose poseAt(const PlacedPart& one, int place) {
  const auto& robot = one.entity->robot();
  if (!robot) return one.X_WP;
  return PreparedScene::partPose(*one.entity, one.entity->X_WE, jointsAllOver(*robot, place), one.part->link);
}

/// True where no positions of the joints part them. Joints in closed loops are not free to choose.
bool touchEverywhere(const PlacedPart& a, const PlacedPart& b, collision::ProximityQuery& query) {
  const auto isLoop = [](const PlacedPart& one) { return one.entity->robot() && one.entity->robot()->closure; };
  if (!a.entity->robot() && !b.entity->robot()) return false;
  // What hangs on a link, and one of the other links: as modelled.
  if (a.entity->attachment.to == b.entity->name || b.entity->attachment.to == a.entity->name) return true;
  if (isLoop(a) || isLoop(b)) return false;
  for (int i = 0; i < kTouchPlaces; ++i) {
    if (!query.collides(poseAt(a, i), poseAt(b, i))) return false;
  }
  return true;
}

/// How deep they are in each other, m; 0 if no deeper than kTouchingDepth, or everywhere.
double depthOf(const PlacedPart& a, const PlacedPart& b) {
  // Out of the other's box, along the axis where that is shortest.
  const dvec3 out = glm::min(a.bounds_W.max - b.bounds_W.min, b.bounds_W.max - a.bounds_W.min);
  const double most = std::min({out.x, out.y, out.z});
  if (most <= kTouchingDepth) return 0.0;
  collision::ProximityQuery query(a.part->mesh.collider, b.part->mesh.collider);
  if (!query.collides(a.X_WP, b.X_WP)) return 0.0;
  // Of the surfaces: many links have no bottom, and what they stand on would count as inside.
  const double depth = std::min(collision::freeingShift(query, a.X_WP, b.X_WP).surface_depth, most);
  return depth <= kTouchingDepth || touchEverywhere(a, b, query) ? 0.0 : depth;
}

/// The nearest parts of two entities; nothing where none are nearer than `limit`, or none are checked.
std::optional<PairState> nearestParts(const PreparedScene& scene, const std::vector<PlacedPart>& own,
                                      const workcell::EffectivePair& rule, double limit) {
  PairState nearest;
  nearest.moved = rule.moved;
  nearest.other = rule.other;
  nearest.near_miss_distance = rule.near_miss;
  nearest.distance = limit;
  bool found = false;
  for (const PlacedPart& other : placedParts(scene, rule.other)) {
    for (const PlacedPart& part : own) {
      if (leastDistance(part.bounds_W, other.bounds_W) >= nearest.distance) continue;
      if (!scene.isChecked(*part.part, *other.part)) continue;
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
  return found ? std::optional(nearest) : std::nullopt;
}

}  // namespace

std::vector<PairState> pairsAtRest(const PreparedScene& scene, workcell::EntityId moved, double limit) {
  std::vector<PairState> pairs;
  const Entity* entity = scene.find(moved);
  if (!entity) return pairs;
  const std::vector<const Entity*> family = familyOf(scene, *entity);
  const auto goes_along = [&](workcell::EntityId id) {
    return std::any_of(family.begin(), family.end(), [id](const Entity* one) { return one->id == id; });
  };
  for (const Entity* one : family) {
    const std::vector<PlacedPart> own = placedParts(scene, one->id);
    for (const workcell::EffectivePair& rule : scene.pairsOf(one->id, entity->contact.on_contact)) {
      // Of what goes along only what is carried against the links of what carries it all, as while it is held.
      if (goes_along(rule.other) && (one == entity || rule.other != moved || !entity->robot())) continue;
      if (auto nearest = nearestParts(scene, own, rule, limit)) pairs.push_back(std::move(*nearest));
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return pairs;
}

std::vector<workcell::PairRule> touchingAtRest(const PreparedScene& scene, double tolerance) {
  const std::vector<Entity>& entities = scene.entities();
  std::vector<PlacedPart> parts;
  std::vector<std::size_t> entity_of;
  collision::PartTree tree;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    for (PlacedPart& part : placedParts(scene, entities[i].id)) {
      tree.place(static_cast<std::uint32_t>(parts.size()), part.bounds_W);
      parts.push_back(std::move(part));
      entity_of.push_back(i);
    }
  }
  // In the order of the document: by the two entities, then by their parts.
  using Touching = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>;
  std::vector<Touching> near;
  for (std::size_t a = 0; a < parts.size(); ++a) {
    tree.visitNear(parts[a].bounds_W, tolerance, [&](std::uint32_t b) {
      if (entity_of[b] > entity_of[a]) near.emplace_back(entity_of[a], entity_of[b], a, b);
    });
  }
  std::sort(near.begin(), near.end());
  const workcell::PairFinder pairs(entities, scene.pairs().sets, scene.defaults());
  const auto touches = [&](const Touching& pair) {
    const Entity &entity = entities[std::get<0>(pair)], &other = entities[std::get<1>(pair)];
    const PlacedPart &a = parts[std::get<2>(pair)], &b = parts[std::get<3>(pair)];
    if ((entity.locked && other.locked) || leastDistance(a.bounds_W, b.bounds_W) > tolerance) return false;
    if (!pairs.pairOf(entity, other) || !scene.isChecked(*a.part, *b.part)) return false;
    collision::ProximityQuery query(a.part->mesh.collider, b.part->mesh.collider);
    return query.within(a.X_WP, b.X_WP, tolerance) || query.collides(a.X_WP, b.X_WP);
  };
  // Each by whoever is free, as large meshes take a thousand times as long as small ones.
  std::vector<char> touching(near.size());
  std::atomic<std::size_t> next{0};
  geometry::inRanges(near.size(), geometry::rangesOf(near.size(), kWorthAThread), [&](std::size_t, std::size_t, std::size_t) {
    for (std::size_t k = next++; k < near.size(); k = next++) touching[k] = touches(near[k]) ? 1 : 0;
  });
  std::vector<workcell::PairRule> rules;
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (touching[k] == 0) continue;
    const auto& [i, j, first, second] = near[k];
    rules.push_back(
        {entities[i].name, parts[first].part->name, entities[j].name, parts[second].part->name, false, {}});
  }
  return rules;
}

std::vector<double> jointsAllOver(const kinematics::RobotModel& robot, int i) {
  std::vector<double> joints(robot.dof());
  for (std::size_t v = 0; v < joints.size(); ++v) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[v])];
    const double lower = std::isfinite(joint.lower) ? joint.lower : -kFullTurn;
    const double upper = std::isfinite(joint.upper) ? joint.upper : kFullTurn;
    const double step = std::hypot(1.0, static_cast<double>(v + 1));  // Mostly irrational, so all are passed unevenly.
    joints[v] = lower + std::fmod((i + 1) * step, 1.0) * (upper - lower);
  }
  return joints;
}

std::vector<DeepOverlap> takeDeepOverlaps(const PreparedScene& scene, std::vector<workcell::PairRule>& touching) {
  EntitiesByName ids;
  for (const Entity& entity : scene.entities()) ids.emplace(entity.name, entity.id);
  std::vector<double> depths(touching.size());
  std::atomic<std::size_t> next{0};
  const auto ranges = geometry::rangesOf(touching.size(), kWorthAThread);
  geometry::inRanges(touching.size(), ranges, [&](std::size_t, std::size_t, std::size_t) {
    for (std::size_t k = next++; k < touching.size(); k = next++) {
      const auto a = placedPart(scene, ids, touching[k].first, touching[k].first_part);
      const auto b = placedPart(scene, ids, touching[k].second, touching[k].second_part);
      if (a && b) depths[k] = depthOf(*a, *b);
    }
  });
  std::vector<DeepOverlap> deep;
  std::vector<workcell::PairRule> shallow;
  for (std::size_t k = 0; k < touching.size(); ++k) {
    if (depths[k] > 0.0) {
      deep.push_back({std::move(touching[k]), depths[k]});
    } else {
      shallow.push_back(std::move(touching[k]));
    }
  }
  touching = std::move(shallow);
  std::stable_sort(deep.begin(), deep.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  return deep;
}

}  // namespace hapticell::manipulation
