// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_manipulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "manipulation/manipulators/mannequin_steps.h"
#include "mannequin/posture/hand_differential.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {

namespace {

using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

/// Of the solver for one proposal; each turns joints by 1.8 deg at most: 22 deg. Half: hands lag behind a fast stylus;
/// twice: dearer where they cannot arrive.
constexpr int kMostTicks = 12;
/// To find out how far the reach goes, 5 to 30 us each (Performance, drag tick). Half: the end may not be found; twice:
/// dearer at the end of the reach.
constexpr int kProbeTicks = 24;
/// m that it is looked for ahead at most; what is farther a later set finds. Half: a fast hand meets the end late;
/// twice: bold steps fail more often.
constexpr double kProbed = 0.05;
/// Of a probe's step: less counts as no progress, and the step is halved. Half: creeps on; twice: the end is reported
/// short by 10 % of a step.
constexpr double kProgress = 0.05;
/// m: where no step so small goes on, the reach ends; below kLeastZone of the sets. Half: a tick or two more; twice:
/// the end is felt 1 mm early.
constexpr double kLeastProbe = 5e-4;
/// m, the skin of a held part. Half: a tick more; twice: hands stay behind by what is felt as 0.04 N.
constexpr double kHandsArrived = 2e-5;
/// To either side, 30 deg each (Mannequin, Drags: up to 150 deg). Half: postures with turned hands are not found; twice
/// (15 deg each): twice the time of a search.
constexpr int kTurnsTried = 5;
/// m from between the feet to a hand that works with ease (Mannequin, Drags: 0.38; our choice), between kBothAhead and
/// the reach. Half: against the belly; twice: at the end of the arm.
constexpr double kStandOff = 0.38, kHandAside = 0.18;
/// rad to either side that hands are turned as well: 52 deg. Our choice. Half: postures across the body are not found;
/// twice: of little use beside the wrist's range.
constexpr double kYawTried = 0.9;
/// m that the trunk adds to the arm's reach, and that the body goes down to the floor: generous, as places beyond are
/// not solved for. Half: reachable ones are left out; twice: useless searches.
constexpr double kTrunkAdds = 0.35, kBodyGoesDown = 0.8;
/// m short of what is looked for that counts as all of it: 2 % of kProbed. Half: a tick more; twice: an end may be
/// missed by 2 mm until the next set.
constexpr double kReached = 1e-3;

double errorOf(const mannequin::PostureResult& result) {
  return std::max({result.hand_position_error[0], result.hand_position_error[1], 0.1 * result.hand_orientation_error[0],
                   0.1 * result.hand_orientation_error[1]});
}

}  // namespace

MannequinManipulator::MannequinManipulator(std::shared_ptr<const mannequin::Figure> figure,
                                           std::shared_ptr<const kinematics::RobotModel> model, Hands hands,
                                           const Locks& locks, const EntityConfiguration& taken,
                                           std::vector<Part> parts)
    : MannequinBody(std::move(figure), std::move(model), std::move(parts)),
      solver_(this->figure()),
      hands_(hands),
      locks_(locks) {
  locks_.may_step = locks.may_step && !locks.in_air;
  const mannequin::FigurePose pose = mannequin::forwardKinematics(this->figure(), postureOf(taken));
  const Pose left = mannequin::handPose(pose, Side::kLeft), right = mannequin::handPose(pose, Side::kRight);
  const std::array<Pose, 2> hand = {left, right};
  Pose X_WM = hand[static_cast<std::size_t>(driven())];
  if (isBoth()) {
    X_WM.p = 0.5 * (left.p + right.p);
  } else {
    X_WM.p = X_WM * this->figure().p_HandGrip[static_cast<std::size_t>(driven())];
  }
  for (std::size_t i = 0; i < 2; ++i) {
    X_MH_[i] = X_WM.inverse() * hand[i];
    p_MH_W_[i] = hand[i].p - X_WM.p;
  }
  X_WF_ = feetOf(postureOf(taken));
  q_WM_ = X_WM.q;
}

