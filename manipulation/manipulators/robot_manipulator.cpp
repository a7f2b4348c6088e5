// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/robot_manipulator.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/model/jog.h"
#include "kinematics/model/link_pose.h"
#include "manipulation/manipulators/robot_differential.h"
#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

const char* toString(LimitKind kind) {
  constexpr const char* kWords[] = {"joint", "reach", "singularity", "loop", "speed"};
  return kWords[static_cast<std::size_t>(kind)];
}

namespace {

using kinematics::Joint;
using kinematics::JointType;

/// Length of a gradient, rotation weighed with the lever: how fast the constraint closes for a metre of motion.
double slopeOf(const haptic::Vector6& gradient, double lever) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double part = i < 3 ? gradient[i] : gradient[i] / lever;
    sum += part * part;
  }
  return std::sqrt(sum);
}

void normalise(haptic::Constraint& constraint, double slope) {
  constraint.gap /= slope;
  for (double& a : constraint.gradient) a /= slope;
  for (double& b : constraint.curvature) b /= slope;
}

/// A part that is fixed to a link follows it rigidly: velocities and accelerations of its own origin.
PartDifferential carriedBy(const PartDifferential& link, const dvec3& p_WPo) {
  PartDifferential part;
  part.p_WPo = p_WPo;
  for (std::size_t i = 0; i < 6; ++i) {
    part.velocity[i] = {pointVelocity(link, p_WPo, i), link.velocity[i].angular};
    for (std::size_t j = i; j < 6; ++j) {
      const std::size_t at = packedIndex(i, j);
      part.acceleration[at] = {pointAcceleration(link, p_WPo, i, j), link.acceleration[at].angular};
    }
  }
  return part;
}

Text marginText(const kinematics::ClosureMargin& margin) {
  const double left = std::max(0.0, margin.value);
  switch (margin.kind) {
    case kinematics::ClosureMargin::Kind::kAngle:
      return Text("%1 is %2 from its limit", margin.what, Text::Angle{left});
    case kinematics::ClosureMargin::Kind::kLength:
      return Text("%1 is %2 from its limit", margin.what, Text::Length{left});
    case kinematics::ClosureMargin::Kind::kSingularity:
      return Text("%1 is near a position where nothing holds it", margin.what);
  }
  return {};
}

/// Pieces of a step whose bounds are added. Half: kPathMargin would have to be larger; twice: twice the time of each
/// check.
constexpr int kPathSamples = 4;
/// Times, for the bend between samples: a chord of up to 60 deg of arc is 5 % short, and other links add. Half of the
/// quarter: fast joints may pass a bound; twice: more queries.
constexpr double kPathMargin = 1.25;

}  // namespace

RobotManipulator::RobotManipulator(std::shared_ptr<const kinematics::RobotModel> model, const Tool& tool,
                                   std::unique_ptr<const kinematics::InverseModel> inverse, std::vector<Part> parts)
    : model_(std::move(model)), tool_(tool), inverse_(std::move(inverse)), parts_(std::move(parts)) {
  HAPTICELL_DEMAND(model_ && inverse_);
  HAPTICELL_DEMAND(tool_.tip_link >= 0 && static_cast<std::size_t>(tool_.tip_link) < model_->links.size());
}

void RobotManipulator::stopAtSingularities() {
  const kinematics::Chain* chain = inverse_->chain();
  if (chain == nullptr || model_->closure) return;
  wall_.emplace(*model_, tool_.tip_link, tool_.X_LT, std::max(1e-3, 0.5 * chain->reach()));
}

double RobotManipulator::resistance(const EntityConfiguration& configuration, std::span<const double> friction) const {
  HAPTICELL_DEMAND(friction.size() == model_->dof());
  const RobotDifferential robot =
      differentiateRobot(*model_, configuration.joints, configuration.X_WE, tool_.tip_link, tool_.X_LT);
  // The power of all joints for a metre a second: a joint turns by its row of the inverse Jacobian.
  double force = 0.0;
  for (std::size_t v = 0; v < friction.size(); ++v) {
    const auto& rate = robot.joint_velocity[v];
    force += friction[v] * glm::length(dvec3(rate[0], rate[1], rate[2]));
  }
  return force;
}

std::vector<RobotManipulator::Part> RobotManipulator::partsOf(const std::vector<int>& links) {
  std::vector<Part> parts;
  for (const int link : links) parts.push_back({link, {}});
  return parts;
}

std::vector<Pose> RobotManipulator::linkPoses(const EntityConfiguration& configuration) const {
  std::vector<Pose> X_WL;
  kinematics::forwardKinematics(*model_, configuration.joints, X_WL);
  for (Pose& pose : X_WL) pose = configuration.X_WE * pose;
  return X_WL;
}

Pose RobotManipulator::movedFrame(const EntityConfiguration& configuration) const {
  return linkPoses(configuration)[static_cast<std::size_t>(tool_.tip_link)] * tool_.X_LT;
}

