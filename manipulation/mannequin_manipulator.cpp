// SPDX-License-Identifier: Apache-2.0
#include "manipulation/mannequin_manipulator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/assertion.h"
#include "mannequin/body_shape.h"
#include "mannequin/figure_model.h"
#include "mannequin/hand_differential.h"

namespace hapticell::manipulation {

namespace {

using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

constexpr int kMostTicks = 12;     ///< Of the solver for one proposal; each turns joints by 1.8 deg at most.
constexpr int kProbeTicks = 16;    ///< To find out how far the reach goes.
constexpr double kArrived = 2e-5;  ///< m

double errorOf(const mannequin::PostureResult& result) {
  return std::max({result.hand_position_error[0], result.hand_position_error[1], 0.1 * result.hand_orientation_error[0],
                   0.1 * result.hand_orientation_error[1]});
}

}  // namespace

MannequinManipulator::MannequinManipulator(std::shared_ptr<const mannequin::Figure> figure,
                                           std::shared_ptr<const kinematics::RobotModel> model, Hands hands,
                                           const Locks& locks, const EntityConfiguration& taken,
                                           std::vector<Part> parts)
    : figure_(std::move(figure)),
      model_(std::move(model)),
      solver_(*figure_),
      hands_(hands),
      locks_(locks),
      parts_(std::move(parts)) {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, postureOf(taken));
  const Pose left = mannequin::handPose(pose, Side::kLeft), right = mannequin::handPose(pose, Side::kRight);
  const std::array<Pose, 2> hand = {left, right};
  Pose X_WM = hand[static_cast<std::size_t>(driven())];
  if (hands_ == Hands::kBoth) {
    X_WM.p = 0.5 * (left.p + right.p);
  } else {
    X_WM.p = X_WM * figure_->p_HandGrip[static_cast<std::size_t>(driven())];
  }
  for (std::size_t i = 0; i < 2; ++i) X_MH_[i] = X_WM.inverse() * hand[i];
  X_WF_ = {mannequin::footPose(pose, Side::kLeft), mannequin::footPose(pose, Side::kRight)};
  for (const Part& part : parts_) {
    PartPlace place;
    std::size_t body = static_cast<std::size_t>(std::max(0, mannequin::bodyOfLink(*model_, std::max(0, part.link))));
    for (; body >= mannequin::kSegmentCount; body = mannequin::parentBody(body)) ++place.phalanges;
    place.segment = static_cast<Segment>(body);
    places_.push_back(place);
  }
}

Side MannequinManipulator::driven() const {
  return hands_ == Hands::kRight ? Side::kRight : Side::kLeft;
}

Posture MannequinManipulator::postureOf(const EntityConfiguration& configuration) const {
  return mannequin::toPosture(*figure_, {configuration.X_WE, configuration.joints});
}

EntityConfiguration MannequinManipulator::configurationOf(const Posture& posture) const {
  mannequin::ModelConfiguration model = mannequin::toModel(*figure_, posture);
  return {model.X_WE, std::move(model.joints)};
}

mannequin::PostureTask MannequinManipulator::taskFor(const Pose& X_WM) const {
  mannequin::PostureTask task;
  task.trunk_locked = locks_.trunk;
  task.pelvis_locked = locks_.pelvis;
  task.feet = {X_WF_[0], X_WF_[1]};
  if (hands_ == Hands::kBoth) {
    task.held = mannequin::HeldObject{X_WM, X_MH_};
  } else {
    task.hands[static_cast<std::size_t>(driven())] = X_WM * X_MH_[static_cast<std::size_t>(driven())];
  }
  return task;
}

Pose MannequinManipulator::movedFrame(const EntityConfiguration& configuration) const {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, postureOf(configuration));
  return mannequin::handPose(pose, driven()) * X_MH_[static_cast<std::size_t>(driven())].inverse();
}

EntityConfiguration MannequinManipulator::propose(const EntityConfiguration& from, const Pose& X_WM,
                                                  double /*duration_s*/) const {
  const mannequin::PostureTask task = taskFor(X_WM);
  Posture posture = postureOf(from);
  double before = 1e9;
  for (int i = 0; i < kMostTicks; ++i) {
    const mannequin::PostureResult result = solver_.follow(task, posture);
    posture = result.posture;
    const double error = errorOf(result);
    if (error < kArrived || error > 0.999 * before) break;
    before = error;
  }
  return configurationOf(posture);
}

EntityConfiguration MannequinManipulator::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                                  double s) const {
  return configurationOf(mannequin::interpolate(postureOf(from), postureOf(to), s));
}

void MannequinManipulator::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  HAPTICELL_DEMAND(X_WP.size() == parts_.size());
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*model_, configuration.joints, X_EL);
  for (std::size_t k = 0; k < X_WP.size(); ++k) {
    X_WP[k] = configuration.X_WE * X_EL[static_cast<std::size_t>(std::max(0, parts_[k].link))] * parts_[k].X_LP;
  }
}

