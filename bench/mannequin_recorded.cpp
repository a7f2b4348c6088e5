// SPDX-License-Identifier: Apache-2.0
#include "bench/mannequin_recorded.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bench/thread_clock.h"
#include "mannequin/motion/retarget.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/limb_inverse.h"

namespace hapticell::bench {

using namespace mannequin;

namespace {

double angleDeg(const dvec3& a, const dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) / kDegree;
}

dvec3 trunkOf(const FigurePose& pose) {
  return pose[Segment::kLowerNeck].p_WS - 0.5 * (pose[Segment::kLeftThigh].p_WS + pose[Segment::kRightThigh].p_WS);
}

double swivelOf(const Figure& figure, const FigurePose& pose, Side side) {
  const ArmProblem arm(figure, side, pose[Segment::kThorax], pose[armSegment(side, Segment::kLeftClavicle)],
                       pose[armSegment(side, Segment::kLeftHand)]);
  return arm.swivelOf(pose[armSegment(side, Segment::kLeftForearm)].p_WS);
}

}  // namespace

RecordedError replayHandsAndFeet(const Figure& figure, const MotionClip& clip) {
  RecordedError error;
  const Expected<RetargetedMotion> motion = retarget(figure, clip);
  if (!motion) return error;
  const PostureSolver solver(figure);
  const auto every = static_cast<std::size_t>(std::max(1L, std::lround(1.0 / 60.0 / motion->frame_time)));
  Posture posture = motion->postures.front();
  std::vector<double> times;
  int elbows = 0;
  for (std::size_t f = 0; f < motion->postures.size(); f += every) {
    const FigurePose real = forwardKinematics(figure, motion->postures[f]);
    PostureTask task;
    task.balance = false;
    task.comfort_steps = 60;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto i = static_cast<std::size_t>(side);
      task.hands[i] = handPose(real, side);
      task.feet[i] = footPose(real, side);
    }
    const double begin = threadMilliseconds();
    posture = solver.solve(task, posture).posture;
    times.push_back(1e3 * (threadMilliseconds() - begin));
    const FigurePose ours = forwardKinematics(figure, posture);
    const dvec3 up(0.0, 0.0, 1.0);
    error.trunk_deg += std::abs(angleDeg(trunkOf(real), up) - angleDeg(trunkOf(ours), up));
    error.trunk_axis_deg += angleDeg(trunkOf(real), trunkOf(ours));
    ++error.frames;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Segment forearm = armSegment(side, Segment::kLeftForearm);
      error.worst_hand_mm =
          std::max(error.worst_hand_mm, 1000.0 * glm::length(handPose(real, side).p - handPose(ours, side).p));
      if (motion->postures[f][armDof(side, Dof::kLeftElbowFlexion)] < 20.0 * kDegree) continue;
      const double off =
          std::remainder(swivelOf(figure, real, side) - swivelOf(figure, ours, side), 2.0 * std::numbers::pi);
      error.swivel_deg += std::abs(off) / kDegree;
      error.elbow_mm += 1000.0 * glm::length(real[forearm].p_WS - ours[forearm].p_WS);
      ++elbows;
    }
  }
  error.trunk_deg /= error.frames;
  error.trunk_axis_deg /= error.frames;
  error.swivel_deg /= std::max(1, elbows);
  error.elbow_mm /= std::max(1, elbows);
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  error.median_us = times[times.size() / 2];
  return error;
}

}  // namespace hapticell::bench