EntityConfiguration RobotManipulator::propose(const EntityConfiguration& from, const Pose& X_WM,
                                              double duration_s) const {
  const EntityConfiguration to = proposeFreely(from, X_WM, duration_s);
  const double share = wall_ ? wall_->freeShare(from.joints, to.joints) : 1.0;
  if (share >= 1.0) return to;
  // From afar the nearest joints may lie behind the wall; part of the way there may be a way before it.
  const Pose X_WM0 = movedFrame(from);
  for (const double part : {0.5, 0.2, 0.05}) {
    const EntityConfiguration nearer = proposeFreely(from, interpolate(X_WM0, X_WM, part), duration_s);
    if (wall_->freeShare(from.joints, nearer.joints) >= 1.0) return nearer;
  }
  return between(from, to, share);
}

EntityConfiguration RobotManipulator::proposeFreely(const EntityConfiguration& from, const Pose& X_WM,
                                                    double duration_s) const {
  kinematics::InverseSolution solution;
  inverse_->solveNearest(from.X_WE.inverse() * X_WM, from.joints, duration_s, solution);
  const bool finite = std::all_of(solution.q.begin(), solution.q.end(), [](double q) { return std::isfinite(q); });
  if (!finite || solution.q.size() != from.joints.size()) return from;
  return {from.X_WE, std::move(solution.q)};
}

MotionTime RobotManipulator::leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const {
  MotionTime longest;
  for (std::size_t i = 0; i < from.joints.size(); ++i) {
    const int joint = model_->moving[i];
    const double speed = kinematics::greatestSpeed(model_->joints[static_cast<std::size_t>(joint)]);
    const double time = std::abs(to.joints[i] - from.joints[i]) / speed;
    if (time > longest.seconds) longest = {time, joint};
  }
  return longest;
}

EntityConfiguration RobotManipulator::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                              double s) const {
  EntityConfiguration result = from;
  for (std::size_t i = 0; i < result.joints.size(); ++i) result.joints[i] += s * (to.joints[i] - from.joints[i]);
  return result;
}

void RobotManipulator::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  HAPTICELL_DEMAND(X_WP.size() == parts_.size());
  const std::vector<Pose> X_WL = linkPoses(configuration);
  for (std::size_t k = 0; k < X_WP.size(); ++k) {
    X_WP[k] = X_WL[static_cast<std::size_t>(parts_[k].link)] * parts_[k].X_LP;
  }
}

Pose RobotManipulator::partPose(const EntityConfiguration& configuration, std::size_t part) const {
  return configuration.X_WE * kinematics::linkPose(*model_, configuration.joints, parts_[part].link) *
         parts_[part].X_LP;
}

void RobotManipulator::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                  std::span<const PartSphere> spheres, std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == parts_.size() && bounds.size() == parts_.size());
  if (model_->closure) return closedPathBounds(from, to, spheres, bounds);
  const std::vector<Pose> X_WL = linkPoses(from);
  std::vector<double> steps(model_->joints.size(), 0.0);
  for (std::size_t j = 0; j < model_->joints.size(); ++j) {
    const Joint& joint = model_->joints[j];
    steps[j] =
        kinematics::jointPosition(*model_, to.joints, joint) - kinematics::jointPosition(*model_, from.joints, joint);
  }
  // From the link inwards: a point moves, seen from a joint, as far as the joints beyond it take it, so its distance
  // from that joint's axis grows by no more than that.
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const dvec3 center = X_WL[static_cast<std::size_t>(parts_[k].link)] * (parts_[k].X_LP * spheres[k].p_PS);
    bounds[k] = 0.0;
    double turned = 0.0;
    Twist begin;
    for (int at = model_->links[static_cast<std::size_t>(parts_[k].link)].parent_joint; at >= 0;) {
      const Joint& joint = model_->joints[static_cast<std::size_t>(at)];
      const Pose& X_WJ = X_WL[static_cast<std::size_t>(joint.child_link)];
      const dvec3 axis = X_WJ.rotate(joint.axis_J);
      const double lever = glm::length(glm::cross(axis, center - X_WJ.p)) + spheres[k].radius + bounds[k];
      const double step = steps[static_cast<std::size_t>(at)];
      if (joint.type == JointType::kPrismatic) {
        bounds[k] += std::abs(step);
        begin.linear += step * axis;
      } else {
        bounds[k] += std::abs(step) * lever;
        turned += std::abs(step);
        begin.linear += step * glm::cross(axis, center - X_WJ.p);
        begin.angular += step * axis;
      }
      at = model_->links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
    }
    // Joints mostly turn against each other: the speed at the start, and by how much it can change (no point's
    // acceleration is more than twice the turning times its bound), say more than the sum.
    const double speed = glm::length(begin.linear) + spheres[k].radius * glm::length(begin.angular);
    bounds[k] = std::min(bounds[k], speed + 2.0 * turned * bounds[k]);
  }
}

