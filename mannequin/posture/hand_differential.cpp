// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/hand_differential.h"

#include "mannequin/posture/body_solver.h"

namespace hapticell::mannequin {

namespace {

/// m (and rad) of the motion that is asked of the linear model; small enough for bounds of a step. Half, twice: the
/// same, it is linear.
constexpr double kProbe = 1e-3;

/// Motion of one segment from the variables that move it.
Twist motionOf(Segment segment, const FigurePose& pose, const VariableAxes& axes, const Variables& step) {
  std::array<bool, kSegmentCount> carries{};
  for (Segment s = segment;; s = *segmentInfo(s).parent) {
    carries[indexOf(s)] = true;
    if (!segmentInfo(s).parent) break;
  }
  const dvec3 p = pose[segment].p_WS;
  Twist twist;
  for (std::size_t v = 0; v < kVariables; ++v) {
    if (step[v] == 0.0 || !carries[indexOf(segmentOfVariable(static_cast<int>(v)))]) continue;
    if (v < 3) {
      twist.linear += step[v] * axes.axis[v];
      continue;
    }
    twist.angular += step[v] * axes.axis[v];
    twist.linear += step[v] * glm::cross(axes.axis[v], p - axes.origin[v]);
  }
  return twist;
}

}  // namespace

HandDifferential differentiateHand(const Figure& figure, const Posture& posture, const PostureTask& task, Side driven,
                                   const Pose& X_WM) {
  const FigurePose pose = forwardKinematics(figure, posture);
  PostureTask here = task;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    if (here.hands[i]) here.hands[i] = handPose(pose, side);
  }
  if (here.held) {
    here.held->X_WO = handPose(pose, Side::kLeft) * here.held->X_OH[0].inverse();
  }
  const ResolvedTask resolved = resolve(figure, here, pose);
  BodySolver solver(figure, resolved);
  solver.set(stateOf(posture));
  const dvec3 lever = pose[armSegment(driven, Segment::kLeftHand)].p_WS - X_WM.p;
  HandDifferential differential{};
  for (std::size_t i = 0; i < 6; ++i) {
    dvec3 unit(0.0);
    unit[static_cast<int>(i % 3)] = kProbe;
    const Twist wanted = i < 3 ? Twist{unit, dvec3(0.0)} : Twist{glm::cross(unit, lever), unit};
    VariableAxes axes;
    const Variables step = solver.response(driven, wanted, axes);
    for (std::size_t s = 0; s < kSegmentCount; ++s) {
      const Twist twist = motionOf(static_cast<Segment>(s), pose, axes, step);
      differential[s][i] = {twist.linear / kProbe, twist.angular / kProbe};
    }
  }
  return differential;
}

}  // namespace hapticell::mannequin
