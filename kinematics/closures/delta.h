// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/shapes/pose.h"
#include "kinematics/kernels/loop_kernels.h"

namespace hapticell::kinematics {

/// A Delta with three turning upper arms (Clavel 1988), metres. The base frame B lies in the plane of the motor axes, z
/// up; arm k is at angle 120 deg * k + `first_angle` about z. At theta = 0 an upper arm is horizontal and points
/// outward; a positive theta lowers it (the platform hangs below; `upward` inverts the robot).
struct DeltaGeometry {
  double base_radius = 0.0;      ///< From the middle to the motor axes.
  double upper_arm = 0.0;        ///< Motor axis to knee.
  double lower_arm = 0.0;        ///< Knee to platform joint.
  double platform_radius = 0.0;  ///< From the platform's middle to its joints.
  double rod_spacing = 0.0;      ///< Between the two rods of an arm; only for display and the tilt of the rods.
  double first_angle = 0.0;      ///< rad
  bool upward = false;           ///< The platform stands above the base.
};

/// The joint angles of all eight branches: bit k of the branch is set if the knee of arm k points inward. NaN if that
/// arm does not reach.
using DeltaBranches = std::array<std::array<double, 3>, 8>;

/// The closed forms of a Delta, both ways. No allocation.
class DeltaKinematics {
 public:
  explicit DeltaKinematics(const DeltaGeometry& geometry);
  const DeltaGeometry& geometry() const { return geometry_; }

  /// Both knee angles of each arm for the platform's centre at p_BP: outer[k], inner[k]; NaN if out of reach. False if
  /// some arm does not reach.
  bool inverse(const dvec3& p_BP, std::array<double, 3>& outer, std::array<double, 3>& inner) const;
  /// All eight combinations of them.
  bool inverseAll(const dvec3& p_BP, DeltaBranches& branches) const;
  /// The platform's centre for three motor angles: the intersection of three spheres about the (shifted) knees, on the
  /// side below the knees. False if they do not intersect; p_BP is then the point closest to an intersection.
  bool forward(const std::array<double, 3>& theta, dvec3& p_BP) const;

  /// Knee k in B.
  dvec3 knee(int k, double theta) const;
  /// Platform joint k in B.
  dvec3 platformJoint(int k, const dvec3& p_BP) const;
  /// Unit vector of arm k, outward and level.
  dvec3 outward(int k) const { return {cosine_[static_cast<std::size_t>(k)], sine_[static_cast<std::size_t>(k)], 0.0}; }

 private:
  DeltaGeometry geometry_;
  std::array<double, 3> cosine_{}, sine_{};
  double down_ = -1.0;  ///< Sign of z on the side of the platform.
  kernels::DeltaArms arms_{};
  const kernels::LoopTable* kernels_ = &kernels::loopTable();
};

}  // namespace hapticell::kinematics
