// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/constraint_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

/// s: a unit of ZoneContacts::work, about a microsecond. Half: dear sets are made too often; twice: too seldom (they
/// get half of the time).
constexpr double kSecondsPerWork = 1e-6;
constexpr std::uint64_t kTurnBoundId = (std::uint64_t{1} << 63) | (std::uint64_t{1} << 62);

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

void append(BuiltConstraints& built, const haptic::Constraint& constraint, const ConstraintOrigin& origin) {
  if (built.set.count >= haptic::kMaxConstraints) return;
  built.set.constraints[built.set.count++] = constraint;
  built.origins.push_back(origin);
}

/// The gap's quadric, which stands where the surface's foot is (moved out by the boundary), as one about the point;
/// `gone_W`: of the obstacle since.
void moveToPoint(PointCondition& condition, const dvec3& gone_W) {
  const dvec3 e = condition.M == dmat3(0.0) ? -gone_W : condition.gap * condition.nhat_W - gone_W;
  const dvec3 bent = condition.M * e;
  condition.gap -= glm::dot(condition.nhat_W, gone_W);
  condition.gap += 0.5 * glm::dot(e, bent);
  condition.nhat_W += bent;
}

void appendContact(const ConstraintDraft& draft, const collision::ZoneContact& contact, const dvec3& gone_W,
                   BuiltConstraints& built) {
  const int pair = draft.pair_of[contact.moving_part * draft.obstacles + contact.environment_part];
  if (pair < 0) return;
  const PairFeel& feel = draft.feel[static_cast<std::size_t>(pair)];
  const PartDifferential& part = draft.differentials[contact.moving_part];
  haptic::Constraint constraint;
  constraint.group = contact.group;
  constraint.id = contact.id;
  PointCondition condition = conditionOf(contact);
  condition.gap -= feel.boundary;
  moveToPoint(condition, gone_W);
  applyCondition(part, condition, constraint);
  if (contact.has_trim) {
    PointCondition trim;
    trim.p_WQ = contact.p_W;
    trim.nhat_W = contact.trim_nhat_W;
    trim.gap = contact.trim_gap - feel.boundary - glm::dot(trim.nhat_W, gone_W);
    applyTrim(part, trim, constraint);
  }
  constraint.stiffness = feel.stiffness;
  constraint.damping = feel.damping;
  constraint.friction = feel.friction;
  draft.mapping.toDevice(constraint);
  append(built, constraint, {pair, -1});
}

std::vector<collision::ZonePart> movingParts(const ConstraintInputs& in,
                                             const std::vector<PartDifferential>& differentials, double zone_W) {
  std::vector<Pose> X_WP(in.parts.size());
  in.manipulator.partPoses(in.configuration, X_WP);
  std::vector<collision::ZonePart> moving(in.parts.size());
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const geometry::Bounds& bounds = in.parts[k]->bounds();
    moving[k].pieces = in.parts[k];
    moving[k].X_W = X_WP[k];
    moving[k].key = k + 1;
    if (!in.surfaces.empty()) moving[k].surfaces = in.surfaces[k];
    moving[k].reach = reachOf(differentials[k], X_WP[k] * bounds.center(), bounds.radius(), zone_W, in.turn_ahead);
  }
  return moving;
}

/// What completes a set once its contacts are in it.
struct Rest {
  const MotionMapping& mapping;
  double zone_radius, turn_ahead;
};

/// The set is complete only for small turns: a row that keeps the proxy within them, f = l (a^2 - |theta|^2) / 2a. It
/// has no part in translation, so no force comes of it; the picture lags a wrist that turns faster.
void appendTurnBound(const Rest& rest, BuiltConstraints& built) {
  if (built.set.count == 0 || !rest.mapping.rotates()) return;
  const double angle = rest.turn_ahead * std::min(1.0, built.set.zone_radius / rest.zone_radius);
  haptic::Constraint bound;
  bound.group = built.set.constraints[built.set.count - 1].group + 1;
  bound.id = kTurnBoundId;
  built.turn = angle;
  bound.gap = 0.5 * haptic::kRotationLever * angle;
  for (std::size_t i = 3; i < 6; ++i) bound.curvature[packedIndex(i, i)] = -haptic::kRotationLever / angle;
  append(built, bound, {});
}

