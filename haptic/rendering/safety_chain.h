// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/shapes/vector.h"

namespace hapticell::haptic {

/// The limits of one device and the times of the stages. Values that make no sense are replaced by these defaults.
struct SafetyOptions {
  double peak_force = 6.4;         ///< N.
  double continuous_force = 1.4;   ///< N the motors bear for ever.
  double peak_torque = 0.0;        ///< N m; 0: no turning is driven. Derated like the force, by the same share.
  double slew = 1000.0;            ///< N/s: 1 N in a millisecond; of a torque times kRotationLever.
  double thermal_time = 30.0;      ///< Time constant of the motors, s.
  double gate_force = 0.2;         ///< The gate opens only below this wanted force (torque: times the lever), N,
  int gate_ticks = 3;              ///< and only after more than so many ticks of it.
  double ramp_time = 0.8;          ///< From closed to open, s.
  double ramp_damping = 2.0;       ///< N s/m at the ramp's beginning, falling to 0.
  double silence_limit = 0.6;      ///< Silent link: held so long, s,
  double silence_decay = 0.18;     ///< then to zero in this time, s.
  double set_silence_limit = 2.0;  ///< A client that lives but says nothing of contacts: held so long, s,
  double set_silence_decay = 0.5;  ///< then to zero in this time, s.
  double close_decay = 0.04;       ///< Socket closed, or forces switched off: to zero in this time, s.
  double speed_limit = 4.0;        ///< m/s: a stylus that is faster is in nobody's hand, or its encoders lie,
  int speed_ticks = 5;             ///< for so many ticks on end.
};

/// What the chain hears each tick.
struct SafetyInput {
  dvec3 force_D{0.0};                 ///< Wanted force, N; anything at all, not-a-number included.
  dvec3 torque_D{0.0};                ///< Wanted torque, N m; likewise.
  dvec3 v_DS{0.0};                    ///< Stylus velocity for the ramp's damping, m/s.
  double dt = 0.001;                  ///< Since the last tick, s.
  bool enabled = false;               ///< The explicit enable of the controlling client (Esc clears it).
  bool link_open = true;              ///< A controlling client is connected.
  bool device_ready = true;           ///< The device exerts what it is told (calibrated, powered, measuring).
  double link_silence = 0.0;          ///< Seconds since its last word.
  double silence_limit = 0.0;         ///< How long this client may be silent, s, where that is less than the option
                                      ///< (its heart-beats are quicker); the force then falls as when a link closes.
  double set_silence = 0.0;           ///< Seconds since its last constraint set that was taken.
  double reported_temperature = 0.0;  ///< Of the device, 0 .. 1 at the limit; 0 where it does not tell.
};

enum class GateState : std::uint8_t {
  kClosed,   ///< Not enabled, the device not ready, or shut by trip() or a lost link and not enabled anew since.
  kWaiting,  ///< Enabled; waits for a small wanted force.
  kRamping,
  kOpen,
  kClosing,  ///< Decays to zero.
};

struct SafetyResult {
  dvec3 force_D{0.0};   ///< To the device.
  dvec3 torque_D{0.0};  ///< To the device.
  GateState gate = GateState::kClosed;
  double ramp = 0.0;          ///< 0 closed .. 1 open: the share of the peak force that may be had.
  double fade = 1.0;          ///< 1 while the link lives .. 0.
  double temperature = 0.0;   ///< Motor model, 0 cold .. 1 at the limit.
  double force_limit = 0.0;   ///< N that the motors may do now: the peak force, towards the continuous one when warm,
                              ///< less while the ramp rises; what it will be anew while no force is let through.
  bool input_fault = false;   ///< This tick's wanted force was not a plausible number; it counted as zero.
  bool slew_limited = false;  ///< The wanted force moved faster than the slew limit.
  bool derated = false;       ///< Thermal derating bites.
  bool too_fast = false;      ///< The stylus has been beyond the speed limit: tripped.
};

/// Stands between every wanted force and the motors. In this order: finite check, limit of the stylus's speed, slew
/// limit, magnitude clamp, thermal derating, engage gate with the fades of a lost link.
///
/// Two promises hold for any input whatever: |force| <= peak_force, and two successive forces differ by at most
/// slew * min(dt, 1 ms); likewise the torque, which goes the same way through a ball of its own. Both, because each
/// stage only shrinks towards zero inside the ball of the peak force, and the last act of tick() walks from the last
/// force towards the result by no more than the slew: the ball is convex, so the walk does not leave it. A fade to zero
/// is never stopped by the slew: the peak force is down in under 10 ms, and each decay here is longer. Owned by the
/// force loop's thread; nothing here allocates, locks or throws.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetyOptions& options = {});

  SafetyResult tick(const SafetyInput& input) noexcept;

  /// Shuts the gate because of a fault (missed ticks, a device that failed); it opens again only after `enabled` has
  /// been false and true again. The force still falls within close_decay.
  void trip() noexcept;

  /// The force has been taken away at once, by something that knows better (motors off, a device that fails): whatever
  /// comes next begins from nothing, through the gate.
  void cut() noexcept;

  /// As made: no force, gate closed, motors as warm as they were.
  void reset() noexcept;

  const SafetyOptions& options() const { return options_; }

 private:
  /// What one of the two, force or torque, was and may be.
  struct Channel {
    dvec3 last{0.0}, slewed{0.0};
    double peak = 0.0;
    double slew = 0.0;  ///< A second.
  };
  void slewTowards(Channel& channel, const dvec3& wanted, double dt, SafetyResult& result) noexcept;
  void finish(Channel& channel, const dvec3& wanted, double dt) noexcept;
  void stepGate(const SafetyInput& input, bool small_force, double dt) noexcept;
  void stepFade(const SafetyInput& input, double dt) noexcept;
  void stepTemperature(double reported, double dt) noexcept;
  bool isTooFast(const dvec3& v_DS) noexcept;
  /// Part of the peak that warm motors bear now.
  double thermalShare() const noexcept;

  SafetyOptions options_;
  Channel force_, torque_;
  GateState gate_ = GateState::kClosed;
  int small_ticks_ = 0;
  int fast_ticks_ = 0;  ///< On end.
  double ramp_ = 0.0;
  double fade_ = 1.0;
  double temperature_ = 0.0;
  std::array<double, 2> reported_{};  ///< What the device said of it in the two ticks before.
  bool needs_new_enable_ = false;
};

}  // namespace hapticell::haptic
