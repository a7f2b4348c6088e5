// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>

#include "geometry/shapes/pose.h"
#include "haptic/rendering/active_set_solver.h"
#include "haptic/rendering/proxy_metric.h"
#include "haptic/rendering/proxy_rows.h"

namespace hapticell::haptic {

/// Where one set lets the proxy go in a tick, and what holds it there.
struct ProxyStep {
  Pose X_DP;
  std::size_t active_rows = 0;
  bool contact = false;    ///< A row of a constraint holds it.
  bool trust = false;      ///< The zone's edge holds it.
  MetricVector trust_D;    ///< The trust row's part of proxy less stylus, m.
  MetricVector lag_D;      ///< What the proxy could go besides, but for its longest move in a tick, m.
  Pose X_DG;               ///< Where the rows would let the proxy go; it may need several ticks.
  double depth = 0.0;      ///< What then is left to the stylus, m.
  double friction = 0.0;   ///< Of the active rows, weighted by how hard they press.
  double stiffness = 0.0;  ///< Least that an active row asks for, 0: none does.
  double damping = 0.0;    ///< Most that an active row asks for.
  double outrun = 1.0;     ///< How much faster than the stylus the proxy goes along what bulges towards it.
  dvec3 v_DO{0.0};         ///< Of what is touched, weighted by how hard it presses, m/s.
  std::bitset<kMaxConstraints> pressing;  ///< The groups whose rows hold it.

  void note(const GroupedSet& grouped, const ProxyRows& rows, const SolverResult& result);

 private:
  void noteOutrun(const Constraint& constraint, double press);
};

/// Moves proxies (god-objects; C. Zilles, K. Salisbury, 1995) from their last place towards the stylus, inside one
/// half-space per group, found by nearestUnentered() and never out of the set's zone, and holds them back by Coulomb
/// friction.
///
/// `turning`: the device drives the turning too, so that friction and depth are of the whole motion in the metric;
/// else the turn is free and only the translation counts. Pure; never allocates, locks or throws.
class ProxyMover {
 public:
  void setTurning(bool turning) { turning_ = turning; }
  bool turning() const { return turning_; }

  /// One step of `dt` seconds from X_DP towards X_DS.
  ProxyStep move(const GroupedSet& grouped, const Pose& X_DP, const Pose& X_DS, double dt) const;
  /// The way from X_DA to X_DB that can be felt: without its turn where none is driven.
  MetricVector way(const Pose& X_DB, const Pose& X_DA) const;

 private:
  void applyFriction(const GroupedSet& grouped, const Pose& from, ProxyStep& step, double dt) const;
  void goOn(const GroupedSet& grouped, const Pose& from, double most, ProxyStep& step) const;
  MetricVector keptInZone(const ConstraintSet& set, ProxyStep& step, const MetricVector& d) const;
  MetricVector felt(MetricVector v) const;
  bool turning_ = false;
};

}  // namespace hapticell::haptic
