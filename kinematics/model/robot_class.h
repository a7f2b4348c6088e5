// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// The class of inverse model for a chain, determined from its joint axes, never from its name.
enum class RobotClass {
  kOpw,             ///< Spherical wrist, axes 2 and 3 parallel, both square to axis 1 (Brandstoetter et al. 2014).
  kUr,              ///< Axes 2, 3 and 4 parallel, each other pair of neighbours square.
  kSphericalWrist,  ///< Any other six axes of which the last three meet in a point (Pieper 1968).
  kSphericalBase,   ///< The same seen from the tool: the first three meet.
  kOffsetWrist,     ///< As kOpw, but axis 6 passes the wrist at a distance: no closed form, up to 16 solutions.
  kSrs,             ///< Seven axes, shoulder and wrist spherical; redundancy: the swivel of the elbow.
  kPanda,           ///< Seven axes, shoulder spherical, elbow and flange offset; redundancy: joint 7.
  kScara,           ///< Three turning joints and a slide, all parallel, in any order.
  kNumeric,         ///< None of them.
};

/// "opw", "ur", "spherical_wrist", "spherical_base", "offset_wrist", "srs", "panda", "scara" or "numeric".
const char* toString(RobotClass robot_class);

/// How far axes may be off "parallel", "square" and "meeting" and still count as such.
struct ClassTolerance {
  double exact = 1e-6;         ///< rad, and metres: the closed form is then exact as far as doubles go.
  double near_angle = 0.02;    ///< rad: up to here the closed form gives starts that are polished on the true axes.
  double near_length = 0.003;  ///< The same for lengths, in parts of the arm's reach.
};

/// What classify() recognised.
struct Classification {
  RobotClass robot_class = RobotClass::kNumeric;
  std::size_t rails = 0;    ///< Sliding joints in front of the arm that the class is about.
  bool calibrated = false;  ///< Only near the class (ClassTolerance::near): solutions are polished on the true axes.
};

/// Classifies the chain by its axes at zero. A chain with mimic joints, or with a joint behind the class's last one, is
/// kNumeric, as is an arm of six joints that leaves a direction unreachable everywhere (armIsDeficient()).
Classification classify(const Chain& chain, const ClassTolerance& tolerance = {});

/// The class, with leading slides and exactness: "opw", "rail+opw", "gantry+ur", "opw (calibrated)".
std::string describe(const Classification& classification);

}  // namespace hapticell::kinematics
