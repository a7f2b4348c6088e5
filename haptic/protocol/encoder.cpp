// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>
#include <vector>

#include "geometry/system/assertion.h"
#include "haptic/protocol/codec.h"
#include "haptic/protocol/hapticell_generated.h"
#include "haptic/protocol/wire_values.h"

namespace hapticell::haptic {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

namespace {

Offset<flatbuffers::String> text(FlatBufferBuilder& builder, std::string_view text) {
  return builder.CreateString(text.substr(0, kMaxTextBytes));
}

Offset<wire::Hello> write(FlatBufferBuilder& builder, const Hello& hello) {
  return wire::CreateHello(builder, hello.protocol_version, toWire(hello.kind), hello.accept_watching,
                           text(builder, hello.program), hello.wants_condition, hello.take_over);
}

Offset<wire::Device> write(FlatBufferBuilder& builder, const DeviceDescription& device) {
  const auto name = text(builder, device.name);
  const wire::Vector3 least = toWire(device.workspace_min), most = toWire(device.workspace_max);
  return wire::CreateDevice(builder, name, device.simulated, &least, &most, device.resolution, device.peak_force,
                            device.continuous_force, device.stiffness, device.damping, device.measured_axes,
                            device.driven_axes, device.buttons, device.peak_torque);
}

Offset<wire::Welcome> write(FlatBufferBuilder& builder, const Welcome& welcome) {
  const auto device = write(builder, welcome.device);
  return wire::CreateWelcome(builder, welcome.protocol_version, toWire(welcome.kind), welcome.tick_rate_hz, device);
}

Offset<wire::Refusal> write(FlatBufferBuilder& builder, const Refusal& refusal) {
  const auto sentence = text(builder, refusal.sentence), subject = text(builder, refusal.subject);
  return wire::CreateRefusal(builder, sentence, static_cast<wire::RefusalReason>(refusal.reason), subject);
}

Offset<wire::Constraint> write(FlatBufferBuilder& builder, const Constraint& constraint) {
  const wire::Vector6 gradient = toWire(constraint.gradient);
  const wire::SymmetricMatrix6 curvature(constraint.curvature);
  const wire::Trim trim(constraint.trim_gap, toWire(constraint.trim_gradient));
  const bool curved =
      std::any_of(constraint.curvature.begin(), constraint.curvature.end(), [](double v) { return v != 0.0; });
  const wire::Vector3 velocity = toWire(constraint.velocity_D);
  wire::ConstraintBuilder entry(builder);
  if (constraint.velocity_D != dvec3(0.0)) entry.add_velocity(&velocity);
  entry.add_id(constraint.id);
  entry.add_friction(constraint.friction);
  entry.add_damping(constraint.damping);
  entry.add_stiffness(constraint.stiffness);
  if (constraint.has_trim) entry.add_trim(&trim);
  if (curved) entry.add_curvature(&curvature);
  entry.add_gradient(&gradient);
  entry.add_gap(constraint.gap);
  entry.add_group(constraint.group);
  entry.add_reach(constraint.reach);
  entry.add_kind(static_cast<wire::ConstraintKind>(constraint.kind));
  return entry.Finish();
}

Offset<wire::ConstraintSet> write(FlatBufferBuilder& builder, const ConstraintSet& set) {
  HAPTICELL_DEMAND(set.count <= kMaxConstraints);
  std::array<Offset<wire::Constraint>, kMaxConstraints> entries;
  std::transform(set.active().begin(), set.active().end(), entries.begin(),
                 [&](const Constraint& constraint) { return write(builder, constraint); });
  const auto constraints = builder.CreateVector(entries.data(), set.count);
  const wire::Pose reference = toWire(set.X_DR);
  return wire::CreateConstraintSet(builder, set.sequence, set.stamp_ns, &reference, set.zone_radius, constraints);
}

Offset<wire::State> write(FlatBufferBuilder& builder, const HapticState& state) {
  const wire::Pose stylus = toWire(state.X_DS), proxy = toWire(state.X_DP);
  const wire::Vector3 velocity = toWire(state.v_DS), force = toWire(state.force_D);
  const wire::Vector3 torque = toWire(state.torque_D);
  return wire::CreateState(builder, state.tick, state.server_stamp_ns, &stylus, &proxy, &velocity, &force,
                           state.buttons, state.adopted_set, state.forces_on, state.force_ramp, state.motor_temperature,
                           state.device_fault, &torque, state.client_stalled);
}

Offset<wire::Statistics> write(FlatBufferBuilder& builder, const ServerStatistics& s) {
  return wire::CreateStatistics(builder, s.rate_hz, s.late_p50_ms, s.late_p99_ms, s.late_max_ms, s.ticks,
                                s.missed_ticks, s.round_trip_ms, s.set_age_p50_ms, s.set_age_p99_ms, s.late_sets,
                                s.refused_sets, s.clock_offset_ms.has_value(), s.clock_offset_ms.value_or(0.0),
                                s.dropped_sets);
}

Offset<wire::Control> write(FlatBufferBuilder& builder, const HapticControl& control) {
  const wire::Vector3 weight = toWire(control.load.weight_D);
  return wire::CreateControl(builder, control.forces_enabled, control.stiffness, control.damping, control.load.mass,
                             control.load.damping, control.load.friction, &weight);
}

Offset<wire::HandTarget> write(FlatBufferBuilder& builder, const HandTarget& target) {
  const wire::Pose pose = toWire(target.X_DH);
  return wire::CreateHandTarget(builder, target.holding, &pose, target.buttons);
}

Offset<wire::Heartbeat> write(FlatBufferBuilder& builder, const Heartbeat& beat) {
  return wire::CreateHeartbeat(builder, beat.sent_ns, beat.echo_ns, beat.held_ns);
}

Offset<wire::DeviceCondition> write(FlatBufferBuilder& builder, const DeviceCondition& condition) {
  std::vector<Offset<flatbuffers::String>> steps;
  for (const std::string& step : condition.calibration) {
    if (steps.size() < kMaxCalibrationSteps) steps.push_back(text(builder, step));
  }
  const auto calibration = builder.CreateVector(steps);
  const auto sentence = text(builder, condition.sentence);
  return wire::CreateDeviceCondition(builder, condition.answers, condition.calibrated, condition.docked, calibration,
                                     sentence);
}

Offset<wire::Calibrate> write(FlatBufferBuilder& builder, const Calibrate& calibrate) {
  return wire::CreateCalibrate(builder, calibrate.step);
}

}  // namespace

struct Encoder::Implementation {
  FlatBufferBuilder builder{1024};
  std::vector<std::uint8_t> frame;

