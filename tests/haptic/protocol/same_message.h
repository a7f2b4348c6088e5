// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "haptic/protocol/messages.h"

/// Exact equality of messages, field by field and written apart from the codec, for tests.
namespace hapticell::haptic {

inline bool same(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.w == b.q.w && a.q.x == b.q.x && a.q.y == b.q.y && a.q.z == b.q.z;
}

inline bool same(const Constraint& a, const Constraint& b) {
  return a.group == b.group && a.kind == b.kind && a.gap == b.gap && a.gradient == b.gradient &&
         a.curvature == b.curvature && a.has_trim == b.has_trim && a.trim_gap == b.trim_gap &&
         a.trim_gradient == b.trim_gradient && a.stiffness == b.stiffness && a.damping == b.damping &&
         a.friction == b.friction && a.id == b.id && a.velocity_D == b.velocity_D && a.reach == b.reach;
}

inline bool same(const ConstraintSet& a, const ConstraintSet& b) {
  return a.sequence == b.sequence && a.stamp_ns == b.stamp_ns && same(a.X_DR, b.X_DR) &&
         a.zone_radius == b.zone_radius && a.count == b.count &&
         std::equal(a.active().begin(), a.active().end(), b.active().begin(),
                    [](const Constraint& c, const Constraint& d) { return same(c, d); });
}

inline bool same(const HapticState& a, const HapticState& b) {
  return a.tick == b.tick && a.server_stamp_ns == b.server_stamp_ns && same(a.X_DS, b.X_DS) && same(a.X_DP, b.X_DP) &&
         a.v_DS == b.v_DS && a.force_D == b.force_D && a.torque_D == b.torque_D && a.buttons == b.buttons &&
         a.adopted_set == b.adopted_set && a.forces_on == b.forces_on && a.force_ramp == b.force_ramp &&
         a.motor_temperature == b.motor_temperature && a.device_fault == b.device_fault &&
         a.client_stalled == b.client_stalled;
}

inline bool same(const ServerStatistics& a, const ServerStatistics& b) {
  return a.rate_hz == b.rate_hz && a.late_p50_ms == b.late_p50_ms && a.late_p99_ms == b.late_p99_ms &&
         a.late_max_ms == b.late_max_ms && a.ticks == b.ticks && a.missed_ticks == b.missed_ticks &&
         a.round_trip_ms == b.round_trip_ms && a.set_age_p50_ms == b.set_age_p50_ms &&
         a.set_age_p99_ms == b.set_age_p99_ms && a.late_sets == b.late_sets && a.refused_sets == b.refused_sets &&
         a.dropped_sets == b.dropped_sets && a.clock_offset_ms == b.clock_offset_ms;
}

inline bool same(const HapticControl& a, const HapticControl& b) {
  return a.forces_enabled == b.forces_enabled && a.stiffness == b.stiffness && a.damping == b.damping &&
         a.load == b.load;
}

inline bool same(const HandTarget& a, const HandTarget& b) {
  return a.holding == b.holding && same(a.X_DH, b.X_DH) && a.buttons == b.buttons;
}

inline bool same(const DeviceDescription& a, const DeviceDescription& b) {
  return a.name == b.name && a.simulated == b.simulated && a.workspace_min == b.workspace_min &&
         a.workspace_max == b.workspace_max && a.resolution == b.resolution && a.peak_force == b.peak_force &&
         a.continuous_force == b.continuous_force && a.stiffness == b.stiffness && a.damping == b.damping &&
         a.measured_axes == b.measured_axes && a.driven_axes == b.driven_axes && a.peak_torque == b.peak_torque &&
         a.buttons == b.buttons;
}

inline bool same(const Hello& a, const Hello& b) {
  return a.protocol_version == b.protocol_version && a.kind == b.kind && a.accept_watching == b.accept_watching &&
         a.program == b.program && a.wants_condition == b.wants_condition && a.take_over == b.take_over;
}

inline bool same(const Welcome& a, const Welcome& b) {
  return a.protocol_version == b.protocol_version && a.kind == b.kind && a.tick_rate_hz == b.tick_rate_hz &&
         same(a.device, b.device);
}

inline bool same(const Refusal& a, const Refusal& b) {
  return a.sentence == b.sentence && a.reason == b.reason && a.subject == b.subject;
}

inline bool same(const Heartbeat& a, const Heartbeat& b) {
  return a.sent_ns == b.sent_ns && a.echo_ns == b.echo_ns && a.held_ns == b.held_ns;
}

inline bool same(const DeviceCondition& a, const DeviceCondition& b) {
  return a.answers == b.answers && a.calibrated == b.calibrated && a.docked == b.docked &&
         a.calibration == b.calibration && a.sentence == b.sentence;
}

inline bool same(const Calibrate& a, const Calibrate& b) {
  return a.step == b.step;
}

inline bool same(std::monostate, std::monostate) {
  return true;
}

inline bool same(const Message& a, const Message& b) {
  if (a.index() != b.index()) return false;
  return std::visit([&b](const auto& value) { return same(value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
}

}  // namespace hapticell::haptic
