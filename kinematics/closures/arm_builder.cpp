// SPDX-License-Identifier: Apache-2.0
#include "kinematics/closures/arm_builder.h"

#include "geometry/system/assertion.h"

namespace hapticell::kinematics {

namespace {

Pose turned(const dvec3& axis, double angle) {
  return {dvec3(0.0), glm::angleAxis(angle, axis)};
}

constexpr dvec3 kX{1.0, 0.0, 0.0}, kY{0.0, 1.0, 0.0}, kZ{0.0, 0.0, 1.0};

}  // namespace

RobotModel buildChain(const std::string& name, const std::vector<ChainJoint>& joints, const Pose& flange) {
  RobotModel model;
  model.name = name;
  model.links.push_back({"base_link", -1, {}, {}});
  for (std::size_t k = 0; k < joints.size(); ++k) {
    Joint joint;
    joint.name = joints[k].data.name;
    joint.type = joints[k].type;
    joint.parent_link = static_cast<int>(k);
    joint.child_link = static_cast<int>(k) + 1;
    joint.X_PJ = joints[k].X_PJ;
    joint.axis_J = joints[k].axis_J;
    joint.lower = joints[k].data.lower;
    joint.upper = joints[k].data.upper;
    joint.velocity = joints[k].data.velocity;
    if (joint.type != JointType::kFixed) {
      joint.variable = static_cast<int>(model.moving.size());
      model.moving.push_back(static_cast<int>(k));
    }
    model.links.push_back({"link_" + std::to_string(k + 1), static_cast<int>(k), {}, {}});
    model.joints.push_back(std::move(joint));
  }
  Joint end;
  end.name = "flange";
  end.parent_link = static_cast<int>(joints.size());
  end.child_link = end.parent_link + 1;
  end.X_PJ = flange;
  model.links.push_back({"tool0", static_cast<int>(joints.size()), {}, {}});
  model.joints.push_back(std::move(end));
  return model;
}

RobotModel buildOpw(const std::string& name, const OpwParameters& p, const std::vector<JointData>& joints) {
  HAPTICELL_DEMAND(joints.size() == 6);
  const dvec3 origins[6] = {{0, 0, 0}, {p.a1, 0, p.c1}, {0, 0, p.c2}, {p.a2, p.b, 0}, {0, 0, p.c3}, {0, 0, 0}};
  const dvec3 axes[6] = {kZ, kY, kY, kZ, kY, kZ};
  std::vector<ChainJoint> chain;
  for (std::size_t k = 0; k < 6; ++k) {
    chain.push_back({joints[k], Pose::translation(origins[k]) * turned(axes[k], -p.offsets[k]), p.signs[k] * axes[k],
                     JointType::kRevolute});
  }
  return buildChain(name, chain, Pose::translation({0, 0, p.c4}));
}

RobotModel buildDh(const std::string& name, DhConvention convention, const std::vector<DhRow>& rows,
                   const std::vector<JointData>& joints, const Pose& flange) {
  HAPTICELL_DEMAND(rows.size() == joints.size());
  std::vector<ChainJoint> chain;
  Pose tail;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const DhRow& row = rows[k];
    const Pose along_x = turned(kX, row.alpha) * Pose::translation({row.a, 0, 0});
    const Pose about_z = turned(kZ, row.theta);
    const Pose along_z = Pose::translation({0, 0, row.d});
    const JointType type = row.prismatic ? JointType::kPrismatic : JointType::kRevolute;
    if (convention == DhConvention::kModified) {
      chain.push_back({joints[k], tail * along_x * about_z * along_z, kZ, type});
      tail = {};
    } else {
      chain.push_back({joints[k], tail * about_z, kZ, type});
      tail = along_z * along_x;
    }
  }
  return buildChain(name, chain, tail * flange);
}

}  // namespace hapticell::kinematics
