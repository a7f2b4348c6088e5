// SPDX-License-Identifier: Apache-2.0
#include "manipulation/mannequin_body.h"

#include <algorithm>
#include <cmath>

#include "geometry/assertion.h"
#include "mannequin/body_shape.h"
#include "mannequin/figure_model.h"

namespace hapticell::manipulation {

using mannequin::Posture;
using mannequin::Segment;

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

void MannequinBody::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
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

double MannequinBody::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  double turned = 0.0;
  for (const double turn : mannequin::turnsBetween(postureOf(from), postureOf(to))) turned += turn;
  return turned;
}

}  // namespace hapticell::manipulation
