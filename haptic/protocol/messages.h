// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "geometry/shapes/pose.h"
#include "haptic/protocol/device_condition.h"
#include "haptic/rendering/constraint_set.h"
#include "haptic/rendering/held_load.h"

namespace hapticell::haptic {

/// Version of the protocol; client and server must use the same version. Increased when a message changes its meaning.
inline constexpr std::uint32_t kProtocolVersion = 1;

/// The server's newest state, sent every force-loop tick or less often; the newest wins.
struct HapticState {
  std::uint64_t tick = 0;            ///< Number of due ticks, including skipped ones.
  std::int64_t server_stamp_ns = 0;  ///< Server's steady clock at the tick.
  Pose X_DS;                         ///< Measured stylus.
  Pose X_DP;                      ///< The proxy: the pose of the stylus if it obeyed every constraint; the wanted pose.
  dvec3 v_DS{0.0};                ///< Filtered velocity, m/s.
  dvec3 force_D{0.0};             ///< Commanded force on the hand, N.
  dvec3 torque_D{0.0};            ///< Commanded torque on the hand, N m; zero if the device does not drive rotation.
  std::uint32_t buttons = 0;      ///< Bit i set while button i is pressed.
  std::uint64_t adopted_set = 0;  ///< Sequence of the rendered set; 0 before the first.
  bool forces_on = false;         ///< The engage gate is open.
  double force_ramp = 0.0;        ///< 0 .. 1 while it opens.
  double motor_temperature = 0.0;  ///< 0 cold .. 1 at the limit.
  bool device_fault = false;       ///< The device cannot be read or commanded; the force is zero.
  bool client_stalled = false;     ///< The controlling client has sent no usable set for 2 s: the force fades.
};

/// A set that is older than this at its adoption counts as late, s: the period of the slowest supported client (10 Hz).
/// It is only counted. Half: each set of such a client is late; twice: a missing one is not seen.
inline constexpr double kLateSetAge = 0.1;

/// The server's figures, about ten times a second.
struct ServerStatistics {
  double rate_hz = 0.0;                                            ///< Ticks per second over the last second or so.
  double late_p50_ms = 0.0, late_p99_ms = 0.0, late_max_ms = 0.0;  ///< Wake-up past the deadline, last 5 to 10 s.
  std::uint64_t ticks = 0, missed_ticks = 0;                       ///< Since the start.
  double round_trip_ms = 0.0;                         ///< Newest round trip of the controlling client's heart-beat.
  double set_age_p50_ms = 0.0, set_age_p99_ms = 0.0;  ///< From the client's query to the adoption, last 5 to 10 s.
  std::uint64_t late_sets = 0;     ///< Adopted when older than kLateSetAge, since the server's start.
  std::uint64_t refused_sets = 0;  ///< Not adopted (outdated, malformed, or around another place); the older one stayed
                                   ///< in use.
  std::uint64_t dropped_sets = 0;  ///< Adopted and then dropped: their numbers gave no valid proxy or force.
  /// Offset from the controlling client's clock to the server's, from the heart-beats; empty before the first.
  std::optional<double> clock_offset_ms;
};

/// What the client requests from the server, apart from sets.
struct HapticControl {
  bool forces_enabled = false;  ///< Opens or closes the engage gate.
  double stiffness = 0.0;       ///< N/m; 0: the device's own.
  double damping = 0.0;         ///< N s/m; 0: the device's own.
  LoadOptions load{};           ///< What the hand carries.
};

/// The simulated hand's intended pose of the stylus; real devices ignore it.
struct HandTarget {
  bool holding = false;  ///< False: nobody holds the stylus.
  Pose X_DH{};
  std::uint32_t buttons = 0;
};

/// Capabilities of the connected device, sent by the server at connection.
struct DeviceDescription {
  std::string name;
  bool simulated = false;
  dvec3 workspace_min{0.0}, workspace_max{0.0};
  double resolution = 0.0, peak_force = 0.0, continuous_force = 0.0, stiffness = 0.0, damping = 0.0;
  int measured_axes = 6, driven_axes = 3, buttons = 1;
  double peak_torque = 0.0;  ///< N m.
};

enum class ClientKind : std::uint8_t {
  kController,  ///< Sends constraint sets; the server accepts one controller at a time.
  kWatcher,     ///< Only receives; any number of them.
};

/// First message of a client; must come within two seconds of the connection.
struct Hello {
  std::uint32_t protocol_version = kProtocolVersion;
  ClientKind kind = ClientKind::kController;
  bool accept_watching = false;  ///< If there already is a controller: watch instead of being refused.
  std::string program{};         ///< The program's name, for messages to the user.
  bool wants_condition = false;  ///< Requests the device's condition.
  bool take_over = false;        ///< At the user's request, this controller replaces the current one.
};

/// The server's answer to a Hello that it accepts.
struct Welcome {
  std::uint32_t protocol_version = kProtocolVersion;
  ClientKind kind = ClientKind::kController;  ///< The role granted to the client.
  double tick_rate_hz = 1000.0;
  DeviceDescription device{};
};

/// Why a server does not serve a client.
enum class RefusalReason : std::uint8_t {
  kOther,          ///< Only the sentence says why.
  kControlled,     ///< Another program controls the stylus.
  kTakenOver,      ///< Another program took the stylus.
  kSilent,         ///< Another program took the stylus after a long silence.
  kFull,           ///< There are as many connections as the server takes.
  kFullOfMachine,  ///< As kFull, from the client's machine.
};

/// The server's last message to a client that it refuses; then the connection closes.
struct Refusal {
  std::string sentence{};  ///< English, for every reason; problemOf() has it in parts.
  RefusalReason reason = RefusalReason::kOther;
  std::string subject{};  ///< The other program, or the number of connections.
};

/// Sent by the client every kHeartbeatPeriod (kQuickHeartbeatPeriod) from its network thread and answered at once by
/// the server. Each side repeats the stamp that it received last, so each can compute the round trip: now - echo_ns -
/// held_ns.
struct Heartbeat {
  std::int64_t sent_ns = 0;  ///< Sender's steady clock.
  std::int64_t echo_ns = 0;  ///< `sent_ns` of the peer's last heart-beat; 0 before the first.
  std::int64_t held_ns = 0;  ///< Time between receiving that one and sending this one.
};

/// The user has done step `step` of DeviceCondition::calibration. Sent by any client that requested the condition.
struct Calibrate {
  std::uint32_t step = 0;
};

/// Any message of the protocol.
using Message = std::variant<std::monostate, Hello, Welcome, Refusal, ConstraintSet, HapticState, ServerStatistics,
                             HapticControl, HandTarget, Heartbeat, DeviceCondition, Calibrate>;

/// s between a client's heart-beats, and between those of a controller while forces are on, by which its death is
/// noticed within 50 ms. Half: twice the messages; twice: 2 x 20 ms of silence and the decay are more than 50 ms.
inline constexpr double kHeartbeatPeriod = 0.1, kQuickHeartbeatPeriod = 0.01;

/// True if every number is finite and every value within its range and bound. The decoder requires this of a message.
bool isWellFormed(const HapticControl& control);
bool isWellFormed(const HandTarget& target);
bool isWellFormed(const HapticState& state);
bool isWellFormed(const ServerStatistics& statistics);
bool isWellFormed(const DeviceDescription& device);

}  // namespace hapticell::haptic
