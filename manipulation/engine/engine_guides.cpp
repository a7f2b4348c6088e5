// SPDX-License-Identifier: Apache-2.0
// What the hand feels besides contacts: guides, the load it carries, and the drift at the edge of its workspace.
#include <algorithm>
#include <cmath>
#include <map>

#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/proxy_metric.h"
#include "manipulation/holding/felt_load.h"
#include "manipulation/holding/guide_constraints.h"
#include "manipulation/engine/manipulation_step.h"

namespace hapticell::manipulation {

namespace {

constexpr double kEdgeBegins = 0.85;   ///< Of the workspace's half width.
constexpr double kLeastGuideZone = 0.8e-3;  ///< m of hand: what a set is good for at least.
constexpr double kLongestStep = 0.1;   ///< s that one step of the drift can stand for.

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

/// Tells the server what the hand carries now, where that has changed.
void ManipulationEngine::updateLoad() {
  haptic::LoadOptions load;
  const workcell::Entity* entity = held_ && scene_ ? scene_->find(held_->id()) : nullptr;
  if (entity != nullptr && !clutched_) {
    const std::optional<haptic::DeviceDescription> device = link_.device();
    load = feltLoad(*entity, force_class_.value_or(entity->force_class), configuration_.manipulation, mapping_,
                    device ? device->continuous_force : 0.0);
    load.friction = std::max(load.friction, held_->jointFriction());
    for (const workcell::Guide* guide : guidesOfHeld()) load.friction = std::max(load.friction, guide->friction);
  }
  if (load == control_.load) return;
  control_.load = load;
  link_.sendControl(control_);
}

std::vector<const workcell::Guide*> ManipulationEngine::guidesOfHeld() const {
  std::vector<const workcell::Guide*> bound;
  const workcell::Entity* entity = held_ && scene_ ? scene_->find(held_->id()) : nullptr;
  for (const workcell::Guide& guide : guides_) {
    if (entity != nullptr && guide.enabled && guide.entity == entity->name) bound.push_back(&guide);
  }
  return bound;
}

/// The moved frame as the entity stands in the document.
Pose ManipulationEngine::movedFrameAtRest() const {
  const workcell::Entity& entity = *scene_->find(held_->id());
  return held_->manipulator().movedFrame({entity.X_WE, entity.joints});
}

/// Where a guide turns the entity by its place, every row is about places and the wrist is free.
void ManipulationEngine::slaveSet(const Pose& X_WM0) {
  for (const workcell::Guide* guide : guidesOfHeld()) {
    const std::optional<GuidedTurn> turn = guidedTurn(*guide, held_->movedFrame(), X_WM0);
    if (!turn) continue;
    const dmat3 R_WD = glm::mat3_cast(mapping_.axes());
    const dmat3 rate_D = mapping_.scale() / mapping_.rotationScale() * (glm::transpose(R_WD) * turn->rate * R_WD);
    // Its turn is a matter of its place: what bounds one bounds the other, as the zone's edge and not as a thing.
    if (built_.turn > 0.0) {
      const double most = built_.turn / std::max(largestRate(rate_D), 1e-9);
      built_.set.zone_radius = std::min(built_.set.zone_radius, std::max(most, kLeastGuideZone));
      dropTurnBound(built_);
    }
    for (std::size_t i = 0; i < built_.set.count; ++i) slaveTurning(rate_D, built_.set.constraints[i]);
    built_.set.X_DR.q = state_->X_DP.q;
    return;
  }
}

/// How far the entity turns while the hand goes `radius` (m), where a guide turns it by its place; else 0. rad.
double ManipulationEngine::guidedTurnWithin(double radius) const {
  double turn = 0.0;
  for (const workcell::Guide* guide : guidesOfHeld()) {
    const std::optional<GuidedTurn> guided = guidedTurn(*guide, held_->movedFrame(), movedFrameAtRest());
    if (guided) turn = std::max(turn, largestRate(guided->rate) * mapping_.scale() * radius);
  }
  return turn;
}

/// Guides go before contacts that are far away: those are left out of the set, which then is good for a smaller zone.
void ManipulationEngine::makeRoom(std::size_t rows) {
  haptic::ConstraintSet& set = built_.set;
  while (set.count + rows > haptic::kMaxConstraints && set.count > 0) {
    std::map<std::uint32_t, double> gap_of;
    for (const haptic::Constraint& c : set.active()) {
      auto [group, is_new] = gap_of.try_emplace(c.group, c.gap);
      if (!is_new) group->second = std::max(group->second, c.gap);
    }
    const auto farthest = std::max_element(gap_of.begin(), gap_of.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    set.zone_radius = std::clamp(farthest->second, kLeastGuideZone, set.zone_radius);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < set.count; ++i) {
      if (set.constraints[i].group == farthest->first) continue;
      set.constraints[kept] = set.constraints[i];
      built_.origins[kept++] = built_.origins[i];
    }
    set.count = kept;
    built_.origins.resize(kept);
  }
}

void ManipulationEngine::addGuideRows() {
  const std::vector<const workcell::Guide*> guides = guidesOfHeld();
  if (guides.empty()) return;
  const Pose X_WM0 = movedFrameAtRest();
  slaveSet(X_WM0);
  haptic::ConstraintSet& set = built_.set;
  std::uint32_t group = set.count == 0 ? 0 : set.constraints[set.count - 1].group + 1;
  for (const workcell::Guide* guide : guides) {
    std::vector<haptic::Constraint> rows = guideConstraints(*guide, held_->movedFrame(), X_WM0, group);
    if (guide->kind == workcell::GuideKind::kSurface) {
      const workcell::Entity* other = scene_->find(guide->surface);
      auto row = other != nullptr ? held_->surfaceConstraint(other->id, guide->offset) : std::nullopt;
      if (row) rows.push_back(*row);
      if (row) rows.back().group = group;
    }
    makeRoom(rows.size());
    for (haptic::Constraint& row : rows) {
      if (set.count >= haptic::kMaxConstraints) return;
      mapping_.toDevice(row);
      set.constraints[set.count++] = row;
      built_.origins.push_back({});
      group = row.group + 1;
    }
  }
}

/// The nearest pose on what the guides fix, so that what is shown is on them though the rows are made of old sets.
Pose ManipulationEngine::onGuides(const Pose& X_DP) const {
  const std::vector<const workcell::Guide*> guides = guidesOfHeld();
  if (guides.empty()) return X_DP;
  const Pose X_WM0 = movedFrameAtRest();
  Pose X_WM = mapping_.toCell(X_DP);
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<haptic::SolverRow> rows;
    for (const workcell::Guide* guide : guides) appendSolverRows(guideConstraints(*guide, X_WM, X_WM0, 0), rows);
    X_WM = haptic::displacedInMetric(X_WM, haptic::nearestFeasible(rows, {}).d);
  }
  for (const workcell::Guide* guide : guides) {
    if (const auto turn = guidedTurn(*guide, X_WM, X_WM0)) X_WM.q = turn->q_WM;
  }
  return mapping_.toDevice(X_WM, X_DP);
}

/// Where the hand leans on the edge of its workspace the entity goes on in that direction (rate control at the rim: L.
/// Dominjon's "bubble", 2005). For the force loop everything then moves the other way.
void ManipulationEngine::driftAtEdge() {
  const double dt =
      drift_ns_ > 0 ? std::clamp(1e-9 * static_cast<double>(now_ns_ - drift_ns_), 0.0, kLongestStep) : 0.0;
  drift_ns_ = now_ns_;
  const dvec3 before = drift_D_;
  drift_D_ = dvec3(0.0);
  const std::optional<haptic::DeviceDescription> device = link_.device();
  const double fastest = configuration_.manipulation.edge_drift;
  if (held_ && !clutched_ && device && fastest > 0.0) {
    for (int i = 0; i < 3; ++i) {
      const double middle = 0.5 * (device->workspace_max[i] + device->workspace_min[i]);
      const double half = 0.5 * (device->workspace_max[i] - device->workspace_min[i]);
      if (half <= 0.0) continue;
      const double at = (state_->X_DP.p[i] - middle) / half;
      const double lean = std::clamp((std::abs(at) - kEdgeBegins) / (1.0 - kEdgeBegins), 0.0, 1.0);
      drift_D_[i] = std::copysign(fastest * lean, at);
    }
  }
  // What the set foresees is the speed it was made with.
  if (glm::distance(drift_D_, before) > 0.1 * fastest) set_wanted_ = true;
  mapping_.drift(dt * drift_D_);
}

}  // namespace hapticell::manipulation
