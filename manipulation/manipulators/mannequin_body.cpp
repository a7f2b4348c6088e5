// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/mannequin_body.h"

#include <algorithm>
#include <cmath>

#include "geometry/system/assertion.h"
#include "kinematics/model/link_pose.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {

using mannequin::Posture;
using mannequin::Segment;

namespace {

/// The segments from this one to the root, itself first.
std::vector<Segment> chainOf(Segment segment) {
  std::vector<Segment> chain{segment};
  while (const auto parent = mannequin::segmentInfo(chain.back()).parent) chain.push_back(*parent);
  return chain;
}

/// The most that a joint of a finger turns, of either hand.
double fingersBetween(const Posture& a, const Posture& b) {
  using mannequin::Dof;
  double most = 0.0;
  for (const Dof dof : {Dof::kLeftFingersCurl, Dof::kLeftThumbFlexion, Dof::kLeftThumbAbduction, Dof::kRightFingersCurl,
                        Dof::kRightThumbFlexion, Dof::kRightThumbAbduction}) {
    most = std::max(most, std::abs(b[dof] - a[dof]));
  }
  return most;
}

}  // namespace

MannequinBody::MannequinBody(std::shared_ptr<const mannequin::Figure> figure,
                             std::shared_ptr<const kinematics::RobotModel> model, std::vector<Part> parts)
    : figure_(std::move(figure)), model_(std::move(model)), parts_(std::move(parts)) {
  for (const Part& part : parts_) {
    PartPlace place;
    std::size_t body = static_cast<std::size_t>(std::max(0, mannequin::bodyOfLink(*model_, std::max(0, part.link))));
    for (; body >= mannequin::kSegmentCount; body = mannequin::parentBody(body)) ++place.phalanges;
    place.segment = static_cast<Segment>(body);
    places_.push_back(place);
  }
}

Posture MannequinBody::postureOf(const EntityConfiguration& configuration) const {
  return mannequin::toPosture(*figure_, {configuration.X_WE, configuration.joints});
}

EntityConfiguration MannequinBody::configurationOf(const Posture& posture) const {
  mannequin::ModelConfiguration model = mannequin::toModel(*figure_, posture);
  return {model.X_WE, std::move(model.joints)};
}

EntityConfiguration MannequinBody::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                           double s) const {
  return configurationOf(mannequin::interpolate(postureOf(from), postureOf(to), s));
}

void MannequinBody::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  HAPTICELL_DEMAND(X_WP.size() == parts_.size());
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*model_, configuration.joints, X_EL);
  for (std::size_t k = 0; k < X_WP.size(); ++k) {
    X_WP[k] = configuration.X_WE * X_EL[static_cast<std::size_t>(std::max(0, parts_[k].link))] * parts_[k].X_LP;
  }
}

Pose MannequinBody::partPose(const EntityConfiguration& configuration, std::size_t part) const {
  const int link = std::max(0, parts_[part].link);
  return configuration.X_WE * kinematics::linkPose(*model_, configuration.joints, link) * parts_[part].X_LP;
}

void MannequinBody::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                               std::span<const PartSphere> spheres, std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == parts_.size() && bounds.size() == parts_.size());
  const Posture start = postureOf(from), end = postureOf(to);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, start);
  const auto turns = mannequin::turnsBetween(start, end);
  const double slid = glm::length(end.X_WR.p - start.X_WR.p);
  const double fingers = fingersBetween(start, end);
  std::vector<Pose> X_WP(parts_.size());
  partPoses(from, X_WP);
  // From the part inwards: a point moves, seen from a joint, as far as the joints beyond it take it, so its distance
  // from that joint grows by no more than that.
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const dvec3 centre = X_WP[k] * spheres[k].p_PS;
    bounds[k] = fingers * places_[k].phalanges * (spheres[k].radius + 0.1);
    for (Segment s = places_[k].segment;; s = *mannequin::segmentInfo(s).parent) {
      const double lever = glm::length(centre - pose[s].p_WS) + spheres[k].radius + bounds[k];
      bounds[k] += turns[mannequin::indexOf(s)] * lever;
      if (!mannequin::segmentInfo(s).parent) break;
    }
    bounds[k] += slid;
  }
}

void MannequinBody::tightenOwnBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                     std::span<const PartSphere> spheres, std::span<const OwnPair> pairs,
                                     std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == parts_.size() && bounds.size() == pairs.size());
  const Posture start = postureOf(from), end = postureOf(to);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, start);
  const auto turns = mannequin::turnsBetween(start, end);
  const double fingers = fingersBetween(start, end);
  std::vector<Pose> X_WP(parts_.size());
  partPoses(from, X_WP);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const OwnPair& pair = pairs[i];
    const PartPlace &near = places_[pair.part], &far = places_[pair.other];
    const dvec3 centre = X_WP[pair.other] * spheres[pair.other].p_PS;
    const double radius = spheres[pair.other].radius;
    // From the other part inwards to where both hang, then outwards again: every joint between turns its points, with
    // the lever that it has to them (see pathBounds()).
    double bound = fingers * far.phalanges * (radius + 0.1);
    const auto turn = [&](Segment s) {
      bound += turns[mannequin::indexOf(s)] * (glm::length(centre - pose[s].p_WS) + radius + bound);
    };
    const std::vector<Segment> inwards = chainOf(far.segment), outwards = chainOf(near.segment);
    std::size_t shared = 0;
    while (shared < inwards.size() && shared < outwards.size() &&
           inwards[inwards.size() - 1 - shared] == outwards[outwards.size() - 1 - shared]) {
      ++shared;
    }
    for (std::size_t k = 0; k + shared < inwards.size(); ++k) turn(inwards[k]);
    for (std::size_t k = outwards.size() - shared; k-- > 0;) turn(outwards[k]);
    const dvec3 seen_from = X_WP[pair.part] * spheres[pair.part].p_PS;
    const double reach = glm::length(centre - seen_from) + radius + spheres[pair.part].radius + 0.1;
    bound += fingers * near.phalanges * (reach + bound);
    bounds[i] = std::min(bounds[i], bound);
  }
}

double MannequinBody::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  const Posture start = postureOf(from), end = postureOf(to);
  double turned = 3.0 * fingersBetween(start, end);
  for (const double turn : mannequin::turnsBetween(start, end)) turned += turn;
  return turned;
}

}  // namespace hapticell::manipulation