  template <typename T>
  std::span<const std::uint8_t> encode(const T& value) {
    builder.Clear();
    const auto body = write(builder, value);
    const auto envelope = wire::CreateEnvelope(builder, wire::BodyTraits<wireType<T>>::enum_value, body.Union());
    // Not FinishSizePrefixed(): that aligns numbers to the prefix, so the FlatBuffer alone would not be a valid one.
    builder.Finish(envelope, wire::EnvelopeIdentifier());
    const std::uint32_t length = builder.GetSize();
    frame.resize(kFrameHeaderBytes + length);
    for (std::size_t i = 0; i < kFrameHeaderBytes; ++i) frame[i] = static_cast<std::uint8_t>(length >> (8 * i));
    std::copy_n(builder.GetBufferPointer(), length, frame.data() + kFrameHeaderBytes);
    return frame;
  }
};

Encoder::Encoder() : implementation_(std::make_unique<Implementation>()) {}
Encoder::~Encoder() = default;
Encoder::Encoder(Encoder&&) noexcept = default;
Encoder& Encoder::operator=(Encoder&&) noexcept = default;

std::span<const std::uint8_t> Encoder::encode(const ConstraintSet& set) {
  return implementation_->encode(set);
}

std::span<const std::uint8_t> Encoder::encode(const HapticState& state) {
  return implementation_->encode(state);
}

std::span<const std::uint8_t> Encoder::encode(const Message& message) {
  return std::visit(
      [this](const auto& value) -> std::span<const std::uint8_t> {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          HAPTICELL_DEMAND(!"a message without content cannot be sent");
          return {};
        } else {
          return implementation_->encode(value);
        }
      },
      message);
}

}  // namespace hapticell::haptic
