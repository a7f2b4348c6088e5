// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// The class of inverse model for a chain, determined from its joint axes, never from its name.
enum class RobotClass {
  kOpw,  ///< Spherical wrist, axes 2 and 3 parallel, both perpendicular to axis 1 (Brandstoetter et al. 2014).
  kUr,   ///< Axes 2, 3 and 4 parallel, every other pair of neighbours perpendicular.
  kSphericalWrist,  ///< Any other six axes of which the last three intersect in a point (Pieper 1968).
  kSphericalBase,   ///< The same from the tool: the first three intersect.
  kOffsetWrist,     ///< As kOpw, but axis 6 passes the wrist at a distance: no closed form, up to 16 solutions.
  kSrs,             ///< Seven axes, shoulder and wrist spherical; redundancy: the swivel of the elbow.
  kPanda,           ///< Seven axes, shoulder spherical, elbow and flange offset; redundancy: joint 7.
  kScara,           ///< Three turning joints and a slide, all parallel, in any order.
  kNumeric,         ///< None of them.
};

/// "opw", "ur", "spherical_wrist", "spherical_base", "offset_wrist", "srs", "panda", "scara" or "numeric".
const char* toString(RobotClass robot_class);

/// The tolerances within which axes count as parallel, perpendicular and intersecting.
struct ClassTolerance {
  double exact = 1e-6;         ///< rad, and metres: the closed form is then exact to the precision of doubles.
  double near_angle = 0.02;    ///< rad: within this, the closed form gives starts that are refined on the true axes.
  double near_length = 0.003;  ///< The same for lengths, as a share of the arm's reach.
};

/// The result of classify().
struct Classification {
  RobotClass robot_class = RobotClass::kNumeric;
  std::size_t rails = 0;    ///< Slides before the arm that was classified.
  bool calibrated = false;  ///< Only near the class (ClassTolerance::near): solutions are refined on the true axes.
};

/// Classifies the chain by its axes at zero. A chain with mimic joints, or with a joint after the last one of the
/// class, is kNumeric, as is an arm of six joints that cannot move in some direction anywhere (armIsDeficient()).
Classification classify(const Chain& chain, const ClassTolerance& tolerance = {});

/// The class, with leading slides and exactness: "opw", "rail+opw", "gantry+ur", "opw (calibrated)".
std::string describe(const Classification& classification);

}  // namespace hapticell::kinematics
