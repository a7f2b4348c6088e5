// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/posture.h"

#include <algorithm>
#include <cmath>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/body/joint_limits.h"

namespace hapticell::mannequin {

namespace {

void addBallViolations(const Posture& posture, BallJoint joint, Side side, double tolerance,
                       std::vector<LimitViolation>& found) {
  const bool shoulder = joint == BallJoint::kShoulder;
  const Dof first = shoulder ? armDof(side, Dof::kLeftShoulderFlexion) : legDof(side, Dof::kLeftHipFlexion);
  const BallState state = ballState(joint, side, ballRotationOf(posture, first));
  const std::string name = std::string(side == Side::kLeft ? "l_" : "r_") + (shoulder ? "shoulder" : "hip");
  if (state.excess() > tolerance) {
    found.push_back({name + ", swing from the middle of its range,", state.rho, state.rho_max});
  }
  const double twist = std::clamp(state.twist, twistLower(joint), twistUpper(joint));
  if (std::abs(twist - state.twist) > tolerance) {
    found.push_back({name + ", internal rotation,", state.twist, twist});
  }
}

}  // namespace

dmat3 ballRotationOf(const Posture& posture, Dof first) {
  const std::size_t i = indexOf(first);
  dvec3 angles(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i + k));
    angles[info.axis] = info.sign * posture.angles[i + k];
  }
  return rotationYXZ(angles);
}

void setBallRotation(Posture& posture, Dof first, const dmat3& R_PS) {
  const dvec3 angles = anglesYXZ(R_PS);
  const std::size_t i = indexOf(first);
  for (std::size_t k = 0; k < 3; ++k) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i + k));
    posture.angles[i + k] = info.sign * angles[info.axis];
  }
}

Posture mirror(const Posture& posture) {
  Posture result = posture;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = static_cast<Dof>(i);
    result[mirrored(dof)] = changesSignWhenMirrored(dof) ? -posture[dof] : posture[dof];
  }
  // Seen from the root's heading: the turn about the vertical stays, pitch stays, roll changes its sign.
  const dvec3 forward = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const dquat heading = quaternionFromRotationVector({0.0, 0.0, std::atan2(forward.y, forward.x)});
  const dquat tilt = glm::conjugate(heading) * posture.X_WR.q;
  result.X_WR.q = glm::normalize(heading * dquat(tilt.w, -tilt.x, tilt.y, -tilt.z));
  result.gaze.yaw = -posture.gaze.yaw;
  return result;
}

Posture swapHands(const Posture& posture) {
  Posture result = posture;
  for (std::size_t i = indexOf(Dof::kLeftClavicleElevation); i < indexOf(Dof::kLeftHipFlexion); ++i) {
    const Dof dof = static_cast<Dof>(i);
    result[mirrored(dof)] = posture[dof];
  }
  return result;
}

namespace {

constexpr std::array<Dof, 4> kBallStarts = {Dof::kLeftShoulderFlexion, Dof::kRightShoulderFlexion, Dof::kLeftHipFlexion,
                                            Dof::kRightHipFlexion};

dvec3 turnOfBall(const Posture& from, const Posture& to, Dof first) {
  return rotationVector(glm::quat_cast(ballRotationOf(to, first) * glm::transpose(ballRotationOf(from, first))));
}

}  // namespace

Posture interpolate(const Posture& from, const Posture& to, double s) {
  Posture posture = from;
  posture.X_WR = interpolate(from.X_WR, to.X_WR, s);
  for (std::size_t i = 0; i < kDofCount; ++i) posture.angles[i] += s * (to.angles[i] - from.angles[i]);
  for (const Dof first : kBallStarts) {
    const dquat part = quaternionFromRotationVector(s * turnOfBall(from, to, first));
    setBallRotation(posture, first, glm::mat3_cast(part) * ballRotationOf(from, first));
  }
  posture.gaze = {from.gaze.yaw + s * (to.gaze.yaw - from.gaze.yaw),
                  from.gaze.pitch + s * (to.gaze.pitch - from.gaze.pitch)};
  return posture;
}

std::array<double, kSegmentCount> turnsBetween(const Posture& from, const Posture& to) {
  std::array<double, kSegmentCount> turns{};
  turns[0] = glm::length(difference(to.X_WR, from.X_WR).angular);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = static_cast<Dof>(i);
    if (!isCoupled(dof)) turns[indexOf(dofInfo(dof).segment)] += std::abs(to.angles[i] - from.angles[i]);
  }
  for (const Dof first : kBallStarts) {
    turns[indexOf(dofInfo(first).segment)] = glm::length(turnOfBall(from, to, first));
  }
  return turns;
}

double lowestPoint(const Figure& figure, const FigurePose& pose) {
  const Sole& sole = figure.sole;
  double lowest = 1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SegmentPlace& foot = pose[legSegment(side, Segment::kLeftFoot)];
    const SegmentPlace& toes = pose[legSegment(side, Segment::kLeftToes)];
    const double below = sole.z - figure.p_PS[indexOf(Segment::kLeftToes)].z;
    for (const double edge : {-0.5, 0.5}) {
      lowest = std::min(lowest, foot.point({sole.heel_x, edge * sole.heel_width, sole.z}).z);
      lowest = std::min(lowest, foot.point({sole.ball_x, edge * sole.ball_width, sole.z}).z);
    }
    lowest = std::min(lowest, toes.point({sole.toe_x - sole.ball_x, 0.0, below}).z);
    // A knee on the floor rests on its front, about a quarter of the thigh's clearance before the joint.
    const SegmentPlace& shank = pose[legSegment(side, Segment::kLeftShank)];
    const double knee = 0.32 * figure.body[Dimension::kThighClearance];
    lowest = std::min(lowest, shank.p_WS.z - knee);
  }
  const double seat = 0.45 * figure.body[Dimension::kChestDepth];
  lowest = std::min(lowest, pose[Segment::kPelvis].p_WS.z - seat);
  return lowest;
}

Posture onFloor(const Figure& figure, Posture posture) {
  posture.X_WR.p.z -= lowestPoint(figure, forwardKinematics(figure, posture));
  return posture;
}

Text textOf(const LimitViolation& violation) {
  return Text("%1 is %2, limit %3", violation.what, Text::Angle{violation.angle}, Text::Angle{violation.limit});
}

std::vector<LimitViolation> limitViolations(const Posture& posture, double tolerance_rad) {
  std::vector<LimitViolation> found;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = static_cast<Dof>(i);
    if (isCoupled(dof)) continue;
    const DofInfo& info = dofInfo(dof);
    if (posture[dof] < info.lower - tolerance_rad) found.push_back({info.name, posture[dof], info.lower});
    if (posture[dof] > info.upper + tolerance_rad) found.push_back({info.name, posture[dof], info.upper});
  }
  const auto look = [&](const char* name, double angle, double lower, double upper) {
    if (angle < lower - tolerance_rad) found.push_back({name, angle, lower});
    if (angle > upper + tolerance_rad) found.push_back({name, angle, upper});
  };
  look("gaze_yaw", posture.gaze.yaw, -kGazeYawLimit, kGazeYawLimit);
  look("gaze_pitch", posture.gaze.pitch, -kGazeUpLimit, kGazeDownLimit);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    addBallViolations(posture, BallJoint::kShoulder, side, tolerance_rad, found);
    addBallViolations(posture, BallJoint::kHip, side, tolerance_rad, found);
  }
  return found;
}

}  // namespace hapticell::mannequin