void appendLimits(const MotionMapping& mapping, std::uint32_t first_group, BuiltConstraints& built) {
  for (std::size_t i = 0; i < built.limits.size(); ++i) {
    haptic::Constraint constraint = built.limits[i].constraint_W;
    constraint.group = first_group + static_cast<std::uint32_t>(i);
    constraint.id |= std::uint64_t{1} << 63;
    mapping.toDevice(constraint);
    append(built, constraint, {-1, static_cast<int>(i)});
  }
}

/// Two moved parts, whose distance changes by the difference of what the motion does to both; and the ways out.
std::vector<ConstraintDraft::OwnRow> ownRows(const ConstraintInputs& inputs,
                                             const std::vector<PartDifferential>& parts) {
  std::vector<ConstraintDraft::OwnRow> rows;
  for (const auto& [index, found] : inputs.own) {
    const MotionPair& pair = inputs.pairs[index];
    const PairFeel& feel = inputs.feel[index];
    if (!feel.felt || found.colliding) continue;
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
    constraint.id = (std::uint64_t{1} << 60) + index;
    constraint.stiffness = feel.stiffness;
    constraint.damping = feel.damping;
    constraint.friction = feel.friction;
    inputs.mapping.toDevice(constraint);
    rows.push_back({constraint, static_cast<int>(index)});
  }
  for (const FreeingPlane& plane : inputs.freeing) {
    haptic::Constraint constraint;
    PointCondition condition;
    condition.p_WQ = plane.p_W;
    condition.nhat_W = plane.nhat_W;
    condition.gap = plane.gap;
    applyCondition(parts[inputs.pairs[plane.pair].part], condition, constraint);
    constraint.id = (std::uint64_t{1} << 59) + plane.pair;
    inputs.mapping.toDevice(constraint);
    rows.push_back({constraint, static_cast<int>(plane.pair)});
  }
  return rows;
}

void appendOwn(const std::vector<ConstraintDraft::OwnRow>& rows, std::uint32_t first_group, BuiltConstraints& built) {
  /// Entries left for limits and guides: six joints have twelve, a guide up to six. Half: a limit may be left out in
  /// crowds; twice: own pairs are.
  constexpr std::size_t kRoom = 20;
  for (const ConstraintDraft::OwnRow& row : rows) {
    if (built.set.count + kRoom > haptic::kMaxConstraints) return;
    append(built, row.constraint, {row.pair, -1});
    built.set.constraints[built.set.count - 1].group = first_group++;
  }
}

std::uint32_t nextGroup(const BuiltConstraints& built) {
  return built.set.count == 0 ? 0 : built.set.constraints[built.set.count - 1].group + 1;
}

}  // namespace

ConstraintDraft draftConstraints(const ConstraintInputs& inputs) {
  ConstraintDraft draft;
  const double scale = inputs.mapping.scale();
  const double zone_W = inputs.zone_radius * scale;
  draft.limits = inputs.manipulator.limits(inputs.configuration, zone_W, haptic::kRotationLever * scale);
  draft.differentials = inputs.manipulator.differentiate(inputs.configuration);
  draft.mapping = inputs.mapping;
  draft.zone_radius = inputs.zone_radius;
  draft.turn_ahead = inputs.turn_ahead;
  draft.feel.assign(inputs.feel.begin(), inputs.feel.end());
  draft.obstacles = inputs.obstacles.size();
  draft.pair_of.assign(inputs.parts.size() * inputs.obstacles.size(), -1);
  draft.mask.assign(draft.pair_of.size(), 0);
  for (std::size_t i = 0; i < inputs.pairs.size(); ++i) {
    if (!inputs.feel[i].felt || inputs.pairs[i].other_part >= 0) continue;
    const std::size_t at = inputs.pairs[i].part * inputs.obstacles.size() + inputs.pairs[i].obstacle;
    draft.pair_of[at] = static_cast<int>(i);
    draft.mask[at] = 1;
    draft.options.safety_distance = std::max(draft.options.safety_distance, inputs.feel[i].boundary);
  }
  draft.options.radius = zone_W;
  draft.options.max_rotation = inputs.turn_ahead;
  // Room for the limits, the bound of turning and one for whoever adds a row of its own.
  draft.options.max_entries = haptic::kMaxConstraints - 2 - std::min<std::size_t>(draft.limits.size(), 16) -
                              std::min<std::size_t>(inputs.own.size(), 8);
  draft.options.only_complete = inputs.only_complete;
  draft.moving = movingParts(inputs, draft.differentials, zone_W);
  draft.own = ownRows(inputs, draft.differentials);
  draft.X_WM = inputs.manipulator.movedFrame(inputs.configuration);
  draft.X_DR = inputs.mapping.toDevice(draft.X_WM, inputs.X_DNear);
  return draft;
}

