// SPDX-License-Identifier: Apache-2.0
#include "manipulation/constraint_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "manipulation/symmetric.h"

namespace hapticell::manipulation {

namespace {

constexpr double kSecondsPerWork = 1e-6;

/// How far a part can get while the hand stays within the zone: Frobenius norms bound the largest gain.
double reachOf(const PartDifferential& part, const dvec3& p_WS, double radius, double zone_W, double turn_ahead) {
  double gain = 0.0, turn_gain = 0.0, swing = 0.0, turn_swing = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 v = pointVelocity(part, p_WS, i), w = part.velocity[i].angular;
    const dvec3 v_turn = pointVelocity(part, p_WS, i + 3), w_turn = part.velocity[i + 3].angular;
    gain = std::max(gain, glm::length(v));
    turn_gain += glm::dot(w, w);
    swing += glm::dot(v_turn, v_turn);
    turn_swing = std::max(turn_swing, glm::length(w_turn));
  }
  const double moved = zone_W * (gain + radius * std::sqrt(turn_gain));
  return moved + turn_ahead * (std::sqrt(swing) + radius * turn_swing);
}

PointCondition conditionOf(const collision::ZoneContact& contact) {
  PointCondition condition;
  condition.p_WQ = contact.p_W;
  condition.nhat_W = contact.nhat_W;
  condition.gap = contact.gap;
  condition.normal_moves = contact.normal_moves;
  condition.M = contact.M_W;
  return condition;
}

struct Assembly {
  const ConstraintInputs& inputs;
  std::vector<PartDifferential> differentials;
  std::vector<int> pair_of;  ///< part * obstacles + obstacle -> pair, -1 where unchecked.
  BuiltConstraints& built;
};

void append(BuiltConstraints& built, const haptic::Constraint& constraint, const ConstraintOrigin& origin) {
  if (built.set.count >= haptic::kMaxConstraints) return;
  built.set.constraints[built.set.count++] = constraint;
  built.origins.push_back(origin);
}

void appendContact(Assembly& assembly, const collision::ZoneContact& contact) {
  const ConstraintInputs& in = assembly.inputs;
  const int pair = assembly.pair_of[contact.moving_part * in.obstacles.size() + contact.environment_part];
  if (pair < 0) return;
  const PairFeel& feel = in.feel[static_cast<std::size_t>(pair)];
  const PartDifferential& part = assembly.differentials[contact.moving_part];
  haptic::Constraint constraint;
  constraint.group = contact.group;
  constraint.id = contact.id;
  PointCondition condition = conditionOf(contact);
  condition.gap -= feel.boundary;
  if (condition.M != dmat3(0.0)) {
    // The quadric stands at the surface's foot (moved out by the boundary), the condition at the point.
    const dvec3 bent = condition.M * condition.nhat_W;
    const double gap = condition.gap;
    condition.gap += 0.5 * gap * gap * glm::dot(condition.nhat_W, bent);
    condition.nhat_W += gap * bent;
  }
  applyCondition(part, condition, constraint);
  if (contact.has_trim) {
    PointCondition trim;
    trim.p_WQ = contact.p_W;
    trim.nhat_W = contact.trim_nhat_W;
    trim.gap = contact.trim_gap - feel.boundary;
    applyTrim(part, trim, constraint);
  }
  constraint.stiffness = feel.stiffness;
  constraint.damping = feel.damping;
  constraint.friction = feel.friction;
  in.mapping.toDevice(constraint);
  append(assembly.built, constraint, {pair, -1});
}

std::vector<collision::ZonePart> movingParts(const Assembly& assembly, double zone_W) {
  const ConstraintInputs& in = assembly.inputs;
  std::vector<Pose> X_WP(in.parts.size());
  in.manipulator.partPoses(in.configuration, X_WP);
  std::vector<collision::ZonePart> moving(in.parts.size());
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const geometry::Bounds& bounds = in.parts[k]->bounds();
    moving[k].pieces = in.parts[k];
    moving[k].X_W = X_WP[k];
    moving[k].key = k + 1;
    if (!in.surfaces.empty()) moving[k].surfaces = in.surfaces[k];
    moving[k].reach =
        reachOf(assembly.differentials[k], X_WP[k] * bounds.center(), bounds.radius(), zone_W, in.turn_ahead);
  }
  return moving;
}

}  // namespace