Side MannequinManipulator::driven() const {
  return hands_ == Hands::kRight ? Side::kRight : Side::kLeft;
}

MannequinManipulator::Feet MannequinManipulator::feetOf(const Posture& posture) const {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), posture);
  return {mannequin::footPose(pose, Side::kLeft), mannequin::footPose(pose, Side::kRight)};
}

mannequin::PostureTask MannequinManipulator::taskFor(const Pose& X_WM, const Feet& X_WF) const {
  mannequin::PostureTask task;
  task.trunk_locked = locks_.trunk;
  task.pelvis_locked = locks_.pelvis || locks_.on_seat;
  task.balance = !locks_.on_seat && !locks_.in_air;
  task.loads = locks_.loads;
  task.feet = {X_WF[0], X_WF[1]};
  if (hands_ == Hands::kBoth) {
    task.held = mannequin::HeldObject{X_WM, X_MH_};
  } else if (hands_ == Hands::kBothApart) {
    for (std::size_t i = 0; i < 2; ++i) task.hands[i] = Pose{X_WM.p + p_MH_W_[i], X_WM.q * X_MH_[i].q};
  } else {
    task.hands[static_cast<std::size_t>(driven())] = X_WM * X_MH_[static_cast<std::size_t>(driven())];
  }
  return task;
}

Pose MannequinManipulator::movedFrame(const EntityConfiguration& configuration) const {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), postureOf(configuration));
  const Pose hand = mannequin::handPose(pose, driven());
  const std::size_t i = static_cast<std::size_t>(driven());
  if (hands_ == Hands::kBothApart) return {hand.p - p_MH_W_[i], glm::normalize(hand.q * glm::conjugate(X_MH_[i].q))};
  return hand * X_MH_[i].inverse();
}

Posture MannequinManipulator::follow(const mannequin::PostureTask& task, Posture posture, dvec3* missing) const {
  double before = 1e9;
  for (int i = 0; i < kMostTicks; ++i) {
    const mannequin::PostureResult result = solver_.follow(task, posture);
    posture = result.posture;
    const double error = errorOf(result);
    if (error < kHandsArrived || error > 0.999 * before) break;
    before = error;
  }
  if (missing != nullptr) {
    const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), posture);
    const std::size_t i = static_cast<std::size_t>(driven());
    const Pose wanted = task.held ? task.held->X_WO * task.held->X_OH[i] : *task.hands[i];
    *missing = wanted.p - mannequin::handPose(pose, driven()).p;
  }
  return posture;
}

EntityConfiguration MannequinManipulator::propose(const EntityConfiguration& from, const Pose& X_WM,
                                                  double duration_s) const {
  const Posture start = postureOf(from);
  if (locks_.may_step) return proposeStepping(start, X_WM, duration_s);
  return configurationOf(follow(taskFor(X_WM, X_WF_), start, nullptr));
}

dvec3 MannequinManipulator::facing_W(const EntityConfiguration& configuration) const {
  const Feet feet = feetOf(postureOf(configuration));
  const dvec3 way = feet[0].rotate({1.0, 0.0, 0.0}) + feet[1].rotate({1.0, 0.0, 0.0});
  const double length = std::hypot(way.x, way.y);
  return length > 1e-6 ? dvec3(way.x, way.y, 0.0) / length : dvec3(1.0, 0.0, 0.0);
}

Posture MannequinManipulator::uprightOn(const Feet& feet, const char* posture) const {
  Posture upright = *mannequin::libraryPosture(figure(), posture);
  const Feet own = feetOf(upright);
  const dvec3 way = feet[0].rotate({1.0, 0.0, 0.0}) + feet[1].rotate({1.0, 0.0, 0.0});
  const dquat turn = turnedLeft(std::atan2(way.y, way.x));
  const dvec3 middle = 0.5 * (own[0].p + own[1].p);
  upright.X_WR = {0.5 * (feet[0].p + feet[1].p) + turn * (upright.X_WR.p - middle),
                  glm::normalize(turn * upright.X_WR.q)};
  return upright;
}

