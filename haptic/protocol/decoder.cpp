// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <string>

#include "geometry/system/plain_text.h"
#include "haptic/protocol/codec.h"
#include "haptic/protocol/hapticell_generated.h"
#include "haptic/protocol/wire_values.h"

namespace hapticell::haptic {

namespace {

/// A frame nests Envelope, body, constraint: more is another format. Tables: a full set has 64 and some. Half of the
/// first: too few for a later version; twice: hostile frames cost more to check.
constexpr flatbuffers::uoffset_t kMaxDepth = 8;
constexpr flatbuffers::uoffset_t kMaxTables = 256;

tl::unexpected<Error> refuse(Text place, Text found, Text expected) {
  return makeError({.file = "haptic message",
                    .place = std::move(place),
                    .found = std::move(found),
                    .expected = std::move(expected),
                    .fix = ""});
}

/// What others wrote, as it may be logged and drawn.
Expected<std::string> text(const flatbuffers::String* text, const std::string& place) {
  if (text == nullptr) return std::string();
  if (text->size() > kMaxTextBytes) {
    return refuse(place, Text("%1 bytes", text->size()), Text("at most %1", kMaxTextBytes));
  }
  return plainText({text->c_str(), text->size()}, kMaxTextBytes);
}

Expected<ClientKind> clientKind(wire::ClientKind kind, const std::string& place) {
  if (kind == wire::ClientKind_Controller) return ClientKind::kController;
  if (kind == wire::ClientKind_Watcher) return ClientKind::kWatcher;
  return refuse(place, Text("client kind %1", static_cast<int>(kind)), Text("0 (controller) or 1 (observer)"));
}

/// A struct that must be there: a pose, a vector.
template <typename T>
bool copy(const T* from, auto& to) {
  if (from == nullptr) return false;
  to = fromWire(*from);
  return true;
}

Expected<void> read(const wire::Hello& from, Hello& to) {
  const auto kind = clientKind(from.kind(), "Hello.kind");
  const auto program = text(from.program(), "Hello.program");
  HAPTICELL_TRY(kind);
  HAPTICELL_TRY(program);
  to = {from.protocol_version(), *kind, from.accept_watching(), *program, from.wants_condition(), from.take_over()};
  return {};
}

Expected<void> read(const wire::Device& from, DeviceDescription& to) {
  auto name = text(from.name(), "Device.name");
  HAPTICELL_TRY(name);
  if (!copy(from.workspace_min(), to.workspace_min) || !copy(from.workspace_max(), to.workspace_max)) {
    return refuse("Device", Text("the workspace is missing"), Text("workspace_min and workspace_max"));
  }
  to.name = std::move(*name);
  to.simulated = from.simulated();
  to.resolution = from.resolution();
  to.peak_force = from.peak_force();
  to.continuous_force = from.continuous_force();
  to.stiffness = from.stiffness();
  to.damping = from.damping();
  to.measured_axes = from.measured_axes();
  to.driven_axes = from.driven_axes();
  to.buttons = from.buttons();
  to.peak_torque = from.peak_torque();
  if (!isWellFormed(to))
    return refuse("Device", Text("a value is out of range"), Text("finite numbers, and a minimum below the maximum"));
  return {};
}

Expected<void> read(const wire::Welcome& from, Welcome& to) {
  const auto kind = clientKind(from.kind(), "Welcome.kind");
  HAPTICELL_TRY(kind);
  if (from.device() == nullptr) return refuse("Welcome", Text("no device"), Text("a device"));
  to.protocol_version = from.protocol_version();
  to.kind = *kind;
  to.tick_rate_hz = from.tick_rate_hz();
  if (!(to.tick_rate_hz > 0.0 && to.tick_rate_hz <= 1e5)) {
    return refuse("Welcome.tick_rate_hz", std::to_string(to.tick_rate_hz), Text("above 0, at most 100000"));
  }
  return read(*from.device(), to.device);
}

Expected<void> read(const wire::Refusal& from, Refusal& to) {
  auto sentence = text(from.sentence(), "Refusal.sentence");
  auto subject = text(from.subject(), "Refusal.subject");
  HAPTICELL_TRY(sentence);
  HAPTICELL_TRY(subject);
  // A server of a later release may have more reasons; its sentence tells them.
  const bool known = from.reason() <= wire::RefusalReason_MAX;
  to = {std::move(*sentence), known ? static_cast<RefusalReason>(from.reason()) : RefusalReason::kOther,
        std::move(*subject)};
  return {};
}

bool read(const wire::Constraint& from, Constraint& to) {
  if (from.kind() > wire::ConstraintKind_MAX || !copy(from.gradient(), to.gradient)) return false;
  to.group = from.group();
  to.kind = static_cast<ConstraintKind>(from.kind());
  to.reach = from.reach();
  to.gap = from.gap();
  to.curvature = {};
  if (from.curvature() != nullptr) {
    for (std::size_t i = 0; i < to.curvature.size(); ++i) {
      to.curvature[i] = from.curvature()->values()->Get(static_cast<flatbuffers::uoffset_t>(i));
    }
  }
  to.has_trim = from.trim() != nullptr;
  to.trim_gap = to.has_trim ? from.trim()->gap() : 0.0;
  to.trim_gradient = to.has_trim ? fromWire(from.trim()->gradient()) : Vector6{};
  to.stiffness = from.stiffness();
  to.damping = from.damping();
  to.friction = from.friction();
  to.id = from.id();
  to.velocity_D = from.velocity() != nullptr ? fromWire(*from.velocity()) : dvec3(0.0);
  return true;
}

Expected<void> read(const wire::ConstraintSet& from, ConstraintSet& to) {
  if (!copy(from.reference(), to.X_DR))
    return refuse("ConstraintSet", Text("the reference pose is missing"), Text("a pose"));
  to.sequence = from.sequence();
  to.stamp_ns = from.stamp_ns();
  to.zone_radius = from.zone_radius();
  to.count = from.constraints() == nullptr ? 0 : from.constraints()->size();
  if (to.count > kMaxConstraints) {
    return refuse("ConstraintSet.constraints", Text("%1 entries", to.count), Text("at most %1", kMaxConstraints));
  }
  for (std::size_t i = 0; i < to.count; ++i) {
    const wire::Constraint* entry = from.constraints()->Get(static_cast<flatbuffers::uoffset_t>(i));
    if (!read(*entry, to.constraints[i])) {
      return refuse(Text("constraint %1", i), Text("an unknown kind, or the gradient is missing"),
                    Text("kind 0, 1 or 2 and a gradient"));
    }
  }
  if (!isWellFormed(to)) {
    return refuse("ConstraintSet", Text("a number that is not finite or out of its range"),
                  Text("finite numbers within the bounds of docs/library/protocol.md, a unit quaternion, a zone above "
                       "0, and no negative stiffness, damping or friction"));
  }
  return {};
}

Expected<void> read(const wire::State& from, HapticState& to) {
  if (!copy(from.stylus(), to.X_DS) || !copy(from.proxy(), to.X_DP) || !copy(from.velocity(), to.v_DS) ||
      !copy(from.force(), to.force_D)) {
    return refuse("State", Text("a field is missing"), Text("stylus, proxy, velocity and force"));
  }
  to.torque_D = from.torque() != nullptr ? fromWire(*from.torque()) : dvec3(0.0);
  to.tick = from.tick();
  to.server_stamp_ns = from.server_stamp_ns();
  to.buttons = from.buttons();
  to.adopted_set = from.adopted_set();
  to.forces_on = from.forces_on();
  to.force_ramp = from.force_ramp();
  to.motor_temperature = from.motor_temperature();
  to.device_fault = from.device_fault();
  to.client_stalled = from.client_stalled();
  if (!isWellFormed(to))
    return refuse("State", Text("a number that is not finite or out of its range"),
                  Text("valid poses, finite numbers"));
  return {};
}

Expected<void> read(const wire::Statistics& from, ServerStatistics& to) {
  to = {from.rate_hz(),      from.late_p50_ms(),   from.late_p99_ms(),    from.late_max_ms(),    from.ticks(),
        from.missed_ticks(), from.round_trip_ms(), from.set_age_p50_ms(), from.set_age_p99_ms(), from.late_sets(),
        from.refused_sets(), from.dropped_sets(),  std::nullopt};
  if (from.clock_known()) to.clock_offset_ms = from.clock_offset_ms();
  if (!isWellFormed(to))
    return refuse("Statistics", Text("a number that is negative or not finite"), Text("finite numbers, 0 or more"));
  return {};
}

Expected<void> read(const wire::Control& from, HapticControl& to) {
  to = {from.forces_enabled(), from.stiffness(), from.damping(), {}};
  to.load.mass = from.load_mass();
  to.load.damping = from.load_damping();
  to.load.friction = from.load_friction();
  if (from.load_weight() != nullptr) to.load.weight_D = fromWire(*from.load_weight());
  if (!isWellFormed(to))
    return refuse("Control", Text("a stiffness, damping or load that is negative, not finite or too large"),
                  Text("0 or more, within the bounds of docs/library/protocol.md"));
  return {};
}

Expected<void> read(const wire::HandTarget& from, HandTarget& to) {
  if (!copy(from.pose(), to.X_DH)) return refuse("HandTarget", Text("the pose is missing"), Text("a pose"));
  to.holding = from.holding();
  to.buttons = from.buttons();
  if (!isWellFormed(to))
    return refuse("HandTarget", Text("an invalid pose"),
                  Text("finite numbers, at most 1 000 000 m, and a unit quaternion"));
  return {};
}

Expected<void> read(const wire::Heartbeat& from, Heartbeat& to) {
  to = {from.sent_ns(), from.echo_ns(), from.held_ns()};
  return {};
}

Expected<void> read(const wire::DeviceCondition& from, DeviceCondition& to) {
  const std::size_t steps = from.calibration() == nullptr ? 0 : from.calibration()->size();
  if (steps > kMaxCalibrationSteps) {
    return refuse("DeviceCondition.calibration", Text("%1 steps", steps), Text("at most %1", kMaxCalibrationSteps));
  }
  to = {from.answers(), from.calibrated(), from.docked(), {}, {}};
  for (std::size_t i = 0; i < steps; ++i) {
    auto step = text(from.calibration()->Get(static_cast<flatbuffers::uoffset_t>(i)), "DeviceCondition.calibration");
    HAPTICELL_TRY(step);
    to.calibration.push_back(std::move(*step));
  }
  auto sentence = text(from.sentence(), "DeviceCondition.sentence");
  HAPTICELL_TRY(sentence);
  to.sentence = std::move(*sentence);
  return {};
}

Expected<void> read(const wire::Calibrate& from, Calibrate& to) {
  to = {from.step()};
  return {};
}

/// Reads into the alternative that `message` holds already, if it is the right one: a set is large.
template <typename T>
Expected<void> readInto(const wire::Envelope& envelope, Message& message) {
  if (!std::holds_alternative<T>(message)) message.emplace<T>();
  return read(*envelope.body_as<wireType<T>>(), std::get<T>(message));
}

Expected<void> readBody(const wire::Envelope& envelope, Message& message) {
  if (envelope.body() == nullptr) return refuse({}, Text("an empty message"), Text("a message with content"));
  switch (envelope.body_type()) {
    case wire::Body_Hello:
      return readInto<Hello>(envelope, message);
    case wire::Body_Welcome:
      return readInto<Welcome>(envelope, message);
    case wire::Body_Refusal:
      return readInto<Refusal>(envelope, message);
    case wire::Body_ConstraintSet:
      return readInto<ConstraintSet>(envelope, message);
    case wire::Body_State:
      return readInto<HapticState>(envelope, message);
    case wire::Body_Statistics:
      return readInto<ServerStatistics>(envelope, message);
    case wire::Body_Control:
      return readInto<HapticControl>(envelope, message);
    case wire::Body_HandTarget:
      return readInto<HandTarget>(envelope, message);
    case wire::Body_Heartbeat:
      return readInto<Heartbeat>(envelope, message);
    case wire::Body_DeviceCondition:
      return readInto<DeviceCondition>(envelope, message);
    case wire::Body_Calibrate:
      return readInto<Calibrate>(envelope, message);
    case wire::Body_NONE:
      break;
  }
  return refuse({}, Text("message type %1", static_cast<int>(envelope.body_type())),
                Text("1 to %1", static_cast<int>(wire::Body_MAX)));
}

Expected<void> decodeAligned(const std::uint8_t* bytes, std::size_t size, Message& message) {
  flatbuffers::Verifier verifier(bytes, size, kMaxDepth, kMaxTables);
  if (size < 12 || !wire::EnvelopeBufferHasIdentifier(bytes)) {
    return refuse({}, Text("%1 bytes without the identifier", size), Text("a FlatBuffer with the identifier HCEL"));
  }
  if (!wire::VerifyEnvelopeBuffer(verifier)) {
    return refuse({}, Text("a damaged FlatBuffer"), Text("a valid Envelope"));
  }
  return readBody(*wire::GetEnvelope(bytes), message);
}

}  // namespace

Expected<void> decode(std::span<const std::uint8_t> flatbuffer, Message& message) {
  if (flatbuffer.size() > kMaxFrameBytes) {
    return refuse({}, Text("%1 bytes", flatbuffer.size()), Text("at most %1", kMaxFrameBytes));
  }
  // FlatBuffers reads eight-byte numbers in place: the buffer must start where one may.
  if (reinterpret_cast<std::uintptr_t>(flatbuffer.data()) % alignof(std::uint64_t) == 0) {
    return decodeAligned(flatbuffer.data(), flatbuffer.size(), message);
  }
  thread_local std::vector<std::uint64_t> aligned;
  aligned.resize(flatbuffer.size() / sizeof(std::uint64_t) + 1);
  std::memcpy(aligned.data(), flatbuffer.data(), flatbuffer.size());
  return decodeAligned(reinterpret_cast<const std::uint8_t*>(aligned.data()), flatbuffer.size(), message);
}

void FrameReader::append(std::span<const std::uint8_t> bytes) {
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

Expected<std::span<const std::uint8_t>> FrameReader::next() {
  const std::span<const std::uint8_t> rest = std::span<const std::uint8_t>(buffer_).subspan(begin_);
  if (rest.size() < kFrameHeaderBytes) return std::span<const std::uint8_t>();
  std::uint32_t length = 0;
  for (std::size_t i = kFrameHeaderBytes; i-- > 0;) length = (length << 8) | rest[i];
  if (length == 0 || length > kMaxFrameBytes) {
    return refuse(Text("frame length"), Text("%1 bytes", length), Text("1 to %1", kMaxFrameBytes));
  }
  if (rest.size() < kFrameHeaderBytes + length) return std::span<const std::uint8_t>();
  begin_ += kFrameHeaderBytes + length;
  return rest.subspan(kFrameHeaderBytes, length);
}

}  // namespace hapticell::haptic
