// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kdl/chain.hpp>

#include "kinematics/model/jacobian.h"

namespace hapticell::bench {

inline KDL::Frame frameOf(const Pose& X) {
  return {KDL::Rotation::Quaternion(X.q.x, X.q.y, X.q.z, X.q.w), KDL::Vector(X.p.x, X.p.y, X.p.z)};
}

/// From the root to the link `tip`.
inline KDL::Chain chainOf(const kinematics::RobotModel& model, int tip) {
  using kinematics::Joint, kinematics::JointType;
  KDL::Chain chain;
  for (const int index : kinematics::chainToTip(model, tip)) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const KDL::Frame X_PJ = frameOf(joint.X_PJ);
    const KDL::Vector axis(joint.axis_J.x, joint.axis_J.y, joint.axis_J.z);
    if (joint.type == JointType::kFixed) {
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), X_PJ));
      continue;
    }
    const auto type = joint.type == JointType::kPrismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    chain.addSegment(KDL::Segment(KDL::Joint(joint.name, X_PJ.p, X_PJ.M * axis, type), X_PJ));
  }
  return chain;
}

}  // namespace hapticell::bench
