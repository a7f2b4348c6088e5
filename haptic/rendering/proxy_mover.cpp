// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/proxy_mover.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

namespace {

/// m of one iteration of the proxy (docs/dev/feel.md, 3). Half of either fails
/// ForceRenderer.DropsAForceThatANewSetTakesAwaySlowlyThenExactly, twice passes the tests of this folder.
constexpr double kLongestMove = 0.002;
constexpr int kIterations = 2;
constexpr double kLargestOutrun = 3.0;  // R / (R - d) of docs/dev/feel.md, 5. Half and twice pass the tests of this folder.
constexpr double kTouches = 2e-5;       // m. Half and twice pass the tests of this folder.

}  // namespace

void ProxyStep::note(const GroupedSet& grouped, const ProxyRows& rows, const SolverResult& result) {
  active_rows = result.active_count;
  held_by = result.active;
  const std::size_t last = rows.row.count - 1;
  trust = result.multiplier[last] != 0.0;
  trust_D = result.multiplier[last] * metricVector(rows.row.normalOf(last));
  contact = false;
  friction = stiffness = damping = 0.0;
  v_DO = dvec3(0.0);
  pressing.reset();
  outrun = 1.0;
  double pressed = 0.0;
  for (std::size_t i = 0; i < last; ++i) {
    const double press = std::abs(result.multiplier[i]);
    if (press <= 0.0) continue;
    const EntryArrays& entries = grouped.arrays;
    const std::size_t entry = rows.entry[i];
    contact = true;
    pressing.set(i);
    noteOutrun(entries, entry, press);
    pressed += press;
    friction += press * entries.friction[entry];
    v_DO += press * entries.velocityOf(entry);
    damping = std::max(damping, entries.damping[entry]);
    const double asked = entries.stiffness[entry];
    if (asked > 0.0) stiffness = stiffness > 0.0 ? std::min(stiffness, asked) : asked;
  }
  if (pressed <= 0.0) return;
  friction /= pressed;
  v_DO /= pressed;
}

/// On a convex surface of radius R a stylus that is d deep goes R - d while the proxy goes R.
void ProxyStep::noteOutrun(const EntryArrays& entries, std::size_t entry, double press) {
  const dvec3 along(entries.gradient[0][entry], entries.gradient[1][entry], entries.gradient[2][entry]);
  const double size = std::max(glm::length(along), 1e-9);
  const auto& B = entries.curvature;
  const double bulge = std::max({0.0, B[0][entry], B[6][entry], B[11][entry]}) / size;
  outrun = std::max(outrun, 1.0 / std::max(1.0 - bulge * press, 1.0 / kLargestOutrun));
}

MetricVector ProxyMover::felt(MetricVector v) const {
  if (!turning_) v.angular = dvec3(0.0);
  return v;
}

MetricVector ProxyMover::way(const Pose& X_DB, const Pose& X_DA) const {
  return turning_ ? metricVector(metricDifference(X_DB, X_DA)) : MetricVector{X_DB.p - X_DA.p, dvec3(0.0)};
}

ProxyStep ProxyMover::move(const GroupedSet& grouped, const Pose& X_DP, const Pose& X_DS, double dt,
                           const ActiveRows& held_by) const {
  ProxyStep step;
  step.X_DP = X_DP;
  step.held_by = held_by;
  ProxyRows rows;
  Touching began;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Vector6 wanted = metricDifference(X_DS, step.X_DP);
    rows.gather(grouped, step.X_DP);
    for (std::size_t i = 0; iteration == 0 && i + 1 < rows.row.count; ++i) began.set(i, rows.row.slack[i] < kTouches);
    if (rows.tied()) rows.settle(wanted);
    const SolverResult result = nearestUnentered(rows.row, wanted, step.held_by);
    MetricVector d = metricVector(result.d);
    step.X_DG = displacedInMetric(step.X_DP, result.d);
    step.depth = length(felt(metricVector(wanted) - d));
    const double size = length(d);
    step.note(grouped, rows, result);
    step.trust_D = felt(step.trust_D);
    step.lag_D = {};
    if (size > kLongestMove) {
      step.lag_D = felt((1.0 - kLongestMove / size) * d);
      d *= kLongestMove / size;
    }
    const MetricVector kept = keptInZone(grouped.zone_radius, rows.from_reference, d, step);
    // Free to the last bit, so that free motion costs exactly nothing.
    const bool free = result.active_count == 0 && size <= kLongestMove && kept == d;
    step.X_DP = free ? X_DS : displacedInMetric(step.X_DP, asVector6(kept));
    if (result.status != SolverStatus::kSolved) break;  // It has been solved twice already.
  }
  applyFriction(grouped, X_DP, began, step, dt);
  return step;
}

