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
  double continuous_force = 0.0;  ///< N that the motors can exert permanently.
  double peak_torque = 0.0;       ///< N m about any axis; 0 if driven_axes is 3.
  double stiffness = 0.0;         ///< N/m that is stable when nobody holds the stylus.
  double damping = 0.0;           ///< N s/m that belongs to that stiffness.
  int buttons = 1;
  bool simulated = false;      ///< True if there is no hardware.
  int delay_ticks = 0;         ///< Ticks from write() to the force, if known.
  double thermal_time = 30.0;  ///< Motors' time constant, s.
};

/// One measurement of the stylus.
struct DeviceReading {
  Pose X_DS;                       ///< Stylus tip in D.
  std::uint32_t buttons = 0;       ///< Bit i set while button i is pressed.
  double motor_temperature = 0.0;  ///< 0 cold .. 1 at the limit; 0 if the device does not report it.
  bool fresh = true;               ///< False: no new measurement since the last reading; the pose is the old one.
  bool takes_force = true;         ///< False: the device does not exert commanded forces (not calibrated, protecting
                                   ///< itself).
};

enum class DeviceStatus : std::uint8_t { kOk, kNotOpen, kFault, kVanished };

class DeviceCare;
class SimulatedDevice;

/// s without a measurement after which a device that exerts forces gets none: 20 samples at 1000 Hz, so only a failure
/// lasts so long. Half: a busy machine trips; twice: a force acts 40 ms on an old pose.
inline constexpr double kFreshFor = 0.020;

/// A force-feedback stylus (or a pointing device without force). Used by one thread at a time: the force loop's.
///
/// read() and write() are called once a tick; they do not throw, allocate, lock or log.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceCapabilities& capabilities() const = 0;
  virtual Expected<void> open() = 0;
  virtual DeviceStatus read(DeviceReading& reading) noexcept = 0;
  /// Commands a force (N, in D) and, if the device supports it, a torque (N m). The values have passed the safety
  /// chain.
  virtual DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept = 0;
  /// Switches the motors off at once, or on again. For a device without a switch, zero force has the same effect.
  virtual void setMotors(bool on) noexcept { static_cast<void>(on); }
  /// Announces that forces may follow (the engage gate is no longer closed), or that they end. A device with switched
  /// amplifiers switches them here and keeps them off until the first call.
  virtual void setEngaged(bool engaged) noexcept { static_cast<void>(engaged); }
  /// Force zero, motors off. Safe to call at any time, more than once.
  virtual void close() noexcept = 0;
  /// The simulated device that this is or contains, which has to be advanced and can be held by a simulated hand; null
  /// for others.
  virtual SimulatedDevice* simulated() noexcept { return nullptr; }
  /// Reports the device's condition and takes its calibration steps; null for devices that need nothing from the user.
  /// Lives as long as the device.
  virtual DeviceCare* care() noexcept { return nullptr; }
};

}  // namespace hapticell::haptic