namespace {

/// The set is complete only for small turns: a row that keeps the proxy within them, f = l (a^2 - |theta|^2) / 2a. It
/// has no part in translation, so no force comes of it; the picture lags a wrist that turns faster.
void appendTurnBound(const ConstraintInputs& inputs, BuiltConstraints& built) {
  if (built.set.count == 0 || !inputs.mapping.rotates()) return;
  const double angle = inputs.turn_ahead * std::min(1.0, built.set.zone_radius / inputs.zone_radius);
  haptic::Constraint bound;
  bound.group = built.set.constraints[built.set.count - 1].group + 1;
  bound.id = (std::uint64_t{1} << 63) | (std::uint64_t{1} << 62);
  bound.gap = 0.5 * haptic::kRotationLever * angle;
  for (std::size_t i = 3; i < 6; ++i) bound.curvature[packedIndex(i, i)] = -haptic::kRotationLever / angle;
  append(built, bound, {});
}

void appendLimits(const ConstraintInputs& inputs, std::uint32_t first_group, BuiltConstraints& built) {
  for (std::size_t i = 0; i < built.limits.size(); ++i) {
    haptic::Constraint constraint = built.limits[i].constraint_W;
    constraint.group = first_group + static_cast<std::uint32_t>(i);
    constraint.id |= std::uint64_t{1} << 63;
    inputs.mapping.toDevice(constraint);
    append(built, constraint, {-1, static_cast<int>(i)});
  }
}

}  // namespace

namespace {

/// Two moved parts: the distance changes by the difference of what the motion does to both.
void appendOwn(const ConstraintInputs& inputs, const std::vector<PartDifferential>& parts, std::uint32_t first_group,
               BuiltConstraints& built) {
  constexpr std::size_t kRoom = 20;  // for limits and guides
  for (const auto& [index, found] : inputs.own) {
    const MotionPair& pair = inputs.pairs[index];
    const PairFeel& feel = inputs.feel[index];
    if (!feel.felt || found.colliding || built.set.count + kRoom > haptic::kMaxConstraints) continue;
    haptic::Constraint constraint, met;
    PointCondition condition;
    condition.nhat_W = found.nhat_BA_W;
    condition.p_WQ = found.p_WA;
    applyCondition(parts[pair.part], condition, constraint);
    condition.p_WQ = found.p_WB;
    applyCondition(parts[static_cast<std::size_t>(pair.other_part)], condition, met);
    constraint.gap = found.distance - feel.boundary;
    for (std::size_t i = 0; i < 6; ++i) constraint.gradient[i] -= met.gradient[i];
    for (std::size_t i = 0; i < 21; ++i) constraint.curvature[i] -= met.curvature[i];
    constraint.group = first_group++;
    constraint.id = (std::uint64_t{1} << 60) + index;
    constraint.stiffness = feel.stiffness;
    constraint.damping = feel.damping;
    constraint.friction = feel.friction;
    inputs.mapping.toDevice(constraint);
    append(built, constraint, {static_cast<int>(index), -1});
  }
}

std::uint32_t nextGroup(const BuiltConstraints& built) {
  return built.set.count == 0 ? 0 : built.set.constraints[built.set.count - 1].group + 1;
}

}  // namespace

