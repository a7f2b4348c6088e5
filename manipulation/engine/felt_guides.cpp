// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/felt_guides.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/proxy_metric.h"
#include "manipulation/holding/guide_constraints.h"

namespace hapticell::manipulation {

namespace {

/// m of hand that a set is good for at least, as kLeastZone of set_scheduler.cpp. Half: a fast hand meets the edge;
/// twice: more of a guide's turn is reported to first order only.
constexpr double kLeastGuidedZone = 0.8e-3;

/// Bound of what a turn of this rate (rad/m) makes of a metre.
double largestRate(const dmat3& rate) {
  return std::sqrt(glm::dot(rate[0], rate[0]) + glm::dot(rate[1], rate[1]) + glm::dot(rate[2], rate[2]));
}

/// As half-spaces of the proxy's metric, for the projection.
void appendSolverRows(const std::vector<haptic::Constraint>& constraints, std::vector<haptic::SolverRow>& rows) {
  for (const haptic::Constraint& c : constraints) {
    if (c.kind == haptic::ConstraintKind::kPull || rows.size() >= haptic::kMaxRows) continue;
    haptic::SolverRow row{c.gradient, c.gap, c.kind == haptic::ConstraintKind::kEquality};
    for (std::size_t i = 3; i < 6; ++i) row.normal[i] /= haptic::kRotationLever;
    const double length = haptic::lengthOf(row.normal);
    if (length < 1e-9) continue;
    for (double& n : row.normal) n /= length;
    row.slack /= length;
    rows.push_back(row);
  }
}

}  // namespace

void makeRoom(BuiltConstraints& built, std::size_t rows) {
  haptic::ConstraintSet& set = built.set;
  while (set.count + rows > haptic::kMaxConstraints && set.count > 0) {
    std::map<std::uint32_t, double> gap_of;
    for (const haptic::Constraint& c : set.active()) {
      auto [group, is_new] = gap_of.try_emplace(c.group, c.gap);
      if (!is_new) group->second = std::max(group->second, c.gap);
    }
    const auto farthest = std::max_element(gap_of.begin(), gap_of.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    set.zone_radius = std::clamp(farthest->second, kLeastGuidedZone, set.zone_radius);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < set.count; ++i) {
      if (set.constraints[i].group == farthest->first) continue;
      set.constraints[kept] = set.constraints[i];
      built.origins[kept++] = built.origins[i];
    }
    set.count = kept;
    built.origins.resize(kept);
  }
}

std::vector<const workcell::Guide*> FeltGuides::binding(const HeldEntity& held) const {
  std::vector<const workcell::Guide*> bound;
  const workcell::Entity* entity = cell_.find(held.id());
  for (const workcell::Guide& guide : guides_) {
    if (entity != nullptr && guide.enabled && guide.entity == entity->name) bound.push_back(&guide);
  }
  return bound;
}

double FeltGuides::friction(const HeldEntity& held) const {
  double most = 0.0;
  for (const workcell::Guide* guide : binding(held)) most = std::max(most, guide->friction);
  return most;
}

/// The moved frame as the entity stands in the document.
Pose FeltGuides::atRest(const HeldEntity& held) const {
  const workcell::Entity& entity = *cell_.find(held.id());
  return held.manipulator().movedFrame({entity.X_WE, entity.joints()});
}

/// Where a guide turns the entity by its place, every row is about places and the wrist is free.
void FeltGuides::slaveSet(BuiltConstraints& built, const HeldEntity& held, const MotionMapping& mapping,
                          const Pose& X_DP) const {
  const Pose X_WM0 = atRest(held);
  for (const workcell::Guide* guide : binding(held)) {
    const std::optional<GuidedTurn> turn = guidedTurn(*guide, held.movedFrame(), X_WM0);
    if (!turn) continue;
    const dmat3 R_WD = glm::mat3_cast(mapping.axes());
    const dmat3 rate_D = mapping.scale() / mapping.rotationScale() * (glm::transpose(R_WD) * turn->rate * R_WD);
    // Its turn is a matter of its place: what bounds one bounds the other, as the zone's edge and not as a thing.
    if (built.turn > 0.0) {
      const double most = built.turn / std::max(largestRate(rate_D), 1e-9);
      built.set.zone_radius = std::min(built.set.zone_radius, std::max(most, kLeastGuidedZone));
      dropTurnBound(built);
    }
    for (std::size_t i = 0; i < built.set.count; ++i) slaveTurning(rate_D, built.set.constraints[i]);
    built.set.X_DR.q = X_DP.q;
    return;
  }
}

double FeltGuides::turnWithin(double radius, const HeldEntity& held, const MotionMapping& mapping) const {
  double turn = 0.0;
  for (const workcell::Guide* guide : binding(held)) {
    const std::optional<GuidedTurn> guided = guidedTurn(*guide, held.movedFrame(), atRest(held));
    if (guided) turn = std::max(turn, largestRate(guided->rate) * mapping.scale() * radius);
  }
  return turn;
}

void FeltGuides::addTo(BuiltConstraints& built, HeldEntity& held, const MotionMapping& mapping,
                       const Pose& X_DP) const {
  const std::vector<const workcell::Guide*> guides = binding(held);
  if (guides.empty()) return;
  const Pose X_WM0 = atRest(held);
  slaveSet(built, held, mapping, X_DP);
  haptic::ConstraintSet& set = built.set;
  std::uint32_t group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
  for (const workcell::Guide* guide : guides) {
    std::vector<haptic::Constraint> rows = guideConstraints(*guide, held.movedFrame(), X_WM0, group);
    if (guide->kind == workcell::GuideKind::kSurface) {
      const workcell::Entity* other = cell_.find(guide->surface);
      auto row = other != nullptr ? held.surfaceConstraint(other->id, guide->offset) : std::nullopt;
      if (row) rows.push_back(*row);
      if (row) rows.back().group = group;
    }
    makeRoom(built, rows.size());
    for (haptic::Constraint& row : rows) {
      if (set.count >= haptic::kMaxConstraints) return;
      mapping.toDevice(row);
      set.constraints[set.count++] = row;
      built.origins.push_back({});
      group = row.group + 1;
    }
  }
}

Pose FeltGuides::onGuides(const Pose& X_DP, const HeldEntity& held, const MotionMapping& mapping) const {
  const std::vector<const workcell::Guide*> guides = binding(held);
  if (guides.empty()) return X_DP;
  const Pose X_WM0 = atRest(held);
  Pose X_WM = mapping.toCell(X_DP);
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<haptic::SolverRow> rows;
    for (const workcell::Guide* guide : guides) appendSolverRows(guideConstraints(*guide, X_WM, X_WM0, 0), rows);
    X_WM = haptic::displacedInMetric(X_WM, haptic::nearestFeasible(rows, {}).d);
  }
  for (const workcell::Guide* guide : guides) {
    if (const auto turn = guidedTurn(*guide, X_WM, X_WM0)) X_WM.q = turn->q_WM;
  }
  return mapping.toDevice(X_WM, X_DP);
}

}  // namespace hapticell::manipulation