void MannequinManipulator::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                      std::span<const PartSphere> spheres, std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == parts_.size() && bounds.size() == parts_.size());
  const Posture start = postureOf(from), end = postureOf(to);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, start);
  const auto turns = mannequin::turnsBetween(start, end);
  const double slid = glm::length(end.X_WR.p - start.X_WR.p);
  const double fingers = std::abs(end[mannequin::Dof::kLeftFingersCurl] - start[mannequin::Dof::kLeftFingersCurl]);
  double turned = fingers;
  for (const double turn : turns) turned += turn;
  std::vector<Pose> X_WP(parts_.size());
  partPoses(from, X_WP);
  // A point turns about a joint with the lever it has at the start, plus what both may come apart meanwhile.
  const double loose = 2.0 * (slid + 2.0 * turned * figure_->body[mannequin::Dimension::kStature]);
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const dvec3 centre = X_WP[k] * spheres[k].p_PS;
    bounds[k] = slid + fingers * places_[k].phalanges * (spheres[k].radius + 0.1);
    for (Segment s = places_[k].segment;; s = *mannequin::segmentInfo(s).parent) {
      const double lever = glm::length(centre - pose[s].p_WS) + spheres[k].radius + loose;
      bounds[k] += turns[mannequin::indexOf(s)] * lever;
      if (!mannequin::segmentInfo(s).parent) break;
    }
  }
}

double MannequinManipulator::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  double turned = 0.0;
  for (const double turn : mannequin::turnsBetween(postureOf(from), postureOf(to))) turned += turn;
  return turned;
}

std::vector<PartDifferential> MannequinManipulator::differentiate(const EntityConfiguration& configuration) const {
  const Pose X_WM = movedFrame(configuration);
  const auto segments = mannequin::differentiateHand(*figure_, postureOf(configuration), taskFor(X_WM), driven(), X_WM);
  std::vector<Pose> X_WP(parts_.size());
  partPoses(configuration, X_WP);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, postureOf(configuration));
  std::vector<PartDifferential> parts;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Segment segment = places_[k].segment;
    const bool moved_hand = segment == mannequin::armSegment(driven(), Segment::kLeftHand) ||
                            (hands_ == Hands::kBoth && segment == Segment::kRightHand);
    if (moved_hand) {
      parts.push_back(rigidDifferential(X_WM.p, X_WP[k].p));
      continue;
    }
    PartDifferential part;
    part.p_WPo = X_WP[k].p;
    const dvec3 arm = X_WP[k].p - pose[segment].p_WS;
    for (std::size_t i = 0; i < 6; ++i) {
      const Twist& twist = segments[mannequin::indexOf(segment)][i];
      part.velocity[i] = {twist.linear + glm::cross(twist.angular, arm), twist.angular};
    }
    parts.push_back(part);
  }
  return parts;
}

std::vector<MotionLimit> MannequinManipulator::limits(const EntityConfiguration& configuration, double zone,
                                                      double) const {
  const Posture posture = postureOf(configuration);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, posture);
  const Pose X_WM = movedFrame(configuration);
  const dvec3 shoulder = pose[mannequin::armSegment(driven(), Segment::kLeftUpperArm)].p_WS;
  const dvec3 hand = mannequin::handPose(pose, driven()).p;
  const double distance = glm::length(hand - shoulder);
  const double arm = figure_->upperArmLength() + figure_->forearmLength();
  // Well bent arms have room.
  if (distance < 1e-6 || (arm - distance > zone)) return {};
  const dvec3 outward = (hand - shoulder) / distance;
  Pose probe = X_WM;
  probe.p += zone * outward;
  const mannequin::PostureTask task = taskFor(probe);
  Posture reached = posture;
  double missing = zone;
  for (int i = 0; i < kProbeTicks && missing > 1e-4; ++i) {
    const mannequin::PostureResult result = solver_.follow(task, reached);
    const double now = errorOf(result);
    if (now > 0.995 * missing && i > 0) break;
    missing = std::min(missing, now);
    reached = result.posture;
  }
  if (missing <= 1e-3) return {};
  MotionLimit limit;
  limit.constraint_W.gap = std::max(0.0, zone - missing);
  for (std::size_t k = 0; k < 3; ++k) limit.constraint_W.gradient[k] = -outward[static_cast<int>(k)];
  limit.constraint_W.id = 1;
  limit.kind = LimitKind::kReach;
  char text[120];
  std::snprintf(text, sizeof text, "The %s hand is %.0f mm from the end of its reach",
                driven() == Side::kLeft ? "left" : "right", 1000.0 * limit.constraint_W.gap);
  limit.text = text;
  return {limit};
}

}  // namespace hapticell::manipulation
