// SPDX-License-Identifier: Apache-2.0
#include "tests/workcell/document/every_command.h"

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "workcell/format/document_io.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::test {

using namespace workcell;

Entity makeSolid(const std::string& name, double x) {
  Entity entity;
  entity.name = name;
  entity.body = Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)))};
  entity.source = {"box:0.1,0.1,0.1", 1.0};
  entity.X_WE = Pose::translation({x, 0, 0});
  return entity;
}

Entity makeArm(const std::string& name, double lower) {
  kinematics::RobotModel model;
  model.name = "arm";
  model.links = {{"base", -1, {}, {}}, {"upper", 0, {}, {}}};
  kinematics::Joint joint;
  joint.name = "shoulder";
  joint.type = kinematics::JointType::kRevolute;
  joint.parent_link = 0;
  joint.child_link = 1;
  joint.lower = lower;
  joint.upper = 1.0;
  joint.variable = 0;
  model.joints = {joint};
  model.moving = {0};
  Entity entity;
  entity.name = name;
  entity.body = Robot{{.model = std::make_shared<const kinematics::RobotModel>(std::move(model))}};
  entity.source = {"/robots/arm.urdf", 1.0};
  return entity;
}

namespace {

MechanismJoint hinge(double upper) {
  MechanismJoint joint;
  joint.name = "hinge";
  joint.parent = "frame";
  joint.child = "leaf";
  joint.upper = upper;
  return joint;
}

Guide guideOf(const std::string& name, double radius) {
  Guide guide;
  guide.name = name;
  guide.kind = GuideKind::kCircle;
  guide.entity = "table";
  guide.radius = radius;
  return guide;
}

}  // namespace

std::string everything(const Document& document) {
  std::string text = documentText(document.state(), "/cell");
  for (const auto& entity : document.state().entities) {
    text += entity->name + " " + std::to_string(entity->id);
    if (entity->mesh()) text += " " + std::to_string(entity->mesh()->triangles.size());
    for (const double q : entity->joints()) text += " " + std::to_string(q);
    text += " " + std::to_string(static_cast<int>(entity->proxy().kind)) + "\n";
  }
  return text;
}

std::vector<CommandMaker> oneOfEach(const Document& document) {
  const auto id = [&](const char* name) { return document.findByName(name)->id; };
  const EntityId table = id("table"), part = id("part"), robot = id("robot");
  Entity finer = makeSolid("other", 0);
  finer.body = Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(0.1))};
  finer.source = {"sphere:0.1", 1.0};
  ergonomics::WorkTask task;
  task.name = "Screw";
  const std::vector<Command> first{
      AddEntity{makeSolid("new", 5)},
      RenameEntity{table, "bench"},
      RenameEntity{table, "table"},
      SetPlacement{part, Pose::translation({0, 0, 3})},
      SetJoints{robot, {0.4}},
      SetConfiguration{robot, Pose::translation({0, 2, 0}), {-0.3}},
      SetProperties{.id = part, .color = std::array<float, 3>{0.1f, 0.2f, 0.3f}},
      SetProperties{.id = part, .visible = false},
      SetProperties{.id = part, .checked = false},
      SetProperties{.id = part, .on_contact = OnContact::kStop},
      SetProperties{.id = part, .force_class = ForceClass::kConstant},
      SetProperties{.id = part, .material = "rubber"},
      SetProperties{.id = part, .mass = 7.0},
      SetProperties{.id = part, .parent = "table"},
      SetProperties{.id = part, .locked = true},
      SetProperties{.id = part, .locked = false},
      SetFrames{part, {{"grip", Pose::translation({0, 0, 0.1})}}},
      SetTools{robot, {{"gun", "upper", Pose::translation({0, 0, 0.2})}}},
      ChooseTool{robot, "gun"},
      SetTool{robot, "base", Pose::translation({0.1, 0, 0})},
      SetNamedPoses{robot, {{"away", {0.9}}}},
      ReplaceShape{part, finer},
      SetCollisionProxy{part, *makeProxy(*finer.mesh(), CollisionProxy::Kind::kConvex, 0.0)},
      Attach{part, robot, "upper"},
      Detach{part},
      MakeMechanism{"door", {id("frame"), id("leaf")}, {hinge(1.0)}}};
  const std::vector<Command> last{AddPairSet{{.name = "Set", .first = {"part"}, .second = {"table"}}},
                                  EditPairSet{"Set", {.name = "Set 2", .first = {"part"}, .near_miss = 0.02}},
                                  SetPairRules{{{.first = "part", .second = "table", .checked = false}}},
                                  RemovePairSet{"Set 2"},
                                  AddGuide{guideOf("ring", 0.1)},
                                  EditGuide{"ring", guideOf("wide ring", 0.2)},
                                  RemoveGuide{"wide ring"},
                                  AddTrajectory{{"drill", "/cell/drill.htraj"}},
                                  RenameTrajectory{"drill", "drill twice"},
                                  SetTrajectory{"drill twice", {"drill deeper", "/cell/drill-2.htraj"}},
                                  RemoveTrajectory{"drill deeper"},
                                  SetWorkTask{task},
                                  RemoveWorkTask{"Screw"},
                                  SetView{SavedView{dvec3(1.0), dvec3(0.0)}},
                                  RemoveEntity{table}};
  std::vector<CommandMaker> makers;
  for (const Command& command : first) makers.emplace_back([command](const Document&) { return command; });
  makers.emplace_back([](const Document& now) { return EditMechanism{now.findByName("door")->id, {hinge(0.5)}}; });
  makers.emplace_back([](const Document& now) { return DissolveMechanism{now.findByName("door")->id}; });
  for (const Command& command : last) makers.emplace_back([command](const Document&) { return command; });
  return makers;
}

Document cellOfEverything() {
  Document document;
  for (const Entity& entity :
       {makeSolid("table", 0), makeSolid("part", 1), makeSolid("frame", 2), makeSolid("leaf", 3), makeArm("robot")}) {
    EXPECT_TRUE(document.execute(AddEntity{entity}));
  }
  return document;
}

}  // namespace hapticell::test