BuiltConstraints completed(const ConstraintDraft& draft, const collision::ZoneContacts& found,
                           std::span<const dvec3> gone_W) {
  BuiltConstraints built;
  built.limits = draft.limits;
  built.set.X_DR = draft.X_DR;
  built.set.zone_radius = std::max(1e-4, std::min(found.radius, draft.options.radius) / draft.mapping.scale());
  built.complete = found.complete;
  built.pending = found.pending;
  built.facets = found.facets;
  built.cost = kSecondsPerWork * static_cast<double>(found.work);
  for (const collision::ZoneContact& contact : found.contacts) {
    appendContact(draft, contact, gone_W.empty() ? dvec3(0.0) : gone_W[contact.environment_part], built);
  }
  appendOwn(draft.own, std::max(found.groups, nextGroup(built)), built);
  appendLimits(draft.mapping, std::max(found.groups, nextGroup(built)), built);
  appendTurnBound({draft.mapping, draft.zone_radius, draft.turn_ahead}, built);
  return built;
}

void moveReference(BuiltConstraints& built, const Pose& X_DR, const Pose& X_DNow) {
  const Twist way = difference(X_DNow, X_DR);
  const haptic::Vector6 xi{way.linear.x, way.linear.y, way.linear.z, way.angular.x, way.angular.y, way.angular.z};
  haptic::ConstraintSet& set = built.set;
  for (std::size_t i = 0; i < set.count; ++i) {
    haptic::Constraint& row = set.constraints[i];
    haptic::Vector6 gradient{};
    row.gap = haptic::evaluateWithGradient(row, xi, gradient);
    row.gradient = gradient;
    if (!row.has_trim) continue;
    for (std::size_t k = 0; k < 6; ++k) row.trim_gap += row.trim_gradient[k] * xi[k];
  }
  set.X_DR = X_DNow;
  set.zone_radius = std::max(
      1e-4, set.zone_radius - std::hypot(glm::length(way.linear), haptic::kRotationLever * glm::length(way.angular)));
}

BuiltConstraints buildConstraints(const ConstraintInputs& inputs) {
  ConstraintDraft draft = draftConstraints(inputs);
  draft.options.pair_mask = draft.mask;
  return completed(draft, inputs.finder != nullptr
                              ? inputs.finder->find(draft.moving, inputs.obstacles, draft.options)
                              : collision::zoneContacts(draft.moving, inputs.obstacles, draft.options));
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
  appendOwn(ownRows(inputs, parts), group, built);
  appendLimits(inputs.mapping, std::max(group, nextGroup(built)), built);
  appendTurnBound({inputs.mapping, inputs.zone_radius, inputs.turn_ahead}, built);
  return built;
}

void dropTurnBound(BuiltConstraints& built) {
  haptic::ConstraintSet& set = built.set;
  const auto begin = set.constraints.begin(), end = begin + static_cast<std::ptrdiff_t>(set.count);
  const auto bound = std::find_if(begin, end, [](const haptic::Constraint& c) { return c.id == kTurnBoundId; });
  if (bound == end) return;
  built.origins.erase(built.origins.begin() + (bound - begin));
  std::copy(bound + 1, end, bound);
  --set.count;
  built.turn = 0.0;
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
