// SPDX-License-Identifier: Apache-2.0
#include "planning/written_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "mannequin/posture/support_polygon.h"
#include "mannequin/shape/figure_model.h"
#include "trajectory/motion/number_text.h"

namespace hapticell::planning {

namespace {

using mannequin::Segment;
using mannequin::Side;
using trajectory::Trajectory;

/// m that a radian counts like: half of a hand, and the tip of a short tool. Half: turns are met half as well; twice:
/// twice.
constexpr double kTurnLever = Passing::kPosition / Passing::kTurn;
/// m that a foot is off its place at most: what the posture solver calls in place. Half: passes as well; twice: feet
/// slide visibly.
constexpr double kFeet = 3e-4;
/// rad beyond a limit: rounding of the curves, as for robots.
constexpr double kBeyondPose = 2e-5;

struct Placed {
  Pose X_WE;
  std::vector<double> joints;
};

Placed placedAt(const Trajectory& motion, std::size_t frame, const std::vector<std::size_t>& columns,
                const workcell::Entity& entity) {
  const bool is_fixed = entity.robot() != nullptr && entity.figure() == nullptr;
  Placed at{is_fixed ? entity.X_WE : motion[frame].X_WT, entity.joints()};
  for (std::size_t j = 0; j < columns.size(); ++j) at.joints[columns[j]] = motion.joints(frame)[j];
  return at;
}

/// The link that carries the moved frame, and where it is there.
std::pair<int, Pose> toolOf(const workcell::Entity& entity, const std::optional<Side>& hand) {
  const kinematics::RobotModel& robot = *entity.robot();
  if (hand) {
    const auto i = static_cast<std::size_t>(*hand);
    const char* const name = mannequin::segmentInfo(armSegment(*hand, Segment::kLeftHand)).name;
    return {robot.findLink(name), Pose::translation(entity.figure()->p_HandGrip[i])};
  }
  const int tip = robot.findLink(entity.jointed().tip_link);
  return {tip < 0 ? robot.defaultTip() : tip, entity.jointed().X_LT};
}

double errorBetween(const Pose& a, const Pose& b) {
  const auto off = trajectory::distanceBetween(a, b);
  return std::max(off.position, kTurnLever * off.angle);
}

/// From the straight way between two frames.
double errorFromWay(const Pose& from, const Pose& to, const Pose& X_WQ) {
  const dvec3 way = to.p - from.p;
  const double length = glm::dot(way, way);
  const double s = length > 0.0 ? std::clamp(glm::dot(X_WQ.p - from.p, way) / length, 0.0, 1.0) : 0.0;
  return std::min({errorBetween(interpolate(from, to, s), X_WQ), errorBetween(from, X_WQ), errorBetween(to, X_WQ)});
}

Text whenText(double t) {
  return Text("at %1 s", trajectory::shortestText(std::round(1e4 * t) / 1e4));
}

}  // namespace

std::vector<Pose> writtenPoses(const Trajectory& motion, const std::vector<std::size_t>& columns,
                               const workcell::Entity& entity, const std::optional<Side>& hand) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Placed placed = placedAt(motion, i, columns, entity);
    if (!entity.robot() || columns.empty()) {
      poses.push_back(motion[i].X_WT);
      continue;
    }
    const auto [link, X_LT] = toolOf(entity, hand);
    std::vector<Pose> X_EL;
    kinematics::forwardKinematics(*entity.robot(), placed.joints, X_EL);
    poses.push_back(placed.X_WE * X_EL[static_cast<std::size_t>(std::max(0, link))] * X_LT);
  }
  return poses;
}

