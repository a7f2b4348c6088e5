// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/text.h"
#include "mannequin/body/figure.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// The posture of a figure: the pose of its root (mid-hip, pelvis frame R) and its 56 joint angles. A value.
struct Posture {
  Pose X_WR;
  JointAngles angles{};
  Gaze gaze;

  double operator[](Dof dof) const { return angles[indexOf(dof)]; }
  double& operator[](Dof dof) { return angles[indexOf(dof)]; }
};

/// Exchanges left and right: joint angles swap sides, turns and side bends change sign, the root keeps its place and
/// heading and leans to the other side.
Posture mirror(const Posture& posture);

/// The arms' angles exchanged (girdle, arm, hand, fingers), the rest kept.
Posture swapHands(const Posture& posture);

/// Moves the root up or down so that the lowest of soles, knees and seat touches the floor at z = 0.
Posture onFloor(const Figure& figure, Posture posture);

/// A ball joint's three angles as a rotation of its segment in the parent, and back; `first` is its flexion.
dmat3 ballRotationOf(const Posture& posture, Dof first);
void setBallRotation(Posture& posture, Dof first, const dmat3& R_PS);

/// An angle outside its hard limits, rad.
struct LimitViolation {
  std::string what;  ///< "l_elbow_flexion"
  double angle = 0.0, limit = 0.0;
};
/// "l_elbow_flexion is -4.0 deg, limit 0.0 deg".
Text textOf(const LimitViolation& violation);

/// Angles outside their hard limits (including the coupled ones at shoulders and hips). Nothing is clamped.
std::vector<LimitViolation> limitViolations(const Posture& posture, double tolerance_rad = 1e-6);

/// The posture at `s` in [0, 1] of the motion from one to the other: hinges linearly, ball joints and the root about
/// fixed axes.
Posture interpolate(const Posture& from, const Posture& to, double s);

/// The rotation of each segment relative to its parent on that motion, rad (hinges of one joint are summed); the root's
/// first.
std::array<double, kSegmentCount> turnsBetween(const Posture& from, const Posture& to);

/// A posture of the library, by its angles in degrees that differ from zero.
struct LibraryPosture {
  std::string name;  ///< "standing", "seated", "overhead", ...
  Posture posture;   ///< Root at the origin of x and y; use onFloor() for its height.
};

/// The built-in postures: zero, standing, t_pose, seated, overhead, kneeling, kneeling_one, squatting, stooping,
/// reaching, both_hands_forward, pushing, typing, lying. Their angles are our own choice.
const std::vector<LibraryPosture>& postureLibrary();
/// One of them placed for the figure (feet, knees or back on the floor; a seated one's feet). Empty: no such name.
std::optional<Posture> libraryPosture(const Figure& figure, std::string_view name);

}  // namespace hapticell::mannequin