std::vector<EntityConfiguration> MannequinManipulator::upright(const EntityConfiguration& from) const {
  const Feet feet = feetOf(postureOf(from));
  return {configurationOf(uprightOn(feet, "standing")), configurationOf(uprightOn(feet, "both_hands_forward"))};
}

std::vector<EntityConfiguration> MannequinManipulator::uprightBefore(const EntityConfiguration& from,
                                                                     const dvec3& p_WM) const {
  const Posture upright = postureOf(from);
  const Feet feet = feetOf(upright);
  const dvec3 middle = 0.5 * (feet[0].p + feet[1].p), facing = facing_W(from);
  const dvec3 way(p_WM.x - middle.x, p_WM.y - middle.y, 0.0);
  const double length = glm::length(way);
  const double aside = driven() == Side::kLeft ? -kHandAside : kHandAside;
  const double to_the_side = isBoth() ? 0.0 : aside;
  std::vector<EntityConfiguration> places;
  for (const dvec3& ahead : {length > kStandOff ? way / length : facing, facing}) {
    const dvec3 left = glm::cross(dvec3(0.0, 0.0, 1.0), ahead);
    const dquat turn = turnedLeft(std::atan2(ahead.y, ahead.x) - std::atan2(facing.y, facing.x));
    const dvec3 p_WS = middle + way - kStandOff * ahead + to_the_side * left;
    Posture there = upright;
    there.X_WR = {p_WS + turn * (upright.X_WR.p - middle), glm::normalize(turn * upright.X_WR.q)};
    places.push_back(configurationOf(there));
  }
  return places;
}

/// By distances alone, so that nothing is looked for long far outside: an arm's length from the shoulder and what the
/// trunk adds, and down as far as the body goes.
bool MannequinManipulator::mayReach(const Posture& upright, const dvec3& p_WM) const {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), upright);
  dvec3 way = p_WM - pose[mannequin::armSegment(driven(), Segment::kLeftUpperArm)].p_WS;
  way.z += std::clamp(-way.z, 0.0, kBodyGoesDown);
  const std::size_t i = static_cast<std::size_t>(driven());
  const double arm = figure().upperArmLength() + figure().forearmLength() + glm::length(figure().p_HandGrip[i]);
  return glm::length(way) < arm + kTrunkAdds;
}

