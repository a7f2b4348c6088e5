// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::kinematics {

/// Name, limits and speed of one joint, rad and m.
struct JointData {
  std::string name;
  double lower = 0.0, upper = 0.0, velocity = 0.0;
};

/// Six-axis arm with an ortho-parallel base and a spherical wrist (Brandstoetter, Angerer and Hofbaur, "An analytical
/// solution of the inverse kinematics problem of industrial serial manipulators with an ortho-parallel basis and a
/// spherical wrist", 2014). theta = sign * q - offset; at theta = 0 the arm stands straight up.
struct OpwParameters {
  double a1 = 0.0, a2 = 0.0, b = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0;  ///< m
  std::array<double, 6> offsets{};                                             ///< rad
  std::array<double, 6> signs{1, 1, 1, 1, 1, 1};                               ///< +1 or -1
};

/// Links base_link, link_1 .. link_6, tool0 (the flange, z outward). Each link's frame has its z axis along the arm
/// (upwards for link_1, along upper arm, forearm and flange) and its y axis along axes 2, 3 and 5. Needs six joints.
RobotModel buildOpw(const std::string& name, const OpwParameters& parameters, const std::vector<JointData>& joints);

/// One row of a Denavit-Hartenberg table: theta and alpha in rad, d and a in m. What moves adds to theta (revolute) or
/// d.
struct DhRow {
  double theta = 0.0, d = 0.0, a = 0.0, alpha = 0.0;
  bool prismatic = false;
};

enum class DhConvention {
  kStandard,  ///< Rz(theta) Tz(d) Tx(a) Rx(alpha), Denavit and Hartenberg 1955.
  kModified,  ///< Rx(alpha) Tx(a) Rz(theta) Tz(d) with the row's own alpha and a, Craig 1986.
};

/// Links base_link, link_1 .. link_n, tool0 after `flange` (pose of tool0 in the frame of the last row). The number of
/// joints must equal the number of rows.
RobotModel buildDh(const std::string& name, DhConvention convention, const std::vector<DhRow>& rows,
                   const std::vector<JointData>& joints, const Pose& flange);

/// One joint of a chain given by frames: the pose of the joint in the frame before at position 0, and its axis in that
/// frame.
struct ChainJoint {
  JointData data;
  Pose X_PJ;
  dvec3 axis_J{0.0, 0.0, 1.0};
  JointType type = JointType::kRevolute;
};
RobotModel buildChain(const std::string& name, const std::vector<ChainJoint>& joints, const Pose& flange);

}  // namespace hapticell::kinematics
