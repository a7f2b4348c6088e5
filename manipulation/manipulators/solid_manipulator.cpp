// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/solid_manipulator.h"

#include "collision/queries/motion_bound.h"
#include "geometry/system/assertion.h"

namespace hapticell::manipulation {

SolidManipulator::SolidManipulator(const Pose& X_EM, std::vector<Pose> X_EP) : X_EM_(X_EM), X_EP_(std::move(X_EP)) {}

Pose SolidManipulator::movedFrame(const EntityConfiguration& configuration) const {
  return configuration.X_WE * X_EM_;
}

EntityConfiguration SolidManipulator::propose(const EntityConfiguration& from, const Pose& X_WM,
                                              double /*duration_s*/) const {
  return {X_WM * X_EM_.inverse(), from.joints};
}

EntityConfiguration SolidManipulator::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                              double s) const {
  // The moved frame's origin goes straight, so that this is the motion the hand's own interpolation means.
  const Pose X_WM = interpolate(movedFrame(from), movedFrame(to), s);
  return {X_WM * X_EM_.inverse(), from.joints};
}

void SolidManipulator::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  HAPTICELL_DEMAND(X_WP.size() == X_EP_.size());
  for (std::size_t k = 0; k < X_WP.size(); ++k) X_WP[k] = configuration.X_WE * X_EP_[k];
}

Pose SolidManipulator::partPose(const EntityConfiguration& configuration, std::size_t part) const {
  return configuration.X_WE * X_EP_[part];
}

void SolidManipulator::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                                  std::span<const PartSphere> spheres, std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == X_EP_.size() && bounds.size() == X_EP_.size());
  const Pose X_WM0 = movedFrame(from), X_WM1 = movedFrame(to), X_ME = X_EM_.inverse();
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const dvec3 p_MS = X_ME * (X_EP_[k] * spheres[k].p_PS);
    bounds[k] = collision::pathBound(X_WM0, X_WM1, p_MS, spheres[k].radius);
  }
}

double SolidManipulator::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  return glm::length(difference(to.X_WE, from.X_WE).angular);
}

std::vector<PartDifferential> SolidManipulator::differentiate(const EntityConfiguration& configuration) const {
  std::vector<PartDifferential> parts;
  parts.reserve(X_EP_.size());
  const dvec3 p_WMo = movedFrame(configuration).p;
  for (const Pose& X_EP : X_EP_) parts.push_back(rigidDifferential(p_WMo, (configuration.X_WE * X_EP).p));
  return parts;
}

std::vector<MotionLimit> SolidManipulator::limits(const EntityConfiguration&, double, double) const {
  return {};
}

}  // namespace hapticell::manipulation