/// The path of a closed loop's links has no simple bound: it is measured along the way.
void RobotManipulator::closedPathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                        std::span<const PartSphere> spheres, std::span<double> bounds) const {
  std::fill(bounds.begin(), bounds.end(), 0.0);
  std::vector<Pose> before(parts_.size()), after(parts_.size());
  partPoses(from, before);
  for (int sample = 1; sample <= kPathSamples; ++sample) {
    partPoses(between(from, to, static_cast<double>(sample) / kPathSamples), after);
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      const double moved = glm::length(after[k] * spheres[k].p_PS - before[k] * spheres[k].p_PS);
      const double turned = glm::length(rotationVector(after[k].q * glm::conjugate(before[k].q)));
      bounds[k] += kPathMargin * (moved + spheres[k].radius * turned);
    }
    std::swap(before, after);
  }
}

double RobotManipulator::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  double turned = 0.0;
  if (model_->closure) {
    const std::vector<Pose> X_W0 = linkPoses(from), X_W1 = linkPoses(to);
    for (std::size_t k = 0; k < X_W0.size(); ++k) {
      turned = std::max(turned, glm::length(rotationVector(X_W1[k].q * glm::conjugate(X_W0[k].q))));
    }
    return kPathMargin * turned;
  }
  for (const Joint& joint : model_->joints) {
    if (joint.type == JointType::kPrismatic || joint.type == JointType::kFixed) continue;
    turned += std::abs(kinematics::jointPosition(*model_, to.joints, joint) -
                       kinematics::jointPosition(*model_, from.joints, joint));
  }
  return turned;
}

std::vector<PartDifferential> RobotManipulator::differentiate(const EntityConfiguration& configuration) const {
  const RobotDifferential robot =
      differentiateRobot(*model_, configuration.joints, configuration.X_WE, tool_.tip_link, tool_.X_LT);
  std::vector<PartDifferential> parts;
  parts.reserve(parts_.size());
  const std::vector<Pose> X_WL = linkPoses(configuration);
  for (const Part& part : parts_) {
    const PartDifferential& link = robot.links[static_cast<std::size_t>(part.link)];
    const Pose& X_WLink = X_WL[static_cast<std::size_t>(part.link)];
    parts.push_back(part.X_LP.p == dvec3(0.0) ? link : carriedBy(link, X_WLink * part.X_LP.p));
  }
  return parts;
}

/// The wall about singular positions, to first order.
MotionLimit RobotManipulator::wallAt(const EntityConfiguration& configuration, const RobotDifferential& robot) const {
  MotionLimit limit;
  limit.kind = LimitKind::kSingularity;
  limit.text = Text("The arm is near a singularity");
  limit.constraint_W.id = 999;
  limit.constraint_W.gap = wall_->measure(configuration.joints) - SingularityWall::kFelt;
  const std::vector<double> over_q = wall_->gradient(configuration.joints);
  for (std::size_t v = 0; v < over_q.size(); ++v) {
    for (std::size_t i = 0; i < 6; ++i) limit.constraint_W.gradient[i] += over_q[v] * robot.joint_velocity[v][i];
  }
  return limit;
}

std::vector<MotionLimit> RobotManipulator::limits(const EntityConfiguration& configuration, double zone,
                                                  double lever) const {
  const RobotDifferential robot =
      differentiateRobot(*model_, configuration.joints, configuration.X_WE, tool_.tip_link, tool_.X_LT);
  std::vector<MotionLimit> limits;
  const auto keep = [&](MotionLimit limit) {
    const double slope = slopeOf(limit.constraint_W.gradient, lever);
    if (slope < 1e-9) return;
    normalise(limit.constraint_W, slope);
    if (limit.constraint_W.gap < zone) limits.push_back(std::move(limit));
  };
  for (std::size_t v = 0; v < model_->moving.size(); ++v) {
    const Joint& joint = model_->joints[static_cast<std::size_t>(model_->moving[v])];
    for (const bool upper : {false, true}) {
      const double end = upper ? joint.upper : joint.lower;
      if (!std::isfinite(end)) continue;
      const double sign = upper ? -1.0 : 1.0;
      MotionLimit limit;
      limit.joint = model_->moving[v];
      limit.constraint_W.gap = sign * (configuration.joints[v] - end);
      limit.constraint_W.id = 2 * v + (upper ? 1 : 0);
      for (std::size_t i = 0; i < 6; ++i) limit.constraint_W.gradient[i] = sign * robot.joint_velocity[v][i];
      for (std::size_t i = 0; i < 21; ++i) limit.constraint_W.curvature[i] = sign * robot.joint_acceleration[v][i];
      limit.text = kinematics::limitText(joint, std::max(0.0, limit.constraint_W.gap), upper);
      keep(std::move(limit));
    }
  }
  for (std::size_t m = 0; m < robot.margins.size(); ++m) {
    MotionLimit limit{robot.margins[m].constraint, marginText(robot.margins[m].at), -1, LimitKind::kLoop};
    limit.constraint_W.id = 2 * (model_->moving.size() + m) + 1000;
    keep(std::move(limit));
  }
  if (wall_) keep(wallAt(configuration, robot));
  if (robot.has_edge) keep({robot.edge, Text("The arm is at the edge of its reach"), -1, LimitKind::kReach});
  return limits;
}

}  // namespace hapticell::manipulation
