// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/body_sizes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::FigurePose;
using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

/// rad (20 deg) that an upper arm is off the trunk's line, RULA's first class. Half: arms that hang count as at work;
/// twice: hands that work low are not asked of other bodies.
constexpr double kRaised = 0.35;
/// rad (26 deg) of elbow flexion, more than a hanging arm's. Our choice. Half: a hanging arm counts as at work; twice:
/// less bent working arms do not.
constexpr double kBent = 0.45;

dvec3 feetMiddle(const FigurePose& pose) {
  return 0.5 * (mannequin::footPose(pose, Side::kLeft).p + mannequin::footPose(pose, Side::kRight).p);
}

/// Whether it is the very body: then it needs not be put where it stands.
bool isSameBody(const Figure& a, const Figure& b) {
  using mannequin::Dimension;
  return a.sex == b.sex &&
         std::abs(a.body[Dimension::kStature] - b.body[Dimension::kStature]) < mannequin::kSameStature;
}

BodyAtTask presentBody(const Figure& figure, const Posture& posture, const WorkTask& task) {
  BodyAtTask body;
  body.figure = figure;
  body.posture = posture;
  body.is_reached = true;
  const FigurePose pose = mannequin::forwardKinematics(figure, posture);
  body.reach_left_m = reachLeft(figure, pose, activeHands(pose, posture));
  body.scores = scorePosture(figure, posture, pose, task);
  return body;
}

BodyAtTask solveFor(const Figure& from, const Posture& posture, const Figure& figure, const WorkTask& task) {
  BodyAtTask body;
  body.figure = figure;
  const Posture start = standingAt(from, posture, figure);
  const auto active = activeHands(mannequin::forwardKinematics(from, posture), posture);
  const auto result = mannequin::PostureSolver(figure).solve(taskAt(from, posture, figure, dvec3(0.0)), start);
  body.posture = result.posture;
  body.is_reached = result.status == mannequin::PostureStatus::kSolved;
  body.short_m = body.is_reached ? 0.0 : std::max(result.hand_position_error[0], result.hand_position_error[1]);
  const FigurePose pose = mannequin::forwardKinematics(figure, body.posture);
  body.reach_left_m = reachLeft(figure, pose, active);
  body.scores = scorePosture(figure, body.posture, pose, task);
  return body;
}

}  // namespace

std::array<bool, 2> activeHands(const FigurePose& pose, const Posture& posture) {
  std::array<bool, 2> active{};
  const dvec3 down = glm::normalize(pose[Segment::kPelvis].p_WS - pose[Segment::kLowerNeck].p_WS);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const dvec3 upper =
        pose[armSegment(side, Segment::kLeftForearm)].p_WS - pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
    const double raised = std::acos(std::clamp(glm::dot(glm::normalize(upper), down), -1.0, 1.0));
    active[static_cast<std::size_t>(side)] = raised > kRaised || posture[armDof(side, Dof::kLeftElbowFlexion)] > kBent;
  }
  if (!active[0] && !active[1]) active[1] = true;
  return active;
}

double reachLeft(const Figure& figure, const FigurePose& pose, const std::array<bool, 2>& active) {
  double left = 1e9;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (!active[static_cast<std::size_t>(side)]) continue;
    const dvec3 shoulder = pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
    const double distance = glm::length(mannequin::handPose(pose, side).p - shoulder);
    left = std::min(left, figure.upperArmLength() + figure.forearmLength() - distance);
  }
  return std::max(0.0, left);
}

Posture standingAt(const Figure& from, const Posture& posture, const Figure& figure) {
  const FigurePose pose = mannequin::forwardKinematics(from, posture);
  Posture result = posture;
  const dvec3 shift = feetMiddle(pose) - feetMiddle(mannequin::forwardKinematics(figure, result));
  result.X_WR.p += dvec3(shift.x, shift.y, 0.0);
  const double floor = posture.X_WR.p.z - mannequin::onFloor(from, posture).X_WR.p.z;
  result = mannequin::onFloor(figure, result);
  result.X_WR.p.z += floor;
  return result;
}

Posture seatedAt(const Posture& posture, const Figure& figure) {
  const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  Posture seated = *mannequin::libraryPosture(figure, "seated");
  const dquat heading = quaternionFromRotationVector({0.0, 0.0, std::atan2(ahead.y, ahead.x)});
  seated.X_WR.q = glm::normalize(heading * seated.X_WR.q);
  seated.X_WR.p.x = posture.X_WR.p.x;
  seated.X_WR.p.y = posture.X_WR.p.y;
  return seated;
}

mannequin::PostureTask taskAt(const Figure& from, const Posture& posture, const Figure& figure, const dvec3& shift_W) {
  const FigurePose pose = mannequin::forwardKinematics(from, posture);
  const auto active = activeHands(pose, posture);
  mannequin::PostureTask task;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    if (!active[i]) continue;
    const Pose hand = mannequin::handPose(pose, side);
    const dvec3 grip = hand * from.p_HandGrip[i] + shift_W;
    task.hands[i] = Pose{grip - hand.rotate(figure.p_HandGrip[i]), hand.q};
  }
  if (looksSeated(from, pose)) {
    task.pelvis_locked = true;
    task.balance = false;
  }
  return task;
}

std::vector<BodyAtTask> atSameTask(const std::vector<mannequin::NamedFigure>& bodies, const Figure& figure,
                                   const Posture& posture, const WorkTask& task) {
  std::vector<BodyAtTask> result;
  for (const mannequin::NamedFigure& body : bodies) {
    result.push_back(isSameBody(figure, body.figure) ? presentBody(figure, posture, task)
                                                     : solveFor(figure, posture, body.figure, task));
    result.back().name = body.name;
  }
  return result;
}

std::vector<std::vector<int>> scoresByHeight(const std::vector<mannequin::NamedFigure>& bodies, const Figure& figure,
                                             const Posture& posture, const WorkTask& task,
                                             const std::vector<double>& rises) {
  // From where the work is now outwards, each height from its neighbour: so the middle is what atSameTask() tells.
  std::vector<std::size_t> outwards(rises.size());
  std::iota(outwards.begin(), outwards.end(), std::size_t{0});
  std::stable_sort(outwards.begin(), outwards.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(rises[a]) < std::abs(rises[b]); });
  // m: the place as it is, but for rounding. Half, twice: no effect, places are 0.01 m apart.
  constexpr double kHere = 1e-9;
  std::vector<std::vector<int>> scores;
  for (const mannequin::NamedFigure& body : bodies) {
    const mannequin::PostureSolver solver(body.figure);
    const bool is_same = isSameBody(figure, body.figure);
    Posture up = is_same ? posture : standingAt(figure, posture, body.figure), down = up;
    scores.emplace_back(rises.size(), 0);
    for (const std::size_t i : outwards) {
      const bool is_here = std::abs(rises[i]) < kHere;
      Posture& last = !is_here && rises[i] < 0.0 ? down : up;
      if (!is_here || !is_same) {
        const auto found = solver.solve(taskAt(figure, posture, body.figure, dvec3(0.0, 0.0, rises[i])), last);
        if (found.status != mannequin::PostureStatus::kSolved) continue;
        last = found.posture;
      }
      if (is_here) down = up;  // Both ways begin here.
      scores.back()[i] = scorePosture(body.figure, last, mannequin::forwardKinematics(body.figure, last), task).rula();
    }
  }
  return scores;
}

}  // namespace hapticell::ergonomics