std::vector<EntityConfiguration> MannequinManipulator::solvedFrom(const EntityConfiguration& from, const dvec3& p_WM,
                                                                  StartFrom anew,
                                                                  const std::function<bool()>& interrupted) const {
  const Posture stands = postureOf(from);
  const Feet feet = feetOf(stands);
  const Posture start = anew == StartFrom::kUpright ? uprightOn(feet, "standing") : stands;
  if (anew == StartFrom::kUpright && !mayReach(start, p_WM)) return {};
  const dvec3 forward = facing_W(from), lateral = glm::cross(dvec3(0.0, 0.0, 1.0), forward);
  const dquat q_WM = movedFrame(configurationOf(start)).q;
  const std::vector<double> yaws =
      anew == StartFrom::kUpright ? std::vector<double>{0.0, kYawTried, -kYawTried} : std::vector<double>{0.0};
  std::vector<std::pair<double, EntityConfiguration>> found;
  for (const double yaw : yaws) {
    for (int i = -kTurnsTried; i <= kTurnsTried; ++i) {
      if (interrupted && interrupted()) return {};
      const dquat pitch = glm::angleAxis(i * std::numbers::pi / (kTurnsTried + 1), lateral);
      const Pose X_WM{p_WM, glm::normalize(turnedLeft(yaw) * pitch * q_WM)};
      const mannequin::PostureResult result = solver_.solve(taskFor(X_WM, feet), start);
      if (result.status != mannequin::PostureStatus::kSolved) continue;
      double cost = 0.0;
      for (const double turn : mannequin::turnsBetween(stands, result.posture)) cost += turn * turn;
      found.emplace_back(cost, configurationOf(result.posture));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<EntityConfiguration> postures;
  for (auto& [cost, posture] : found) postures.push_back(std::move(posture));
  return postures;
}

std::vector<PartDifferential> MannequinManipulator::differentiate(const EntityConfiguration& configuration) const {
  const Pose X_WM = movedFrame(configuration);
  const Feet feet = locks_.may_step ? feetOf(postureOf(configuration)) : X_WF_;
  const auto segments =
      mannequin::differentiateHand(figure(), postureOf(configuration), taskFor(X_WM, feet), driven(), X_WM);
  std::vector<Pose> X_WP(parts().size());
  partPoses(configuration, X_WP);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), postureOf(configuration));
  std::vector<PartDifferential> result;
  for (std::size_t k = 0; k < parts().size(); ++k) {
    const Segment segment = places()[k].segment;
    const bool moved_hand =
        segment == mannequin::armSegment(driven(), Segment::kLeftHand) || (isBoth() && segment == Segment::kRightHand);
    if (moved_hand) {
      result.push_back(rigidDifferential(X_WM.p, X_WP[k].p));
      continue;
    }
    PartDifferential part;
    part.p_WPo = X_WP[k].p;
    const dvec3 arm = X_WP[k].p - pose[segment].p_WS;
    for (std::size_t i = 0; i < 6; ++i) {
      const Twist& twist = segments[mannequin::indexOf(segment)][i];
      part.velocity[i] = {twist.linear + glm::cross(twist.angular, arm), twist.angular};
    }
    result.push_back(part);
  }
  return result;
}

std::optional<double> MannequinManipulator::reachAlong(const dvec3& outward, double ahead, Posture posture,
                                                       const Pose& X_WM) const {
  double reached = 0.0, step = ahead;
  for (int i = 0; i < kProbeTicks && reached < ahead - kReached; ++i) {
    const double wanted = std::min(ahead, reached + step);
    const mannequin::PostureResult result =
        solver_.follow(taskFor({X_WM.p + wanted * outward, X_WM.q}, X_WF_), posture);
    const double now = wanted - errorOf(result);
    if (now > reached + kProgress * step) {
      reached = now;
      posture = result.posture;
      continue;
    }
    // A bold step may fail where the hands' bond would break on the way; that is no end of the reach.
    step *= 0.5;
    if (step < kLeastProbe) return reached;
  }
  return std::nullopt;
}

std::vector<MotionLimit> MannequinManipulator::limits(const EntityConfiguration& configuration, double zone,
                                                      double) const {
  if (locks_.may_step) return {};  // The floor has no end.
  const Posture posture = postureOf(configuration);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(figure(), posture);
  const Pose X_WM = movedFrame(configuration);
  const dvec3 shoulder = pose[mannequin::armSegment(driven(), Segment::kLeftUpperArm)].p_WS;
  const dvec3 hand = mannequin::handPose(pose, driven()).p;
  const double distance = glm::length(hand - shoulder);
  const double arm = figure().upperArmLength() + figure().forearmLength();
  const double ahead = std::min(zone, kProbed);
  // Well bent arms have room.
  if (distance < 1e-6 || (arm - distance > ahead)) return {};
  const dvec3 outward = (hand - shoulder) / distance;
  const std::optional<double> reach = reachAlong(outward, ahead, posture, X_WM);
  if (!reach) return {};
  MotionLimit limit;
  limit.constraint_W.gap = *reach;
  for (std::size_t k = 0; k < 3; ++k) limit.constraint_W.gradient[k] = -outward[static_cast<int>(k)];
  limit.constraint_W.id = 1;
  limit.kind = LimitKind::kReach;
  const Text::Length left{*reach, true};
  limit.text = driven() == Side::kLeft ? Text("The left hand is %1 from the end of its reach", left)
                                       : Text("The right hand is %1 from the end of its reach", left);
  return {limit};
}

}  // namespace hapticell::manipulation
