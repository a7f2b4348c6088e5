// SPDX-License-Identifier: Apache-2.0
// Undo and redo of every change that a document knows: one of each kind, from a cell that has something of everything.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "geometry/shapes.h"
#include "workcell/document.h"
#include "workcell/document_io.h"
#include "workcell/mesh_care.h"

namespace hapticell::workcell {
namespace {

Entity solid(const std::string& name, double x) {
  Entity entity;
  entity.name = name;
  entity.mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)));
  entity.source = {"box:0.1,0.1,0.1", 1.0};
  entity.X_WE = Pose::translation({x, 0, 0});
  return entity;
}

Entity arm(const std::string& name) {
  kinematics::RobotModel model;
  model.name = "arm";
  model.links = {{"base", -1, {}, {}}, {"upper", 0, {}, {}}};
  kinematics::Joint joint;
  joint.name = "shoulder";
  joint.type = kinematics::JointType::kRevolute;
  joint.parent_link = 0;
  joint.child_link = 1;
  joint.lower = -1.0;
  joint.upper = 1.0;
  joint.variable = 0;
  model.joints = {joint};
  model.moving = {0};
  Entity entity;
  entity.name = name;
  entity.kind = EntityKind::kRobot;
  entity.robot = std::make_shared<const kinematics::RobotModel>(std::move(model));
  entity.source = {"/robots/arm.urdf", 1.0};
  return entity;
}

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

/// The document's whole state as text: what is saved, and what only the memory holds.
std::string everything(const Document& document) {
  std::string text = documentText(document.state(), "/cell");
  for (const auto& entity : document.state().entities) {
    text += entity->name + " " + std::to_string(entity->id);
    if (entity->mesh) text += " " + std::to_string(entity->mesh->triangles.size());
    for (const double q : entity->joints) text += " " + std::to_string(q);
    text += " " + std::to_string(static_cast<int>(entity->proxy.kind)) + "\n";
  }
  return text;
}

/// Makes a command for the document as it is by then: ids are given as entities come.
using Maker = std::function<Command(const Document&)>;

/// One command of each kind, in an order in which all of them are accepted.
std::vector<Maker> oneOfEach(const Document& document) {
  const auto id = [&](const char* name) { return document.findByName(name)->id; };
  const EntityId table = id("table"), part = id("part"), robot = id("robot");
  Entity finer = solid("other", 0);
  finer.mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeSphere(0.1));
  finer.source = {"sphere:0.1", 1.0};
  ergonomics::WorkTask task;
  task.name = "Screw";
  const std::vector<Command> first{AddEntity{solid("new", 5)},
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
                                   SetCollisionProxy{part, *makeProxy(*finer.mesh, CollisionProxy::Kind::kConvex, 0.0)},
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
                                  RemoveTrajectory{"drill twice"},
                                  SetWorkTask{task},
                                  RemoveWorkTask{"Screw"},
                                  SetView{SavedView{dvec3(1.0), dvec3(0.0)}},
                                  RemoveEntity{table}};
  std::vector<Maker> makers;
  for (const Command& command : first) makers.emplace_back([command](const Document&) { return command; });
  makers.emplace_back([](const Document& now) { return EditMechanism{now.findByName("door")->id, {hinge(0.5)}}; });
  makers.emplace_back([](const Document& now) { return DissolveMechanism{now.findByName("door")->id}; });
  for (const Command& command : last) makers.emplace_back([command](const Document&) { return command; });
  return makers;
}

Document cellOfEverything() {
  Document document;
  for (const Entity& entity :
       {solid("table", 0), solid("part", 1), solid("frame", 2), solid("leaf", 3), arm("robot")}) {
    EXPECT_TRUE(document.execute(AddEntity{entity}));
  }
  return document;
}

TEST(EveryCommand, IsOneStepThatCanBeUndoneAndRedone) {
  Document document = cellOfEverything();
  const std::vector<Maker> commands = oneOfEach(document);
  const std::size_t before = document.undoTexts().size();
  std::set<std::size_t> kinds;
  std::vector<std::string> states{everything(document)};
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const Command command = commands[k](document);
    const auto done = document.execute(command);
    ASSERT_TRUE(done) << k << ": " << done.error().message();
    kinds.insert(command.index());
    EXPECT_EQ(document.undoTexts().size(), before + k + 1) << k;
    EXPECT_FALSE(document.undoText().empty()) << k;
    states.push_back(everything(document));
    EXPECT_NE(states[k + 1], states[k]) << "step " << k << " changed nothing";
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Command>) << "a kind of command is not tried here";
  for (std::size_t k = commands.size(); k > 0; --k) {
    ASSERT_TRUE(document.undo());
    EXPECT_EQ(everything(document), states[k - 1]) << "undoing step " << k - 1;
  }
  for (std::size_t k = 0; k < commands.size(); ++k) {
    ASSERT_TRUE(document.redo());
    EXPECT_EQ(everything(document), states[k + 1]) << "redoing step " << k;
  }
}

}  // namespace
}  // namespace hapticell::workcell
