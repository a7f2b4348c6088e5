// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/pose.h"
#include "haptic/rendering/constraint_set.h"

namespace hapticell::haptic {

/// The server's newest word, one force-loop tick (or less often, newest wins).
struct HapticState {
  std::uint64_t tick = 0;
  std::int64_t server_stamp_ns = 0;
  Pose X_DS;                        ///< Measured stylus.
  Pose X_DP;                        ///< The proxy: where the stylus would be if it obeyed every constraint. The wanted pose.
  dvec3 v_DS{0.0};                  ///< Filtered velocity, m/s.
  dvec3 force_D{0.0};               ///< Commanded force on the hand, N.
  std::uint32_t buttons = 0;
  std::uint64_t adopted_set = 0;    ///< Sequence of the set that is rendered.
  bool forces_on = false;           ///< The engage gate is open.
  double force_ramp = 0.0;          ///< 0 .. 1 while it opens.
  double motor_temperature = 0.0;
};

/// The server's figures, about ten times a second.
struct ServerStatistics {
  double rate_hz = 0.0;
  double late_p50_ms = 0.0, late_p99_ms = 0.0, late_max_ms = 0.0;
  std::uint64_t ticks = 0, missed_ticks = 0;
  double round_trip_ms = 0.0;
  double set_age_p50_ms = 0.0, set_age_p99_ms = 0.0;
};

/// What the client asks of the server besides sets.
struct HapticControl {
  bool forces_enabled = false;      ///< Opens or closes the engage gate.
  double stiffness = 0.0;           ///< N/m; 0: the device's own.
  double damping = 0.0;
};

/// Where the simulated hand wants the stylus to be; only a simulated device heeds it.
struct HandTarget {
  bool holding = false;             ///< False: nobody holds the stylus.
  Pose X_DH;
  std::uint32_t buttons = 0;
};

/// What the connected device can do, as the server told at connection.
struct DeviceDescription {
  std::string name;
  bool simulated = false;
  dvec3 workspace_min{0.0}, workspace_max{0.0};
  double resolution = 0.0, peak_force = 0.0, continuous_force = 0.0, stiffness = 0.0, damping = 0.0;
  int measured_axes = 6, driven_axes = 3, buttons = 1;
};

enum class LinkState { kDisconnected, kConnecting, kConnected, kRefused };

/// The client's end of the connection to a haptic server. No call ever waits; called by the manipulation thread only
/// (linkState() and problem() by any thread). Implementations: over TCP, and in memory under virtual time.
class HapticLink {
 public:
  virtual ~HapticLink() = default;
  virtual LinkState linkState() const = 0;
  virtual std::string problem() const = 0;                            ///< A sentence while not connected.
  virtual std::optional<DeviceDescription> device() const = 0;        ///< Once connected.
  virtual std::optional<HapticState> latestState() = 0;               ///< Newest since the last call, if any.
  virtual std::optional<ServerStatistics> latestStatistics() = 0;
  virtual void sendSet(const ConstraintSet& set) = 0;                 ///< Newest wins; older unsent ones are dropped.
  virtual void sendControl(const HapticControl& control) = 0;
  virtual void sendHandTarget(const HandTarget& target) = 0;
};

}  // namespace hapticell::haptic
