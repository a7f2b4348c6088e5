// SPDX-License-Identifier: Apache-2.0
#include "planning/timed_plan.h"

#include <algorithm>
#include <cmath>

#include "manipulation/checks/kept_free.h"
#include "manipulation/checks/motion_replay.h"
#include "planning/shortening.h"
#include "planning/standing_figure.h"
#include "trajectory/timing/retiming.h"

namespace hapticell::planning {

namespace {

using trajectory::Trajectory;

/// s to full speed, as `trajectory retime` assumes; our choice. Half: twice the acceleration asked of the robot; twice:
/// half.
constexpr double kTimeToSpeed = 0.25;
/// A smooth path strays from the straight one by up to 8 % of the way between two frames (pathThrough()): frames are so
/// many slacks apart at most. Half: twice the frames; twice: it may stray by more than the slack.
constexpr double kFrameSlacks = 6.0;
/// m: the least slack that frames are set by. Half: twice the frames of a tight plan; twice: a tight plan may stray by
/// 0.2 mm more, which its check finds.
constexpr double kLeastFrameSlack = 1e-4;
/// m: corners are rounded off by no more where poses are to be passed: half of what the written motion is measured by.
/// Half: slower at corners; twice: poses may be missed.
constexpr double kThroughSlack = 0.5 * Passing::kPosition;
/// Pieces of one motion at most. Half: long tight motions may stray; twice: twice the time to smooth them.
constexpr int kMostPieces = 200;
/// rad (or m) by which a joint is moved to see how far it takes the parts.
constexpr double kLeverStep = 0.05;

/// How far (m) parts are taken when all joints that the plan moves turn by a radian, added up.
double leverOf(const Plan& plan, const FreeSpace& space) {
  const EntityConfiguration& present = space.present();
  double sum = 0.0;
  for (std::size_t i = 0; i < present.joints.size(); ++i) {
    const bool stays = space.figure() != nullptr &&
                       std::all_of(plan.waypoints.begin(), plan.waypoints.end(), [&](const EntityConfiguration& at) {
                         return at.joints[i] == plan.waypoints.front().joints[i];
                       });
    if (stays) continue;
    EntityConfiguration moved = present;
    moved.joints[i] += kLeverStep;
    sum += space.pathBound(present, moved) / kLeverStep;
  }
  return std::max(sum, 1e-3);
}

trajectory::MotionLimits limitsOf(const FreeSpace& space) {
  trajectory::MotionLimits limits;
  if (space.figure() != nullptr) {
    limits.velocity = space.figure()->speeds();
  } else if (space.hasJoints()) {
    const kinematics::RobotModel& robot = *space.entity().robot();
    for (const int joint : robot.moving) {
      limits.velocity.push_back(kinematics::greatestSpeed(robot.joints[static_cast<std::size_t>(joint)]));
    }
  } else {
    limits.velocity = {kSolidSpeed, kSolidSpeed, kSolidSpeed, kSolidTurn, kSolidTurn, kSolidTurn};
  }
  for (const double speed : limits.velocity) limits.acceleration.push_back(speed / kTimeToSpeed);
  return limits;
}

/// Frames on the plan's ways, so close that a smooth path through them stays by these.
Trajectory framesOf(const Plan& plan, const FreeSpace& space, double apart) {
  Trajectory frames;
  frames.entity = space.entity().name;
  frames.moved = space.hasJoints() ? "tcp" : "self_origin";
  if (space.figure() != nullptr) frames.moved = "whole";
  if (space.hasJoints()) {
    const kinematics::RobotModel& robot = *space.entity().robot();
    for (const int joint : robot.moving) {
      frames.joint_names.push_back(robot.joints[static_cast<std::size_t>(joint)].name);
    }
  }
  double t = 0.0;
  const auto add = [&](const EntityConfiguration& at) {
    Trajectory::Frame frame;
    frame.t = t;
    frame.X_WT = space.figure() != nullptr ? at.X_WE : space.toolAt(at);
    frames.addFrame(frame, at.joints);
    t += 1.0;
  };
  add(plan.waypoints.front());
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const EntityConfiguration &from = plan.waypoints[i - 1], &to = plan.waypoints[i];
    const double way = space.pathBound(from, to);
    const int pieces = std::clamp(static_cast<int>(std::ceil(way / apart)), 1, kMostPieces);
    for (int k = 1; k <= pieces; ++k) add(space.between(from, to, static_cast<double>(k) / pieces));
  }
  return frames;
}

/// The same motion of a mannequin, its legs as its feet ask for.
Trajectory onItsFeet(const StandingFigure& figure, const Trajectory& motion) {
  Trajectory result = motion.emptyCopy();
  result.reserve(motion.size());
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Trajectory::Frame frame = motion[i];
    const auto joints = motion.joints(i);
    const EntityConfiguration at = figure.onItsFeet({frame.X_WT, {joints.begin(), joints.end()}});
    frame.X_WT = at.X_WE;
    frame.is_pose_apart = false;
    result.addFrame(frame, at.joints);
  }
  return result;
}

trajectory_checks::PosesByJoints posesByJoints(const FreeSpace& space) {
  if (const StandingFigure* figure = space.figure())
    return [figure](const Trajectory& motion) { return Expected<Trajectory>(onItsFeet(*figure, motion)); };
  if (!space.hasJoints()) return {};
  return [entity = space.entity()](const Trajectory& motion) { return manipulation::posesFromJoints(entity, motion); };
}

}  // namespace

Expected<Trajectory> timedMotion(const Plan& plan, const FreeSpace& space, const TimingChoice& choice) {
  double slack = choice.rounding * std::max(plan.slack, kLeastFrameSlack);
  if (!plan.through.empty()) slack = std::min(slack, kThroughSlack);
  trajectory::RetimingOptions options;
  options.limits = limitsOf(space);
  options.sample_s = choice.sample_s;
  if (space.hasJoints()) {
    options.tolerance.joint = 0.5 * slack / leverOf(plan, space);
    options.tolerance.position = 0.5 * slack;
    options.tolerance.angle = options.tolerance.joint;
  } else {
    options.tolerance.position = 0.25 * slack;
    options.tolerance.angle = 0.25 * slack / std::max(1e-3, space.radius());
  }
  const Trajectory frames = framesOf(plan, space, kFrameSlacks * slack);
  auto timed = manipulation::retimedByJoints(frames, options, posesByJoints(space));
  HAPTICELL_TRY(timed);
  return std::move(timed->trajectory);
}

}  // namespace hapticell::planning
