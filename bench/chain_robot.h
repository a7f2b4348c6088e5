// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "bench/collision_scenes.h"
#include "kinematics/model/robot_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::bench {

/// The chain's seven links as a robot with joints about z and y in turn, entity 1.
inline workcell::Entity chainRobot(const Chain& chain) {
  kinematics::RobotModel model;
  model.name = "chain";
  kinematics::Link root;
  root.name = "root";
  model.links.push_back(root);
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    kinematics::Joint joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = kinematics::JointType::kRevolute;
    joint.parent_link = static_cast<int>(i);
    joint.child_link = static_cast<int>(i) + 1;
    joint.X_PJ = Pose::translation({0, 0, i == 0 ? 0.0 : 0.26});
    joint.axis_J = i % 2 == 0 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
    joint.lower = -2.8;
    joint.upper = 2.8;
    joint.velocity = 3.0;
    joint.variable = static_cast<int>(i);
    kinematics::Link link;
    link.name = "link" + std::to_string(i);
    link.parent_joint = static_cast<int>(i);
    link.collisions.push_back({std::make_shared<const geometry::TriangleMesh>(chain.links[i]), {}, {}, ""});
    model.moving.push_back(static_cast<int>(i));
    model.joints.push_back(joint);
    model.links.push_back(std::move(link));
  }
  workcell::Entity entity;
  entity.id = 1;
  entity.name = "robot";
  entity.body = workcell::Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model)),
                                 .joints = {0.3, 0.4, 0.2, 0.5, 0.1, 0.4, 0.0}}};
  return entity;
}

}  // namespace hapticell::bench
