// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "geometry/shapes/vector.h"

namespace hapticell::mannequin {

enum class Side : std::uint8_t { kLeft, kRight };

/// The rigid bodies of the figure, parents before children. Each has its frame at its proximal joint; at zero posture
/// (standing, arms hanging, palms to the thighs, thumbs forward) all frames are parallel: X forward, Y left, Z up.
enum class Segment : std::uint8_t {
  kPelvis,
  kLowerBack,
  kUpperBack,
  kThorax,
  kLowerNeck,
  kUpperNeck,
  kHead,
  kLeftClavicle,
  kLeftUpperArm,
  kLeftForearm,
  kLeftWrist,
  kLeftHand,
  kRightClavicle,
  kRightUpperArm,
  kRightForearm,
  kRightWrist,
  kRightHand,
  kLeftThigh,
  kLeftShank,
  kLeftFoot,
  kLeftToes,
  kRightThigh,
  kRightShank,
  kRightFoot,
  kRightToes,
};
inline constexpr std::size_t kSegmentCount = 25;

/// The 56 articulated degrees of freedom, in the order of every vector of joint angles (posture, joints[] of the
/// command line, variables of the robot model). The layout is that of the CMU/ASF skeleton: spine 9, neck and head 9,
/// arms 2 x 12, legs 2 x 7. Positive as the name says. Fingers and thumb move the phalanges of the hand (see
/// hand_pose.h).
enum class Dof : std::uint8_t {
  kVl5Flexion,
  kVl5RightBend,
  kVl5LeftTurn,
  kVl1Flexion,
  kVl1RightBend,
  kVl1LeftTurn,
  kVt6Flexion,
  kVt6RightBend,
  kVt6LeftTurn,
  kVc7Flexion,
  kVc7RightBend,
  kVc7LeftTurn,
  kVc4Flexion,
  kVc4RightBend,
  kVc4LeftTurn,
  kSkullbaseFlexion,
  kSkullbaseRightBend,
  kSkullbaseLeftTurn,
  kLeftClavicleElevation,
  kLeftClavicleProtraction,
  kLeftShoulderFlexion,
  kLeftShoulderAbduction,
  kLeftShoulderInternalRotation,
  kLeftElbowFlexion,
  kLeftPronation,
  kLeftWristFlexion,
  kLeftWristUlnarDeviation,
  kLeftFingersCurl,
  kLeftThumbFlexion,
  kLeftThumbAbduction,
  kRightClavicleElevation,
  kRightClavicleProtraction,
  kRightShoulderFlexion,
  kRightShoulderAbduction,
  kRightShoulderInternalRotation,
  kRightElbowFlexion,
  kRightPronation,
  kRightWristFlexion,
  kRightWristUlnarDeviation,
  kRightFingersCurl,
  kRightThumbFlexion,
  kRightThumbAbduction,
  kLeftHipFlexion,
  kLeftHipAbduction,
  kLeftHipInternalRotation,
  kLeftKneeFlexion,
  kLeftAnklePlantarFlexion,
  kLeftAnkleInversion,
  kLeftToesExtension,
  kRightHipFlexion,
  kRightHipAbduction,
  kRightHipInternalRotation,
  kRightKneeFlexion,
  kRightAnklePlantarFlexion,
  kRightAnkleInversion,
  kRightToesExtension,
};
inline constexpr std::size_t kDofCount = 56;

/// Joint angles, rad, one for each Dof. A segment with several turns by R = Ry Rx Rz (those it has) in its parent.
using JointAngles = std::array<double, kDofCount>;

constexpr std::size_t indexOf(Dof dof) {
  return static_cast<std::size_t>(dof);
}
constexpr std::size_t indexOf(Segment segment) {
  return static_cast<std::size_t>(segment);
}

/// The first Dof of an arm (12 of them) or a leg (7), and the same with an offset.
constexpr Dof armDof(Side side, Dof left_dof) {
  return side == Side::kLeft ? left_dof : static_cast<Dof>(indexOf(left_dof) + 12);
}
constexpr Dof legDof(Side side, Dof left_dof) {
  return side == Side::kLeft ? left_dof : static_cast<Dof>(indexOf(left_dof) + 7);
}
constexpr Segment armSegment(Side side, Segment left) {
  return side == Side::kLeft ? left : static_cast<Segment>(indexOf(left) + 5);
}
constexpr Segment legSegment(Side side, Segment left) {
  return side == Side::kLeft ? left : static_cast<Segment>(indexOf(left) + 4);
}
constexpr Side other(Side side) {
  return side == Side::kLeft ? Side::kRight : Side::kLeft;
}

/// Properties of one degree of freedom.
struct DofInfo {
  const char* name;      ///< "l_elbow_flexion": H-Anim joint and motion; unique, stable: posture files use it.
  const char* joint;     ///< H-Anim joint (ISO/IEC 19774), or l_radioulnar, which H-Anim does not define.
  Segment segment;       ///< The segment that it turns; for fingers and thumb the hand that carries them.
  int axis;              ///< 0 x, 1 y, 2 z of the segment's frame at zero posture.
  double sign;           ///< Turn about the positive axis = sign * angle.
  double lower;          ///< Hard limits, rad: never exceeded by the solver. For shoulder and hip these bound the
  double upper;          ///< outermost angles of the figure; the coupled limits of joint_limits.h apply.
  double comfort_lower;  ///< Comfort range, rad: HaptiCell's own choice (docs/dev/mannequin.md), no standard.
  double comfort_upper;
};

const DofInfo& dofInfo(Dof dof);
/// By the name in a posture file; empty if there is no such name.
std::optional<Dof> findDof(std::string_view name);
/// The same motion on the other side; motions of the spine map to themselves.
Dof mirrored(Dof dof);
/// True for a bend or turn of the spine, whose sign changes when left and right are swapped.
bool changesSignWhenMirrored(Dof dof);

/// Properties of one segment.
struct SegmentInfo {
  const char* name;   ///< H-Anim segment: "l_upperarm".
  const char* joint;  ///< H-Anim joint at its frame: "l_shoulder".
  std::optional<Segment> parent;
};

const SegmentInfo& segmentInfo(Segment segment);

/// Gaze: two more degrees of freedom, not counted in the 56. rad; left positive, down positive.
struct Gaze {
  double yaw = 0.0;
  double pitch = 0.0;
};
/// rad, 35 deg to either side, 20 up, 40 down: the range of the eyes in visionVolume() of work_zones.h. Half: the head
/// turns although the eyes could; twice: more than eyes can turn.
inline constexpr double kGazeYawLimit = 0.6108652381980153;
inline constexpr double kGazeUpLimit = 0.3490658503988659;    ///< 20 deg.
inline constexpr double kGazeDownLimit = 0.6981317007977318;  ///< 40 deg.

}  // namespace hapticell::mannequin
