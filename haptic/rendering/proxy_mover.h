// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>

#include "geometry/shapes/pose.h"
#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/proxy_metric.h"
#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {

/// How far one set lets the proxy move in a tick, and what holds it there.
struct ProxyStep {
  Pose X_DP;
  std::size_t active_rows = 0;
  bool contact = false;    ///< A row of a constraint holds it.
  bool trust = false;      ///< The zone's edge holds it.
  MetricVector trust_D;    ///< The trust row's part of proxy minus stylus, m.
  MetricVector lag_D;      ///< Further motion of the proxy that its largest move in a tick prevented, m.
  Pose X_DG;               ///< The pose up to which the rows let the proxy move; it may need several ticks.
  double depth = 0.0;      ///< Remaining distance from there to the stylus, m.
  double friction = 0.0;   ///< Of the active rows, weighted by how hard they press.
  double stiffness = 0.0;  ///< Least value that an active row requests; 0: no request.
  double damping = 0.0;    ///< Largest value that an active row requests.
  double outrun = 1.0;     ///< How much faster than the stylus the proxy moves along a surface that bulges towards it.
  dvec3 v_DO{0.0};         ///< Velocity of the touched obstacles, weighted by how hard they press, m/s.
  std::bitset<kMaxConstraints> pressing;  ///< The groups whose rows hold it.
  ActiveRows held_by;                     ///< Where the search for the next step of the same set should begin.

  void note(const GroupedSet& grouped, const ProxyRows& rows, const SolverResult& result);

 private:
  void noteOutrun(const EntryArrays& entries, std::size_t entry, double press);
};

/// Moves proxies (god-objects; C. Zilles, K. Salisbury, 1995) from their last pose towards the stylus, inside one
/// half-space per group (by nearestUnentered()), never out of the set's zone, and with Coulomb friction.
///
/// `turning`: the device also drives rotation, so friction and depth refer to the complete motion in the metric; else
/// rotation is free and only the translation counts. No state; never allocates, locks or throws.
class ProxyMover {
 public:
  void setTurning(bool turning) { turning_ = turning; }
  bool turning() const { return turning_; }

  /// One step of `dt` seconds from X_DP towards X_DS. `held_by`: that of the last step of the same set.
  ProxyStep move(const GroupedSet& grouped, const Pose& X_DP, const Pose& X_DS, double dt,
                 const ActiveRows& held_by = {}) const;
  /// The motion from X_DA to X_DB that can be felt: without rotation if the device does not drive it.
  MetricVector way(const Pose& X_DB, const Pose& X_DA) const;

 private:
  /// Which groups' rows the proxy touched where its step began.
  using Touching = std::bitset<kMaxConstraints>;
  void applyFriction(const GroupedSet& grouped, const Pose& from, const Touching& began, ProxyStep& step,
                     double dt) const;
  void goOn(const GroupedSet& grouped, const Touching& began, double most, ProxyStep& step) const;
  MetricVector keptInZone(double zone_radius, const Vector6& from_reference, const MetricVector& d,
                          ProxyStep& step) const;
  MetricVector felt(MetricVector v) const;
  bool turning_ = false;
};

}  // namespace hapticell::haptic
