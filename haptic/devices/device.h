// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::haptic {

/// What a stylus can do. Device frame D: origin in the middle of the workspace, x to the user's right, y away from the
/// user, z up.
struct DeviceCapabilities {
  std::string name;
  dvec3 workspace_min{0.0};  ///< Box in D, metres.
  dvec3 workspace_max{0.0};
  double resolution = 0.0;  ///< Position step, metres.
  int measured_axes = 6;
  int driven_axes = 3;            ///< 3: force only; 6: force and torque.
  double peak_force = 0.0;        ///< N.
  double continuous_force = 0.0;  ///< N that the motors bear for ever.
  double peak_torque = 0.0;       ///< N m about any axis; 0 where driven_axes is 3.
  double stiffness = 0.0;         ///< N/m that is stable with nobody holding it.
  double damping = 0.0;           ///< N s/m that belongs to that stiffness.
  int buttons = 1;
  bool simulated = false;      ///< There is no such thing on the table.
  int delay_ticks = 0;         ///< Ticks from write() to the force, where that is known.
  double thermal_time = 30.0;  ///< Motors' time constant, s.
};

/// One measurement of the stylus.
struct DeviceReading {
  Pose X_DS;                       ///< Stylus tip in D.
  std::uint32_t buttons = 0;       ///< Bit i set while button i is pressed.
  double motor_temperature = 0.0;  ///< 0 cold .. 1 at the limit; 0 where the device does not tell.
  bool fresh = true;               ///< False: nothing was measured since the last reading; the pose is the old one.
  bool takes_force = true;         ///< False: what is commanded is not exerted (not calibrated, protecting itself).
};

enum class DeviceStatus : std::uint8_t { kOk, kNotOpen, kFault, kVanished };

class DeviceCare;
class SimulatedDevice;

/// What exerts forces and has not measured for so long, s, gets none: force and place belong together.
inline constexpr double kFreshFor = 0.020;

/// A force-feedback stylus (or a pointing device without force). Used by one thread at a time: the force loop's.
///
/// read() and write() are called once a tick and neither throw, allocate, lock nor log.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceCapabilities& capabilities() const = 0;
  virtual Expected<void> open() = 0;
  virtual DeviceStatus read(DeviceReading& reading) noexcept = 0;
  /// Commands a force (N, in D) and, where the device can, a torque (N m). Already through the safety chain.
  virtual DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept = 0;
  /// Switches the motors off at once, or on again; what a device without a switch does not do, its zero force does.
  virtual void setMotors(bool on) noexcept { static_cast<void>(on); }
  /// Forces may come from now on (the engage gate is no longer closed), or no longer: a device whose amplifiers are
  /// switched does so now, and has none powered before it was told.
  virtual void setEngaged(bool engaged) noexcept { static_cast<void>(engaged); }
  /// Force zero, motors off. Safe to call at any time, more than once.
  virtual void close() noexcept = 0;
  /// The simulated device that this is or holds, which has to be advanced and can be held by a hand; null for others.
  virtual SimulatedDevice* simulated() noexcept { return nullptr; }
  /// Where its condition is told and its calibration asked for; null for devices that want nothing of their user. Lives
  /// as long as the device.
  virtual DeviceCare* care() noexcept { return nullptr; }
};

}  // namespace hapticell::haptic
