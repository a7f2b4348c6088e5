// SPDX-License-Identifier: Apache-2.0
#include "planning/leaving.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "planning/problem.h"

namespace hapticell::planning {

namespace {

/// Share of the clearance, and m, by which all pairs are beyond it at the end: FreeSpace proves motions from there on
/// only if they keep a tenth more. Half: the search cannot begin there; twice: longer ways out.
constexpr double kBeyondShare = 0.15, kBeyond = 2e-4;
/// How much longer than the straight way the ways out are that are tried. Half: oblique ways are not found; twice:
/// they are found at a coarser length.
constexpr double kLonger[] = {1.05, 1.5, 3.0, 8.0};
/// m of path between two places at which gaps are measured: between them they change by half of it. Half: twice the
/// time; twice: LeavingRule::kMayClose may be missed between two places.
constexpr double kPlaces = LeavingRule::kMayClose;
/// m: of LeavingRule::kMayClose, the other half may be between two places. Half, twice: as kPlaces.
constexpr double kMayCloseAtPlaces = 0.5 * LeavingRule::kMayClose;
/// rad (or m) by which a joint is moved to see how far it takes the parts.
constexpr double kTrialTurn = 0.01;

double lookOf(const FreeSpace& space) {
  return (1.0 + kBeyondShare) * space.clearance() + kBeyond;
}

/// The pairs only open, and keep the clearance once they have it; all others keep it everywhere.
bool onlyOpens(FreeSpace& space, const EntityConfiguration& from, const EntityConfiguration& to,
               const std::vector<PairGap>& tight) {
  space.setChecked(tight, false);
  const bool others_are_free = space.isFree(from, to);
  space.setChecked(tight, true);
  if (!others_are_free) return false;
  const int pieces = std::max(1, static_cast<int>(std::ceil(space.pathBound(from, to) / kPlaces)));
  std::vector<double> best;
  for (const PairGap& one : tight) best.push_back(one.gap);
  for (int k = 1; k <= pieces; ++k) {
    const EntityConfiguration at = space.between(from, to, static_cast<double>(k) / pieces);
    for (std::size_t i = 0; i < tight.size(); ++i) {
      const double gap = space.gapOf(tight[i].pair, at);
      const double least = best[i] >= space.clearance() ? space.clearance() : best[i] - kMayCloseAtPlaces;
      if (gap < least) return false;
      best[i] = std::max(best[i], gap);
    }
  }
  return true;
}

std::vector<dvec3> directionsOf(const FreeSpace& space, const EntityConfiguration& at,
                                const std::vector<PairGap>& tight) {
  dvec3 sum(0.0);
  std::vector<dvec3> directions;
  for (const PairGap& one : tight) {
    if (one.gap >= space.clearance()) continue;
    sum += one.open_W;
    directions.push_back(one.open_W);
  }
  if (glm::length(sum) > 1e-3) directions.insert(directions.begin(), glm::normalize(sum));
  const Pose X_WT = space.toolAt(at);
  for (int axis = 0; axis < 6; ++axis) {
    dvec3 unit(0.0);
    unit[axis % 3] = 1.0;
    if (axis >= 3) unit = X_WT.rotate(unit);
    directions.push_back(unit);
    directions.push_back(-unit);
  }
  return directions;
}

/// Configurations about `way` (m) from `at`, the likeliest first.
std::vector<EntityConfiguration> endsOf(const FreeSpace& space, const EntityConfiguration& at,
                                        const std::vector<PairGap>& tight, double way) {
  std::vector<EntityConfiguration> ends;
  const Pose X_WT = space.toolAt(at);
  for (const dvec3& direction : directionsOf(space, at, tight)) {
    ends.push_back(space.proposed(at, {X_WT.p + way * direction, X_WT.q}));
  }
  if (!space.hasJoints() || space.figure() != nullptr) return ends;
  const kinematics::RobotModel& robot = *space.entity().robot();
  for (std::size_t i = 0; i < at.joints.size(); ++i) {
    const kinematics::Joint& joint = robot.joints[static_cast<std::size_t>(robot.moving[i])];
    EntityConfiguration moved = at;
    moved.joints[i] += kTrialTurn;
    const double lever = space.pathBound(at, moved) / kTrialTurn;
    if (!(lever > 0.0)) continue;
    for (const double sign : {1.0, -1.0}) {
      moved.joints[i] = at.joints[i] + sign * way / lever;
      if (moved.joints[i] >= joint.lower && moved.joints[i] <= joint.upper) ends.push_back(moved);
    }
  }
  return ends;
}

}  // namespace

std::optional<EntityConfiguration> wayOut(FreeSpace& space, const EntityConfiguration& at) {
  const double look = lookOf(space), near = LeavingRule::nearness(space.clearance());
  const std::vector<PairGap> tight = space.gapsAt(at, look);
  if (tight.empty() || tight.front().gap < -LeavingRule::kDeepest) return std::nullopt;
  for (const double longer : kLonger) {
    const double way = longer * (look - tight.front().gap);
    if (way > near) break;
    for (EntityConfiguration& end : endsOf(space, at, tight, way)) {
      if (space.pathBound(at, end) > near || !space.gapsAt(end, look).empty() || !space.isFree(end)) continue;
      if (onlyOpens(space, at, end, tight)) return std::move(end);
    }
  }
  return std::nullopt;
}

Text whyNoWayOut(FreeSpace& space, const EntityConfiguration& at, const Text& where) {
  const std::vector<PairGap> tight = space.gapsAt(at, space.clearance());
  if (tight.empty()) return where;
  const PairGap& worst = tight.front();
  if (worst.gap >= -LeavingRule::kDeepest) {
    return Text("%1, and no straight way of up to %2 leads out of there", where,
                Text::Length{LeavingRule::nearness(space.clearance())});
  }
  const Text most("a plan leaves contacts that are up to %1 deep", Text::Length{LeavingRule::kDeepest});
  if (!std::isfinite(worst.gap))
    return Text("at the start %1 is too deep in %2 (%3); move %4 out of it", worst.who.moved, worst.who.met, most,
                worst.who.moved);
  return Text("at the start %1 is %2 deep in %3 (%4); move %5 out of it", worst.who.moved, Text::Length{-worst.gap},
              worst.who.met, most, worst.who.moved);
}

Failure startFailure(FreeSpace& space, const EntityConfiguration& start) {
  Failure failure;
  failure.kind = Failure::Kind::kStart;
  const double distance = space.clearanceAt(start, space.clearance());
  const auto nearest = space.nearestAt(start, space.clearance());
  if (!nearest) {  // Its own parts meet.
    space.isFree(start);
    failure.reason = Text("the start is not free: %1", space.blocker() ? space.blocker()->text() : Text());
    return failure;
  }
  failure.blocked_by = nearest->met;
  failure.reason = distance > 0.0
                       ? Text("at the start %1 is %2 from %3, nearer than the clearance of %4", nearest->moved,
                              Text::Length{distance}, nearest->met, Text::Length{space.clearance()})
                       : Text("at the start %1 touches %2", nearest->moved, nearest->met);
  return failure;
}

}  // namespace hapticell::planning
