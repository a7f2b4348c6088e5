// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/jointed_whole.h"

#include <algorithm>
#include <cmath>

#include "collision/queries/motion_bound.h"
#include "geometry/system/assertion.h"
#include "kinematics/model/link_pose.h"

namespace hapticell::manipulation {

JointedWhole::JointedWhole(std::shared_ptr<const kinematics::RobotModel> model, const Pose& X_EM,
                           std::vector<Part> parts)
    : model_(std::move(model)), X_EM_(X_EM), parts_(std::move(parts)) {
  HAPTICELL_DEMAND(model_ && !model_->closure);
  for (Part& part : parts_) part.link = std::max(0, part.link);
}

Pose JointedWhole::movedFrame(const EntityConfiguration& configuration) const {
  return configuration.X_WE * X_EM_;
}

EntityConfiguration JointedWhole::propose(const EntityConfiguration& from, const Pose& X_WM, double) const {
  return {X_WM * X_EM_.inverse(), from.joints};
}

EntityConfiguration JointedWhole::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                          double s) const {
  EntityConfiguration result{interpolate(movedFrame(from), movedFrame(to), s) * X_EM_.inverse(), from.joints};
  for (std::size_t i = 0; i < result.joints.size(); ++i) result.joints[i] += s * (to.joints[i] - from.joints[i]);
  return result;
}

void JointedWhole::partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const {
  HAPTICELL_DEMAND(X_WP.size() == parts_.size());
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*model_, configuration.joints, X_EL);
  for (std::size_t k = 0; k < X_WP.size(); ++k) {
    X_WP[k] = configuration.X_WE * X_EL[static_cast<std::size_t>(parts_[k].link)] * parts_[k].X_LP;
  }
}

Pose JointedWhole::partPose(const EntityConfiguration& configuration, std::size_t part) const {
  return configuration.X_WE * kinematics::linkPose(*model_, configuration.joints, parts_[part].link) *
         parts_[part].X_LP;
}

double JointedWhole::stepOf(const kinematics::Joint& joint, const EntityConfiguration& from,
                            const EntityConfiguration& to) const {
  return std::abs(kinematics::jointPosition(*model_, to.joints, joint) -
                  kinematics::jointPosition(*model_, from.joints, joint));
}

void JointedWhole::pathBounds(const EntityConfiguration& from, const EntityConfiguration& to,
                              std::span<const PartSphere> spheres, std::span<double> bounds) const {
  HAPTICELL_DEMAND(spheres.size() == parts_.size() && bounds.size() == parts_.size());
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*model_, from.joints, X_EL);
  const Pose X_WM0 = movedFrame(from), X_WM1 = movedFrame(to), X_ME = X_EM_.inverse();
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const dvec3 center_E = X_EL[static_cast<std::size_t>(parts_[k].link)] * (parts_[k].X_LP * spheres[k].p_PS);
    // From the link inwards: seen from a joint a point moves as far as the joints beyond it take it.
    double own = 0.0;
    for (int at = model_->links[static_cast<std::size_t>(parts_[k].link)].parent_joint; at >= 0;) {
      const kinematics::Joint& joint = model_->joints[static_cast<std::size_t>(at)];
      const double step = stepOf(joint, from, to);
      if (step > 0.0) {
        const double lever =
            glm::length(center_E - X_EL[static_cast<std::size_t>(joint.child_link)].p) + spheres[k].radius + own;
        own += joint.type == kinematics::JointType::kPrismatic ? step : step * lever;
      }
      at = model_->links[static_cast<std::size_t>(joint.parent_link)].parent_joint;
    }
    bounds[k] = own + collision::pathBound(X_WM0, X_WM1, X_ME * center_E, spheres[k].radius + own);
  }
}

double JointedWhole::turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const {
  double turned = glm::length(difference(to.X_WE, from.X_WE).angular);
  for (const kinematics::Joint& joint : model_->joints) {
    if (joint.type != kinematics::JointType::kPrismatic) turned += stepOf(joint, from, to);
  }
  return turned;
}

std::vector<PartDifferential> JointedWhole::differentiate(const EntityConfiguration& configuration) const {
  std::vector<Pose> X_WP(parts_.size());
  partPoses(configuration, X_WP);
  const dvec3 p_WMo = movedFrame(configuration).p;
  std::vector<PartDifferential> parts;
  parts.reserve(parts_.size());
  for (const Pose& pose : X_WP) parts.push_back(rigidDifferential(p_WMo, pose.p));
  return parts;
}

}  // namespace hapticell::manipulation
