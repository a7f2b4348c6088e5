// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "haptic/devices/drivers/omni_firewire/omni_packets.h"
#include "haptic/devices/phantom_arm.h"

namespace hapticell::driver {

/// A Phantom Omni's joints and tip from its raw readings. Angles need a home: the encoders' counts while the stylus is
/// in its inkwell, where the joints are (0, 0.23, -0.60) rad.
class OmniArm {
 public:
  /// Stores these counts as the counts in the inkwell.
  void home(const std::array<int, 3>& encoders);
  bool isHomed() const { return homed_; }

  /// Waist, shoulder, elbow (from the vertical), rad.
  dvec3 joints(const std::array<int, 3>& encoders) const;
  Pose X_DS(const OmniReading& reading) const;
  /// Joint torques (N m) that exert a force (N, D) at these joints: J^T F.
  dvec3 torques(const dvec3& joints, const dvec3& force_D) const;
  const haptic::PhantomArm& arm() const { return arm_; }

 private:
  haptic::PhantomArm arm_{0.135, 0.135};
  dvec3 home_{0.0};
  bool homed_ = false;
};

/// Joint commands, -1 .. 1, for torques. If one saturates, all are scaled together, so the direction stays.
dvec3 omniCommands(const dvec3& torques, double newton_metres_per_unit);

}  // namespace hapticell::driver
