// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "config/device_profile.h"
#include "haptic/devices/device.h"
#include "haptic/devices/phantom_arm.h"
#include "haptic/devices/simulated_hand.h"

namespace hapticell::haptic {

/// A simulated Phantom: a physical model of the arm, its motors and encoders, and the hand on its stylus.
///
/// The model includes the linkage (PhantomArm) with its apparent mass at the tip, Coulomb friction with sticking,
/// viscous friction, weight, and hard stops at the edge of the workspace. It also includes encoders that count in whole
/// steps, motors driven by a converter of finite bits, the delay of a tick between write() and the force, motor
/// temperature, buttons. Motion is integrated in steps of 0.1 ms. Stepped by advance(): by a test in virtual time, by
/// the force loop in real time, once a tick: advance(0.001), read(), render, write().
///
/// One thread. advance(), read() and write() neither allocate nor throw.
class SimulatedDevice final : public Device {
 public:
  explicit SimulatedDevice(const config::DeviceProfile& profile = {});

  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  Expected<void> open() override;
  DeviceStatus read(DeviceReading& reading) noexcept override;
  /// Torque is ignored if three axes are driven. A value that is not finite stops the motors and is a fault.
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override;
  void close() noexcept override;
  SimulatedDevice* simulated() noexcept override { return this; }

  /// Simulates `dt` seconds (0 to 0.1; more counts as 0.1).
  void advance(double dt) noexcept;

  SimulatedHand& hand() { return hand_; }
  const config::DeviceProfile& profile() const { return profile_; }

  /// Sets the stylus's pose, at rest (for tests and at the start).
  void place(const Pose& X_DS) noexcept;

  /// The stylus's true pose, before the encoders' rounding.
  const Pose& truePose() const { return X_DS_; }
  const dvec3& trueVelocity() const { return v_DS_; }
  /// Force of the motors on the stylus now, N: delayed and quantised.
  const dvec3& motorForce() const { return motor_D_; }
  /// Torque of the gimbal's motors on it now, N m: delayed, limited and quantised like the force.
  const dvec3& motorTorque() const { return motor_torque_D_; }
  const dvec3& trueAngularVelocity() const { return w_DS_; }
  /// Force of the hand on the stylus now, N.
  const dvec3& handForce() const { return hand_D_; }

 private:
  void applyDelayedForce() noexcept;
  void updateMass() noexcept;
  void integrate(double h, double into_tick) noexcept;
  void integrateRotation(double h, const HandIntent& intent) noexcept;
  dvec3 stopForce() const noexcept;

  // Ticks of delay that a profile may have, and one (its range is 0 to 15). Half: profiles of 8 ms and more would be
  // cut.
  static constexpr std::size_t kMaxDelay = 16;

  config::DeviceProfile profile_;
  DeviceCapabilities capabilities_;
  PhantomArm arm_;
  dvec3 joint_inertia_{0.0};  ///< kg m^2.
  dvec3 lever_{0.0};          ///< Lever of each joint in the middle of the workspace, m.
  SimulatedHand hand_;
  bool open_ = false;
  Pose X_DS_;
  dvec3 v_DS_{0.0};
  dvec3 w_DS_{0.0};
  dmat3 mass_{1.0};
  dmat3 inverse_mass_{1.0};
  dvec3 motor_D_{0.0};
  dvec3 motor_torque_D_{0.0};
  dvec3 hand_D_{0.0};
  struct Command {
    dvec3 force_D{0.0}, torque_D{0.0};
  };
  std::array<Command, kMaxDelay> commands_{};
  double temperature_ = 0.0;
};

}  // namespace hapticell::haptic
