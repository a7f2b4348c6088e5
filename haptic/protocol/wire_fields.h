// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

#include "haptic/protocol/wire_values.h"

// Which member of a message is which field on the wire. A new field is a line in hapticell.fbs, its member in
// messages.h and a line here: the encoder and the decoder are both made from these lists. For the codec only.
namespace hapticell::haptic {

/// A field of a table, by its generated getter and its builder's adder.
template <typename Getter, typename Adder>
struct WireField {
  constexpr WireField(const char* field_name, Getter getter, Adder adder) : name(field_name), get(getter), add(adder) {}
  const char* name;  ///< "State.force", for errors.
  Getter get;
  Adder add;
};

#define HAPTICELL_WIRE(table, field) \
  WireField(#table "." #field, &wire::table::field, &wire::table##Builder::add_##field)

/// `Value`, or const `Value`: the same list serves the reader and the writer.
template <typename T, typename Value>
concept Is = std::same_as<std::remove_const_t<T>, Value>;

// What the visitor `field` offers:
//   field(member, WIRE)           a number, an enumeration, or a vector that is zero where it is absent
//   field.required(member, WIRE)  a vector or pose without which a message is refused
//   field.text(member, WIRE)      a string, field.texts(...) several
//   field.table(member, WIRE)     another message in this one, field.tables(members, count, WIRE) several
//   field.known(member, WIRE, WIRE)  an optional number: whether it is known, and the number

void wireFields(auto& field, Is<Hello> auto& hello) {
  field(hello.protocol_version, HAPTICELL_WIRE(Hello, protocol_version));
  field(hello.kind, HAPTICELL_WIRE(Hello, kind));
  field(hello.accept_watching, HAPTICELL_WIRE(Hello, accept_watching));
  field.text(hello.program, HAPTICELL_WIRE(Hello, program));
  field(hello.wants_condition, HAPTICELL_WIRE(Hello, wants_condition));
  field(hello.take_over, HAPTICELL_WIRE(Hello, take_over));
}

void wireFields(auto& field, Is<DeviceDescription> auto& device) {
  field.text(device.name, HAPTICELL_WIRE(Device, name));
  field(device.simulated, HAPTICELL_WIRE(Device, simulated));
  field.required(device.workspace_min, HAPTICELL_WIRE(Device, workspace_min));
  field.required(device.workspace_max, HAPTICELL_WIRE(Device, workspace_max));
  field(device.resolution, HAPTICELL_WIRE(Device, resolution));
  field(device.peak_force, HAPTICELL_WIRE(Device, peak_force));
  field(device.continuous_force, HAPTICELL_WIRE(Device, continuous_force));
  field(device.stiffness, HAPTICELL_WIRE(Device, stiffness));
  field(device.damping, HAPTICELL_WIRE(Device, damping));
  field(device.measured_axes, HAPTICELL_WIRE(Device, measured_axes));
  field(device.driven_axes, HAPTICELL_WIRE(Device, driven_axes));
  field(device.buttons, HAPTICELL_WIRE(Device, buttons));
  field(device.peak_torque, HAPTICELL_WIRE(Device, peak_torque));
}

void wireFields(auto& field, Is<Welcome> auto& welcome) {
  field(welcome.protocol_version, HAPTICELL_WIRE(Welcome, protocol_version));
  field(welcome.kind, HAPTICELL_WIRE(Welcome, kind));
  field(welcome.tick_rate_hz, HAPTICELL_WIRE(Welcome, tick_rate_hz));
  field.table(welcome.device, HAPTICELL_WIRE(Welcome, device));
}

void wireFields(auto& field, Is<Refusal> auto& refusal) {
  field.text(refusal.sentence, HAPTICELL_WIRE(Refusal, sentence));
  field(refusal.reason, HAPTICELL_WIRE(Refusal, reason));
  field.text(refusal.subject, HAPTICELL_WIRE(Refusal, subject));
}

void wireFields(auto& field, Is<Constraint> auto& constraint) {
  field(constraint.group, HAPTICELL_WIRE(Constraint, group));
  field(constraint.kind, HAPTICELL_WIRE(Constraint, kind));
  field(constraint.gap, HAPTICELL_WIRE(Constraint, gap));
  field.required(constraint.gradient, HAPTICELL_WIRE(Constraint, gradient));
  field(constraint.curvature, HAPTICELL_WIRE(Constraint, curvature));
  field.trim(constraint, HAPTICELL_WIRE(Constraint, trim));
  field(constraint.stiffness, HAPTICELL_WIRE(Constraint, stiffness));
  field(constraint.damping, HAPTICELL_WIRE(Constraint, damping));
  field(constraint.friction, HAPTICELL_WIRE(Constraint, friction));
  field(constraint.id, HAPTICELL_WIRE(Constraint, id));
  field(constraint.velocity_D, HAPTICELL_WIRE(Constraint, velocity));
  field(constraint.reach, HAPTICELL_WIRE(Constraint, reach));
}

void wireFields(auto& field, Is<ConstraintSet> auto& set) {
  field(set.sequence, HAPTICELL_WIRE(ConstraintSet, sequence));
  field(set.stamp_ns, HAPTICELL_WIRE(ConstraintSet, stamp_ns));
  field.required(set.X_DR, HAPTICELL_WIRE(ConstraintSet, reference));
  field(set.zone_radius, HAPTICELL_WIRE(ConstraintSet, zone_radius));
  field.tables(set.constraints, set.count, HAPTICELL_WIRE(ConstraintSet, constraints));
}

void wireFields(auto& field, Is<HapticState> auto& state) {
  field(state.tick, HAPTICELL_WIRE(State, tick));
  field(state.server_stamp_ns, HAPTICELL_WIRE(State, server_stamp_ns));
  field.required(state.X_DS, HAPTICELL_WIRE(State, stylus));
  field.required(state.X_DP, HAPTICELL_WIRE(State, proxy));
  field.required(state.v_DS, HAPTICELL_WIRE(State, velocity));
  field.required(state.force_D, HAPTICELL_WIRE(State, force));
  field(state.buttons, HAPTICELL_WIRE(State, buttons));
  field(state.adopted_set, HAPTICELL_WIRE(State, adopted_set));
  field(state.forces_on, HAPTICELL_WIRE(State, forces_on));
  field(state.force_ramp, HAPTICELL_WIRE(State, force_ramp));
  field(state.motor_temperature, HAPTICELL_WIRE(State, motor_temperature));
  field(state.device_fault, HAPTICELL_WIRE(State, device_fault));
  field(state.torque_D, HAPTICELL_WIRE(State, torque));
  field(state.client_stalled, HAPTICELL_WIRE(State, client_stalled));
}

void wireFields(auto& field, Is<ServerStatistics> auto& statistics) {
  field(statistics.rate_hz, HAPTICELL_WIRE(Statistics, rate_hz));
  field(statistics.late_p50_ms, HAPTICELL_WIRE(Statistics, late_p50_ms));
  field(statistics.late_p99_ms, HAPTICELL_WIRE(Statistics, late_p99_ms));
  field(statistics.late_max_ms, HAPTICELL_WIRE(Statistics, late_max_ms));
  field(statistics.ticks, HAPTICELL_WIRE(Statistics, ticks));
  field(statistics.missed_ticks, HAPTICELL_WIRE(Statistics, missed_ticks));
  field(statistics.round_trip_ms, HAPTICELL_WIRE(Statistics, round_trip_ms));
  field(statistics.set_age_p50_ms, HAPTICELL_WIRE(Statistics, set_age_p50_ms));
  field(statistics.set_age_p99_ms, HAPTICELL_WIRE(Statistics, set_age_p99_ms));
  field(statistics.late_sets, HAPTICELL_WIRE(Statistics, late_sets));
  field(statistics.refused_sets, HAPTICELL_WIRE(Statistics, refused_sets));
  field.known(statistics.clock_offset_ms, HAPTICELL_WIRE(Statistics, clock_known),
              HAPTICELL_WIRE(Statistics, clock_offset_ms));
  field(statistics.dropped_sets, HAPTICELL_WIRE(Statistics, dropped_sets));
}

void wireFields(auto& field, Is<HapticControl> auto& control) {
  field(control.forces_enabled, HAPTICELL_WIRE(Control, forces_enabled));
  field(control.stiffness, HAPTICELL_WIRE(Control, stiffness));
  field(control.damping, HAPTICELL_WIRE(Control, damping));
  field(control.load.mass, HAPTICELL_WIRE(Control, load_mass));
  field(control.load.damping, HAPTICELL_WIRE(Control, load_damping));
  field(control.load.friction, HAPTICELL_WIRE(Control, load_friction));
  field(control.load.weight_D, HAPTICELL_WIRE(Control, load_weight));
}

void wireFields(auto& field, Is<HandTarget> auto& target) {
  field(target.holding, HAPTICELL_WIRE(HandTarget, holding));
  field.required(target.X_DH, HAPTICELL_WIRE(HandTarget, pose));
  field(target.buttons, HAPTICELL_WIRE(HandTarget, buttons));
}

void wireFields(auto& field, Is<Heartbeat> auto& beat) {
  field(beat.sent_ns, HAPTICELL_WIRE(Heartbeat, sent_ns));
  field(beat.echo_ns, HAPTICELL_WIRE(Heartbeat, echo_ns));
  field(beat.held_ns, HAPTICELL_WIRE(Heartbeat, held_ns));
}

void wireFields(auto& field, Is<DeviceCondition> auto& condition) {
  field(condition.answers, HAPTICELL_WIRE(DeviceCondition, answers));
  field(condition.calibrated, HAPTICELL_WIRE(DeviceCondition, calibrated));
  field(condition.docked, HAPTICELL_WIRE(DeviceCondition, docked));
  field.texts(condition.calibration, HAPTICELL_WIRE(DeviceCondition, calibration));
  field.text(condition.sentence, HAPTICELL_WIRE(DeviceCondition, sentence));
}

void wireFields(auto& field, Is<Calibrate> auto& calibrate) {
  field(calibrate.step, HAPTICELL_WIRE(Calibrate, step));
}

}  // namespace hapticell::haptic