BuiltConstraints buildConstraints(const ConstraintInputs& inputs) {
  BuiltConstraints built;
  const double scale = inputs.mapping.scale();
  const double zone_W = inputs.zone_radius * scale;
  built.limits = inputs.manipulator.limits(inputs.configuration, zone_W, haptic::kRotationLever * scale);

  Assembly assembly{inputs, inputs.manipulator.differentiate(inputs.configuration), {}, built};
  assembly.pair_of.assign(inputs.parts.size() * inputs.obstacles.size(), -1);
  std::vector<std::uint8_t> mask(assembly.pair_of.size(), 0);
  collision::ZoneOptions options;
  for (std::size_t i = 0; i < inputs.pairs.size(); ++i) {
    if (!inputs.feel[i].felt || inputs.pairs[i].other_part >= 0) continue;
    const std::size_t at = inputs.pairs[i].part * inputs.obstacles.size() + inputs.pairs[i].obstacle;
    assembly.pair_of[at] = static_cast<int>(i);
    mask[at] = 1;
    options.safety_distance = std::max(options.safety_distance, inputs.feel[i].boundary);
  }
  options.radius = zone_W;
  options.max_rotation = inputs.turn_ahead;
  // Room for the limits, the bound of turning and one for whoever adds a row of its own.
  options.max_entries = haptic::kMaxConstraints - 2 - std::min<std::size_t>(built.limits.size(), 16) -
                        std::min<std::size_t>(inputs.own.size(), 8);
  options.pair_mask = mask;
  options.only_complete = inputs.only_complete;
  const std::vector<collision::ZonePart> moving = movingParts(assembly, zone_W);
  const collision::ZoneContacts found = inputs.finder != nullptr
                                            ? inputs.finder->find(moving, inputs.obstacles, options)
                                            : collision::zoneContacts(moving, inputs.obstacles, options);

  built.set.X_DR = inputs.mapping.toDevice(inputs.manipulator.movedFrame(inputs.configuration), inputs.X_DNear);
  built.set.zone_radius = std::max(1e-4, std::min(found.radius, zone_W) / scale);
  built.complete = found.complete;
  built.pending = found.pending;
  built.facets = found.facets;
  built.cost = kSecondsPerWork * static_cast<double>(found.work);
  for (const collision::ZoneContact& contact : found.contacts) appendContact(assembly, contact);
  appendOwn(inputs, assembly.differentials, std::max(found.groups, nextGroup(built)), built);
  appendLimits(inputs, std::max(found.groups, nextGroup(built)), built);
  appendTurnBound(inputs, built);
  return built;
}

BuiltConstraints buildPlainConstraints(const ConstraintInputs& inputs, std::span<const FreeMotion::PairDistance> near) {
  BuiltConstraints built;
  built.complete = false;
  const double scale = inputs.mapping.scale();
  built.limits =
      inputs.manipulator.limits(inputs.configuration, inputs.zone_radius * scale, haptic::kRotationLever * scale);
  const std::vector<PartDifferential> parts = inputs.manipulator.differentiate(inputs.configuration);
  built.set.X_DR = inputs.mapping.toDevice(inputs.manipulator.movedFrame(inputs.configuration), inputs.X_DNear);
  built.set.zone_radius = inputs.zone_radius;
  std::uint32_t group = 0;
  for (const auto& [pair, found] : near) {
    const PairFeel& feel = inputs.feel[pair];
    if (!feel.felt || found.colliding || group + 20 > haptic::kMaxConstraints) continue;
    if (inputs.pairs[pair].other_part >= 0) continue;
    haptic::Constraint constraint;
    PointCondition condition;
    condition.p_WQ = found.p_WA;
    condition.nhat_W = found.nhat_BA_W;
    condition.gap = found.distance - feel.boundary;
    applyCondition(parts[inputs.pairs[pair].part], condition, constraint);
    constraint.group = group++;
    constraint.id = pair + 1;
    constraint.stiffness = feel.stiffness;
    constraint.damping = feel.damping;
    constraint.friction = feel.friction;
    inputs.mapping.toDevice(constraint);
    append(built, constraint, {static_cast<int>(pair), -1});
  }
  appendOwn(inputs, parts, group, built);
  appendLimits(inputs, std::max(group, nextGroup(built)), built);
  appendTurnBound(inputs, built);
  return built;
}

void pairGaps(const BuiltConstraints& built, const Pose& X_DP, std::span<double> gaps) {
  std::fill(gaps.begin(), gaps.end(), std::numeric_limits<double>::infinity());
  const Twist t = difference(X_DP, built.set.X_DR);
  const haptic::Vector6 xi{t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
  for (std::size_t first = 0; first < built.set.count;) {
    double best = -std::numeric_limits<double>::infinity();
    std::size_t last = first;
    for (; last < built.set.count && built.set.constraints[last].group == built.set.constraints[first].group; ++last) {
      const haptic::Constraint& entry = built.set.constraints[last];
      double value = haptic::evaluate(entry, xi);
      if (entry.has_trim) {
        double trim = entry.trim_gap;
        for (std::size_t i = 0; i < 6; ++i) trim += entry.trim_gradient[i] * xi[i];
        value = std::min(value, trim);
      }
      best = std::max(best, value);
    }
    const int pair = built.origins[first].pair;
    if (pair >= 0) {
      double& gap = gaps[static_cast<std::size_t>(pair)];
      gap = std::min(gap, best);
    }
    first = last;
  }
}

}  // namespace hapticell::manipulation
