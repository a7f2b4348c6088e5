// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "manipulation/scene/prepared_scene.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"

namespace hapticell::planning::test {

inline workcell::Entity loaded(const std::string& what, workcell::EntityId id, const std::string& name,
                               const Pose& X_WE) {
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  workcell::Entity entity = *loader.load(what, 0.0, notes);
  entity.id = id;
  entity.name = name;
  entity.X_WE = X_WE;
  if (entity.robot() && entity.joints().empty()) entity.setJoints(kinematics::restPositions(*entity.robot()));
  return entity;
}

/// A link of a mannequin in the world, by the links' own kinematics, which neither planner nor hold uses.
inline Pose linkPose(const workcell::Entity& worker, const manipulation::EntityConfiguration& at, const char* link) {
  std::vector<Pose> X_EL;
  kinematics::forwardKinematics(*worker.robot(), at.joints, X_EL);
  return at.X_WE * X_EL[static_cast<std::size_t>(worker.robot()->findLink(link))];
}

/// The grip of its right hand.
inline Pose gripOf(const workcell::Entity& worker, const manipulation::EntityConfiguration& at) {
  return linkPose(worker, at, "r_hand") * Pose::translation(worker.figure()->p_HandGrip[1]);
}

/// A robot (1) on a plate (4) that its base touches, with a wall (2) on the straight way of its tool; a gripper of a
/// box (3) on its flange.
inline std::shared_ptr<const manipulation::PreparedScene> robotCell(bool with_gripper = false) {
  std::vector<workcell::Entity> entities{loaded("library:ur5e", 1, "robot", {}),
                                         loaded("box:0.6,0.04,0.5", 2, "wall", Pose::translation({-0.65, -0.13, 0.25})),
                                         loaded("box:1.0,1.0,0.1", 4, "plate", Pose::translation({0.0, 0.0, -0.05}))};
  entities.front().setJoints({0.6, -1.2, 1.2, -1.5, -1.5, 0.0});
  if (with_gripper) {
    const auto& robot = entities.front();
    const int tip = robot.robot()->defaultTip();
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
    workcell::Entity gripper = loaded("box:0.05,0.05,0.2", 3, "gripper",
                                      X_BL[static_cast<std::size_t>(tip)] * Pose::translation({0.0, 0.0, 0.14}));
    gripper.attachment.to = "robot";
    gripper.attachment.link = robot.robot()->links[static_cast<std::size_t>(tip)].name;
    entities.push_back(std::move(gripper));
  }
  return manipulation::PreparedScene::prepare(std::move(entities), {}, {});
}

/// A robot on the plate of a rail of 4 m along x, at its one end, and a post as high as the arm beside the way. The rail's bed and plate
/// are boxes; its joint "drive" may move at 0.8 m/s.
struct RailCell {
  std::shared_ptr<const manipulation::PreparedScene> scene;
  workcell::EntityId rail = 0, robot = 0;
};

inline RailCell railCell() {
  workcell::Document document;
  const auto add = [&](workcell::Entity entity) { return document.execute(workcell::AddEntity{std::move(entity)}).value(); };
  const auto bed = add(loaded("box:4.4,0.3,0.1", 0, "bed", Pose::translation({0.0, 0.0, 0.05})));
  const auto plate = add(loaded("box:0.3,0.3,0.2", 0, "plate", Pose::translation({0.0, 0.0, 0.21})));
  workcell::MechanismJoint joint;
  joint.name = "drive";
  joint.type = workcell::MechanismJointType::kPrismatic;
  joint.parent = "bed";
  joint.child = "plate";
  joint.axis_M = dvec3(1.0, 0.0, 0.0);
  joint.lower = -2.0;
  joint.upper = 2.0;
  joint.velocity = 0.8;
  RailCell cell;
  cell.rail = document.execute(workcell::MakeMechanism{"rail", {bed, plate}, {joint}}).value();
  cell.robot = add(loaded("library:ur5e", 0, "robot", Pose::translation({0.0, 0.0, 0.31})));
  EXPECT_TRUE(document.execute(workcell::Attach{cell.robot, cell.rail, "plate"}));
  const auto place = [&](workcell::EntityId id, const std::vector<double>& joints) {
    EXPECT_TRUE(document.execute(workcell::SetConfiguration{id, document.find(id)->X_WE, joints}));
  };
  place(cell.robot, {-1.57, -1.2, 1.2, -1.57, -1.57, 0.0});
  place(cell.rail, {-1.5});
  add(loaded("box:0.3,0.9,2.4", 0, "post", Pose::translation({0.0, 0.7, 1.2})));
  cell.scene = manipulation::PreparedScene::prepare(document.snapshotEntities(), {}, {});
  return cell;
}

/// The tool down beside the far end of the rail.
inline Pose farAlongTheRail() {
  return {{1.5, 0.5, 0.6}, dquat(0.0, 1.0, 0.0, 0.0)};
}

/// A bar (1) 0.2 m long that lies in a box of five plates, open above or with a lid (7); the opening is `width` (m)
/// wide both ways.
inline std::shared_ptr<const manipulation::PreparedScene> boxWithBar(double width, bool has_lid = false) {
  const double wall = 0.02, side = width / 2.0 + wall / 2.0;
  const std::string along = "box:" + std::to_string(wall) + "," + std::to_string(width + 2.0 * wall) + ",0.3";
  const std::string across = "box:" + std::to_string(width + 2.0 * wall) + "," + std::to_string(wall) + ",0.3";
  const std::string floor =
      "box:" + std::to_string(width + 2.0 * wall) + "," + std::to_string(width + 2.0 * wall) + ",0.02";
  std::vector<workcell::Entity> entities{loaded("box:0.2,0.04,0.04", 1, "bar", Pose::translation({0, 0, 0.1})),
                                         loaded(along, 2, "left", Pose::translation({-side, 0, 0.15})),
                                         loaded(along, 3, "right", Pose::translation({side, 0, 0.15})),
                                         loaded(across, 4, "front", Pose::translation({0, -side, 0.15})),
                                         loaded(across, 5, "back", Pose::translation({0, side, 0.15})),
                                         loaded(floor, 6, "floor", Pose::translation({0, 0, -0.01}))};
  if (has_lid) entities.push_back(loaded(floor, 7, "lid", Pose::translation({0, 0, 0.31})));
  return manipulation::PreparedScene::prepare(std::move(entities), {}, {});
}

}  // namespace hapticell::planning::test
