// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// The limits of one device and the times of the stages. Invalid values are replaced by these defaults.
struct SafetyOptions {
  double peak_force = 6.4;         ///< N.
  double continuous_force = 1.4;   ///< N that the motors can exert permanently.
  double peak_torque = 0.0;        ///< N m; 0: the device does not drive rotation. Derated like the force, by the same
                                   ///< share.
  double slew = 1000.0;            ///< N/s: 1 N per millisecond; for a torque, times kRotationLever.
  double thermal_time = 30.0;      ///< Time constant of the motors, s.
  double gate_force = 0.2;         ///< The gate opens only below this wanted force (torque: times the lever), N,
  int gate_ticks = 3;              ///< and only after it has been below for more than this many ticks.
  double ramp_time = 0.8;          ///< From closed to open, s.
  double ramp_damping = 2.0;       ///< N s/m at the ramp's beginning, falling to 0.
  double silence_limit = 0.6;      ///< Silent link: force held for this time, s,
  double silence_decay = 0.18;     ///< then to zero in this time, s.
  double set_silence_limit = 2.0;  ///< Client that sends no constraint set: force held for this time, s,
  double set_silence_decay = 0.5;  ///< then to zero in this time, s.
  double close_decay = 0.04;       ///< Socket closed, or forces switched off: to zero in this time, s.
  double speed_limit = 4.0;        ///< m/s: a faster stylus is not in anybody's hand, or its encoders are wrong;
  int speed_ticks = 5;             ///< trips after this many consecutive ticks.
};

/// Input of the chain in each tick.
struct SafetyInput {
  dvec3 force_D{0.0};                 ///< Wanted force, N; any value, also NaN.
  dvec3 torque_D{0.0};                ///< Wanted torque, N m; likewise.
  dvec3 v_DS{0.0};                    ///< Stylus velocity for the ramp's damping, m/s.
  double dt = 0.001;                  ///< Since the last tick, s.
  bool enabled = false;               ///< The explicit enable of the controlling client (Esc clears it).
  bool link_open = true;              ///< A controlling client is connected.
  bool device_ready = true;           ///< The device exerts commands (calibrated, powered, measuring).
  double link_silence = 0.0;          ///< Seconds since its last message.
  double silence_limit = 0.0;         ///< Silence limit of this client, s, if it is less than the option because its
                                      ///< heart-beats are faster; the force then falls as when a link closes.
  double set_silence = 0.0;           ///< Seconds since its last accepted constraint set.
  double reported_temperature = 0.0;  ///< Of the device, 0 .. 1 at the limit; 0 if it does not report it.
};

enum class GateState : std::uint8_t {
  kClosed,   ///< Not enabled, the device not ready, or closed by trip() or a lost link and not enabled again since.
  kWaiting,  ///< Enabled; waits for a small wanted force.
  kRamping,
  kOpen,
  kClosing,  ///< Decays to zero.
};

struct SafetyResult {
  dvec3 force_D{0.0};   ///< To the device.
  dvec3 torque_D{0.0};  ///< To the device.
  GateState gate = GateState::kClosed;
  double ramp = 0.0;          ///< 0 closed .. 1 open: the allowed share of the peak force.
  double fade = 1.0;          ///< 1 while the link lives .. 0.
  double temperature = 0.0;   ///< Motor model, 0 cold .. 1 at the limit.
  double force_limit = 0.0;   ///< N that the motors may exert now: the peak force, less towards the continuous force
                              ///< when they are warm, and less during the ramp. If no force is let through, the limit
                              ///< that will apply when it is again.
  bool input_fault = false;   ///< This tick's wanted force was not a plausible number; it counted as zero.
  bool slew_limited = false;  ///< The wanted force moved faster than the slew limit.
  bool derated = false;       ///< Thermal derating limits the force.
  bool too_fast = false;      ///< The stylus has been beyond the speed limit: tripped.
};

/// Limits every wanted force before it reaches the motors. In this order: finite check, limit of the stylus's speed,
/// slew limit, magnitude clamp, thermal derating, engage gate with the fades of a lost link.
///
/// Two promises hold for any input: |force| <= peak_force, and two successive forces differ by at most slew * min(dt, 1
/// ms). The same holds for the torque, with its own ball. Reason: each stage only shrinks towards zero inside the ball
/// of the peak force, and the last step of tick() moves from the last force towards the result by no more than the
/// slew; the ball is convex, so that step does not leave it. The slew never delays a fade to zero: it brings the peak
/// force to zero in under 10 ms, and each decay here is longer. Owned by the force loop's thread; nothing here
/// allocates, locks or throws.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetyOptions& options = {});

  SafetyResult tick(const SafetyInput& input) noexcept;

  /// Closes the gate after a fault (missed ticks, a failed device); it opens again only after `enabled` has been false
  /// and then true. The force falls to zero within close_decay.
  void trip() noexcept;

  /// The force was removed at once outside the chain (motors off, a failed device); the next force starts from zero,
  /// through the gate.
  void cut() noexcept;

  /// Back to the initial state: no force, gate closed; the motors' temperature is kept.
  void reset() noexcept;

  const SafetyOptions& options() const { return options_; }

 private:
  /// State and limits of either the force or the torque.
  struct Channel {
    dvec3 last{0.0}, slewed{0.0};
    double peak = 0.0;
    double slew = 0.0;  ///< Per second.
  };
  void slewTowards(Channel& channel, const dvec3& wanted, double dt, SafetyResult& result) noexcept;
  void finish(Channel& channel, const dvec3& wanted, double dt) noexcept;
  void stepGate(const SafetyInput& input, bool small_force, double dt) noexcept;
  void stepFade(const SafetyInput& input, double dt) noexcept;
  void stepTemperature(double reported, double dt) noexcept;
  bool isTooFast(const dvec3& v_DS) noexcept;
  /// Share of the peak that warm motors can exert now.
  double thermalShare() const noexcept;

  SafetyOptions options_;
  Channel force_, torque_;
  GateState gate_ = GateState::kClosed;
  int small_ticks_ = 0;
  int fast_ticks_ = 0;  ///< Consecutive.
  double ramp_ = 0.0;
  double fade_ = 1.0;
  double temperature_ = 0.0;
  std::array<double, 2> reported_{};  ///< Temperature reported by the device in the two ticks before.
  bool needs_new_enable_ = false;
};

}  // namespace hapticell::haptic
