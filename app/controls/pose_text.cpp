// SPDX-License-Identifier: Apache-2.0
#include "app/controls/pose_text.h"

#include <cmath>

#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// Sine of the middle angle from which only the sum of the others is known: 1e-6 rad off 90 degrees. Half or twice the
// rest: no effect on six shown digits.
constexpr double kLock = 1.0 - 1e-12;

}  // namespace

std::array<double, 3> abcDegrees(const dquat& q) {
  const dmat3 R = glm::mat3_cast(q);  // Column first: R[c][r].
  const double sin_b = -R[0][2];
  if (std::abs(sin_b) >= kLock) {
    const double a = std::atan2(-R[1][0], R[1][1]);
    return {a / kDegree, std::copysign(90.0, sin_b), 0.0};
  }
  return {std::atan2(R[0][1], R[0][0]) / kDegree, std::asin(sin_b) / kDegree, std::atan2(R[1][2], R[2][2]) / kDegree};
}

dquat fromAbcDegrees(const std::array<double, 3>& abc) {
  const dquat a = glm::angleAxis(abc[0] * kDegree, dvec3(0, 0, 1));
  const dquat b = glm::angleAxis(abc[1] * kDegree, dvec3(0, 1, 0));
  const dquat c = glm::angleAxis(abc[2] * kDegree, dvec3(1, 0, 0));
  return glm::normalize(a * b * c);
}

std::array<double, 6> poseNumbers(const Pose& X) {
  const auto abc = abcDegrees(X.q);
  return {1000.0 * X.p.x, 1000.0 * X.p.y, 1000.0 * X.p.z, abc[0], abc[1], abc[2]};
}

Pose poseFromNumbers(const std::array<double, 6>& numbers) {
  return {dvec3(numbers[0], numbers[1], numbers[2]) / 1000.0, fromAbcDegrees({numbers[3], numbers[4], numbers[5]})};
}

Pose tcpPose_W(const workcell::Entity& robot, const Pose& X_WB, const std::vector<double>& joints) {
  if (!robot.robot() || joints.size() != robot.robot()->dof()) return X_WB;
  const int tip = robot.robot()->findLink(robot.jointed().tip_link);
  if (tip < 0) return X_WB;
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), joints, X_BL);
  return X_WB * X_BL[static_cast<std::size_t>(tip)] * robot.jointed().X_LT;
}

Pose gripPose_W(const workcell::Entity& entity, mannequin::Side side, const Pose& X_WE,
                const std::vector<double>& joints) {
  const mannequin::Figure& figure = *entity.figure();
  const mannequin::FigurePose pose =
      mannequin::forwardKinematics(figure, mannequin::toPosture(figure, {X_WE, joints}));
  const Pose X_WH = mannequin::handPose(pose, side);
  return {X_WH * figure.p_HandGrip[static_cast<std::size_t>(side)], X_WH.q};
}

}  // namespace hapticell::app
