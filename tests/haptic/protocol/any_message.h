// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>
#include <algorithm>
#include <cmath>

#include "geometry/system/plain_text.h"
#include "haptic/protocol/codec.h"

/// Generators of arbitrary well-formed messages, for property tests.
namespace hapticell::haptic::any {

/// Any finite bit pattern within the bound, tiny and huge ones included.
inline double number(double most = bound::kLength) {
  const double value = *rc::gen::arbitrary<double>();
  return std::isfinite(value) ? std::fmod(value, most) : most;
}

inline double notNegative(double most = bound::kLength) {
  return std::abs(number(most));
}

inline dvec3 vector(double most = bound::kLength) {
  return {number(most), number(most), number(most)};
}

inline Pose pose() {
  const auto part = [] { return *rc::gen::inRange(-1000, 1000) * 1e-3; };
  dquat q(part(), part(), part(), part());
  if (glm::dot(q, q) < 1e-6) q = dquat(1.0, 0.0, 0.0, 0.0);
  return {vector(), glm::normalize(q)};
}

template <std::size_t N>
std::array<double, N> numbers(double most) {
  std::array<double, N> values;
  for (double& value : values) value = number(most);
  return values;
}

/// As it comes out of the decoder, which cleans it.
inline std::string text() {
  return plainText(*rc::gen::container<std::string>(rc::gen::arbitrary<char>()));
}

inline Constraint constraint() {
  Constraint c;
  c.group = *rc::gen::arbitrary<std::uint32_t>();
  c.kind = *rc::gen::element(ConstraintKind::kInequality, ConstraintKind::kEquality, ConstraintKind::kPull);
  c.gap = number();
  c.gradient = numbers<6>(bound::kSlope);
  if (*rc::gen::arbitrary<bool>()) c.curvature = numbers<21>(bound::kCurvature);
  c.has_trim = *rc::gen::arbitrary<bool>();
  if (c.has_trim) {
    c.trim_gap = number();
    c.trim_gradient = numbers<6>(bound::kSlope);
  }
  c.stiffness = notNegative();
  c.damping = notNegative(bound::kDamping);
  c.friction = notNegative(bound::kFriction);
  c.reach = notNegative();
  c.id = *rc::gen::arbitrary<std::uint64_t>();
  if (*rc::gen::arbitrary<bool>()) c.velocity_D = vector();
  return c;
}

inline ConstraintSet constraintSet() {
  ConstraintSet set;
  set.sequence = *rc::gen::arbitrary<std::uint64_t>();
  set.stamp_ns = *rc::gen::arbitrary<std::int64_t>();
  set.X_DR = pose();
  set.zone_radius = std::max(notNegative(), bound::kLeastZone);
  set.count = *rc::gen::element<std::size_t>(0, 1, 2, 5, kMaxConstraints);
  for (std::size_t i = 0; i < set.count; ++i) set.constraints[i] = constraint();
  return set;
}

inline HapticState state() {
  HapticState s;
  s.tick = *rc::gen::arbitrary<std::uint64_t>();
  s.server_stamp_ns = *rc::gen::arbitrary<std::int64_t>();
  s.X_DS = pose();
  s.X_DP = pose();
  s.v_DS = vector();
  s.force_D = vector();
  s.torque_D = vector();
  s.buttons = *rc::gen::arbitrary<std::uint32_t>();
  s.adopted_set = *rc::gen::arbitrary<std::uint64_t>();
  s.forces_on = *rc::gen::arbitrary<bool>();
  s.force_ramp = *rc::gen::inRange(0, 1001) * 1e-3;
  s.motor_temperature = notNegative();
  s.device_fault = *rc::gen::arbitrary<bool>();
  s.client_stalled = *rc::gen::arbitrary<bool>();
  return s;
}

inline ServerStatistics statistics() {
  ServerStatistics s;
  s.rate_hz = notNegative();
  s.late_p50_ms = notNegative();
  s.late_p99_ms = notNegative();
  s.late_max_ms = notNegative();
  s.ticks = *rc::gen::arbitrary<std::uint64_t>();
  s.missed_ticks = *rc::gen::arbitrary<std::uint64_t>();
  s.round_trip_ms = number();
  s.set_age_p50_ms = number();
  s.set_age_p99_ms = number();
  s.late_sets = *rc::gen::arbitrary<std::uint64_t>();
  s.refused_sets = *rc::gen::arbitrary<std::uint64_t>();
  s.dropped_sets = *rc::gen::arbitrary<std::uint64_t>();
  if (*rc::gen::arbitrary<bool>()) s.clock_offset_ms = number();
  return s;
}

inline DeviceDescription device() {
  DeviceDescription d;
  d.name = text();
  d.simulated = *rc::gen::arbitrary<bool>();
  d.workspace_min = {-0.1 * *rc::gen::inRange(0, 10), -0.2, -0.3};
  d.workspace_max = {0.1, 0.2 * *rc::gen::inRange(0, 10), 0.3};
  d.resolution = notNegative();
  d.peak_force = notNegative();
  d.continuous_force = notNegative();
  d.stiffness = notNegative();
  d.damping = notNegative(bound::kDamping);
  d.measured_axes = *rc::gen::inRange(0, 7);
  d.driven_axes = *rc::gen::inRange(0, 7);
  d.buttons = *rc::gen::inRange(0, 33);
  d.peak_torque = notNegative();
  return d;
}

inline DeviceCondition condition() {
  DeviceCondition c{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), {}, text()};
  c.calibration.resize(*rc::gen::inRange<std::size_t>(0, kMaxCalibrationSteps + 1));
  for (std::string& step : c.calibration) step = text();
  return c;
}

inline ClientKind kind() {
  return *rc::gen::element(ClientKind::kController, ClientKind::kWatcher);
}

/// A message of any type.
inline Message message() {
  switch (*rc::gen::inRange(0, 11)) {
    case 0:
      return Hello{*rc::gen::arbitrary<std::uint32_t>(), kind(), *rc::gen::arbitrary<bool>(), text(),
                   *rc::gen::arbitrary<bool>()};
    case 1:
      return Welcome{*rc::gen::arbitrary<std::uint32_t>(), kind(), 1.0 * *rc::gen::inRange(1, 4000), device()};
    case 2:
      return Refusal{text(), static_cast<RefusalReason>(*rc::gen::inRange(0, 6)), text()};
    case 3:
      return constraintSet();
    case 4:
      return state();
    case 5:
      return statistics();
    case 6:
      return HapticControl{*rc::gen::arbitrary<bool>(),
                           notNegative(bound::kStiffness),
                           notNegative(bound::kDamping),
                           {notNegative(), notNegative(bound::kDamping), notNegative(), vector()}};
    case 7:
      return HandTarget{*rc::gen::arbitrary<bool>(), pose(), *rc::gen::arbitrary<std::uint32_t>()};
    case 8:
      return condition();
    case 9:
      return Calibrate{*rc::gen::arbitrary<std::uint32_t>()};
    default:
      return Heartbeat{*rc::gen::arbitrary<std::int64_t>(), *rc::gen::arbitrary<std::int64_t>(),
                       *rc::gen::arbitrary<std::int64_t>()};
  }
}

}  // namespace hapticell::haptic::any