/// The trust row is the zone's edge to first order only, and far off where the zone is smaller than a step. The zone is
/// round: along its edge a step counts as much less as the stylus is outside (Newton's step there). And nothing is
/// known beyond it: what of the step would lead out, the zone holds back.
MetricVector ProxyMover::keptInZone(double zone_radius, const Vector6& from_reference, const MetricVector& d,
                                    ProxyStep& step) const {
  const MetricVector from = metricVector(from_reference);
  const double radius = std::max(zone_radius, length(from));
  double share = 1.0 / (1.0 + length(step.trust_D) / zone_radius);
  const double size = share * share * dot(d, d), along = share * dot(from, d);
  if (size > 0.0 && length(from + share * d) > radius) {
    const double room = std::max(0.0, radius * radius - dot(from, from));
    share *= std::clamp((std::sqrt(along * along + size * room) - along) / size, 0.0, 1.0);
  }
  if (share >= 1.0) return d;
  step.trust = true;
  step.active_rows = std::max<std::size_t>(step.active_rows, 1);
  step.trust_D -= felt((1.0 - share) * d);
  return share * d;
}

void ProxyMover::applyFriction(const GroupedSet& grouped, const Pose& from, const Touching& began, ProxyStep& step,
                               double dt) const {
  if (!step.contact || step.friction <= 0.0) return;
  const Pose carried{from.p + dt * step.v_DO, from.q};  // What is touched takes the proxy along.
  const MetricVector gone = way(step.X_DP, carried);
  const double size = length(gone);
  const double held = step.friction * step.depth;
  if (size <= 0.0 || held <= 0.0) return;
  // Of the whole way, not of what a tick can do of it: else a proxy that is left behind would stick for ever.
  const double share = std::clamp((length(way(step.X_DG, carried)) - held) / size, 0.0, 1.0);
  if (turning_) {
    step.X_DP = displacedInMetric(carried, asVector6(share * gone));
  } else {
    step.X_DP.p = carried.p + share * gone.linear;
  }
  goOn(grouped, began, size, step);
}

/// Back onto the set along its normals where friction left the proxy inside. Nothing rubs before it touches: a proxy
/// that came through the air goes on to what it meets.
void ProxyMover::goOn(const GroupedSet& grouped, const Touching& began, double most, ProxyStep& step) const {
  ProxyRows rows;
  rows.gather(grouped, step.X_DP);
  const bool arrives = (began & step.pressing).none();
  for (std::size_t i = 0; arrives && i + 1 < rows.row.count; ++i) {
    if (step.pressing[i]) rows.row.both_ways[i] = 1.0;
  }
  const SolverResult solved = nearestUnentered(rows.row, Vector6{}, step.held_by);
  if (solved.active_count == 0) return;
  MetricVector d = metricVector(solved.d);
  // Friction leaves it inside by hardly anything; rows that contradict each other would send it anywhere.
  d = limited(d, arrives ? most : kLongestMove);
  step.X_DP = displacedInMetric(step.X_DP, asVector6(keptInZone(grouped.zone_radius, rows.from_reference, d, step)));
}

}  // namespace hapticell::haptic