std::vector<Promise> posePromises(const Trajectory& motion, const std::vector<Pose>& X_WT, const Plan& plan) {
  std::vector<Promise> promises;
  double worst = 0.0;
  Text where;
  std::size_t from = 0;  // The way on from here has not been used for the poses before.
  for (std::size_t k = 0; k < plan.X_WThrough.size(); ++k) {
    double least = errorBetween(X_WT[from], plan.X_WThrough[k]);
    std::size_t nearest = from;
    for (std::size_t i = from; i + 1 < X_WT.size(); ++i) {
      const double off = errorFromWay(X_WT[i], X_WT[i + 1], plan.X_WThrough[k]);
      if (off >= least) continue;
      least = off;
      nearest = i;
      if (least <= Passing::kPosition && off > 0.0 && i + 2 < X_WT.size() &&
          errorFromWay(X_WT[i + 1], X_WT[i + 2], plan.X_WThrough[k]) > off)
        break;
    }
    from = nearest;
    if (least < worst) continue;
    worst = least;
    where = Text("pose %1 on the way, %2", k + 1, whenText(motion[nearest].t));
  }
  if (!plan.X_WThrough.empty()) promises.push_back({"through", Passing::kPosition, worst, "m", where, false, 1e-6});
  if (plan.X_WGoal) {
    const Text end = whenText(motion[motion.size() - 1].t);
    const double off = errorBetween(X_WT.back(), *plan.X_WGoal);
    promises.push_back({"pose", Passing::kPosition, off, "m", end, false, 1e-6});
  }
  return promises;
}

std::vector<Promise> figurePromises(const Trajectory& motion, const std::vector<std::size_t>& columns,
                                    const workcell::Entity& entity) {
  const mannequin::Figure& figure = *entity.figure();
  const kinematics::RobotModel& model = *entity.robot();
  std::array<int, 2> links{};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const char* const name = mannequin::segmentInfo(legSegment(side, Segment::kLeftFoot)).name;
    links[static_cast<std::size_t>(side)] = std::max(0, model.findLink(name));
  }
  const auto feetOf = [&](const Placed& placed) {
    std::vector<Pose> X_EL;
    kinematics::forwardKinematics(model, placed.joints, X_EL);
    return std::array{placed.X_WE * X_EL[static_cast<std::size_t>(links[0])],
                      placed.X_WE * X_EL[static_cast<std::size_t>(links[1])]};
  };
  const auto stand = feetOf({entity.X_WE, entity.joints()});
  const auto first = mannequin::forwardKinematics(figure, mannequin::toPosture(figure, {entity.X_WE, entity.joints()}));
  const auto soles = mannequin::supportPolygon(figure, {first[Segment::kLeftFoot], first[Segment::kRightFoot]},
                                               mannequin::standingFeet(figure, first));
  double off_feet = 0.0, beyond = 0.0, inside = std::numeric_limits<double>::infinity(), inside_first = 0.0;
  Text where_feet, where_beyond, where_balance;
  std::map<std::string, double> beyond_first;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Placed placed = placedAt(motion, i, columns, entity);
    const auto feet = feetOf(placed);
    for (std::size_t side = 0; side < 2; ++side) {
      const auto off = trajectory::distanceBetween(feet[side], stand[side]);
      if (std::max(off.position, kTurnLever * off.angle) <= off_feet) continue;
      off_feet = std::max(off.position, kTurnLever * off.angle);
      where_feet = whenText(motion[i].t);
    }
    const mannequin::Posture posture = mannequin::toPosture(figure, {placed.X_WE, placed.joints});
    for (const mannequin::LimitViolation& one : mannequin::limitViolations(posture, 0.0)) {
      const double by = std::abs(one.angle - one.limit);
      if (i == 0) beyond_first[one.what] = by;
      const auto allowed = beyond_first.find(one.what);
      const double more = by - (allowed == beyond_first.end() ? 0.0 : allowed->second);
      if (more <= beyond) continue;
      beyond = more;
      where_beyond = Text("joint '%1'", one.what);
    }
    const dvec3 centre = mannequin::centerOfMass(figure, mannequin::forwardKinematics(figure, posture));
    const double margin = soles.margin({centre.x, centre.y});
    if (i == 0) inside_first = margin;
    if (margin >= inside) continue;
    inside = margin;
    where_balance = whenText(motion[i].t);
  }
  std::vector<Promise> promises{{"limits", 0.0, beyond, "rad", where_beyond, false, kBeyondPose},
                                {"feet", kFeet, off_feet, "m", where_feet, false, 0.0}};
  if (inside_first >= 0.0) promises.push_back({"balance", 0.0, inside, "m", where_balance, true, 1e-6});
  return promises;
}

}  // namespace hapticell::planning
