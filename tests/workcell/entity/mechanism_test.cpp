// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/mechanism.h"
#include "workcell/entity/named_poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Entity solid(const std::string& name, const dvec3& p, const std::string& what = "box:0.1,0.1,0.1") {
  Diagnostics notes;
  Entity entity = EntityLoader(".").load(what, 1.0, notes).value();
  entity.name = name;
  entity.X_WE = Pose::translation(p);
  return entity;
}

MechanismPart part(const std::string& name, const dvec3& p) {
  return {name,
          {"box:0.1,0.1,0.1", 1.0},
          std::make_shared<geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1))),
          Pose::translation(p)};
}

MechanismJoint joint(const std::string& name, MechanismJointType type, const std::string& parent,
                     const std::string& child, const dvec3& point, const dvec3& axis) {
  MechanismJoint made;
  made.name = name;
  made.type = type;
  made.parent = parent;
  made.child = child;
  made.p_MJ = point;
  made.axis_M = axis;
  made.lower = -1.0;
  made.upper = 2.0;
  return made;
}

Pose poseOf(const kinematics::RobotModel& model, const std::vector<double>& q, const std::string& link) {
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(model, q, X_BL);
  return X_BL[static_cast<std::size_t>(model.findLink(link))];
}

TEST(Mechanism, ADoorTurnsAboutItsHingeAndNotItsOrigin) {
  const MechanismDefinition door{
      {part("frame", {0, 0, 0}), part("leaf", {0.5, 0, 0})},
      {joint("hinge", MechanismJointType::kRevolute, "frame", "leaf", {0.1, 0, 0}, {0, 0, 2})}};
  const auto model = buildMechanism("door", door);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->dof(), 1u);
  EXPECT_EQ(model->links[static_cast<std::size_t>(model->defaultTip())].name, "leaf");
  const Pose X = poseOf(*model, {std::numbers::pi / 2}, "leaf");
  EXPECT_NEAR(glm::length(X.p - dvec3(0.1, 0.4, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(X.rotate({1, 0, 0}) - dvec3(0, 1, 0)), 0.0, 1e-12);
}

TEST(Mechanism, AScrewSlidesByItsPitchATurnAndACoupledJointFollows) {
  auto screw = joint("spindle", MechanismJointType::kScrew, "frame", "nut", {0, 0.2, 0}, {0, 0, 1});
  screw.pitch = 0.005;
  screw.lower = -kInfinity;
  screw.upper = kInfinity;
  auto jaw = joint("jaw", MechanismJointType::kPrismatic, "frame", "jaw", {0, 0, 0}, {1, 0, 0});
  jaw.coupling = JointCoupling{"spindle", -0.01, 0.02};
  const MechanismDefinition vice{{part("frame", {0, 0, 0}), part("nut", {0, 0.2, 0}), part("jaw", {0.3, 0, 0})},
                                 {jaw, screw}};
  const auto model = buildMechanism("vice", vice);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_EQ(model->dof(), 1u);
  const Pose nut = poseOf(*model, {4.0 * std::numbers::pi}, "nut");
  EXPECT_NEAR(nut.p.z, 0.010, 1e-12);
  EXPECT_NEAR(glm::length(rotationVector(nut.q)), 0.0, 1e-9);
  EXPECT_NEAR(poseOf(*model, {4.0 * std::numbers::pi}, "jaw").p.x, 0.3 - 0.04 * std::numbers::pi + 0.02, 1e-12);
}

// A parallelogram: the coupler stays parallel to the ground and circles; known in closed form.
TEST(Mechanism, AFourBarClosesItsLoop) {
  const MechanismDefinition bars{
      {part("ground", {0, 0, 0}), part("crank", {0, 0, 0.1}), part("rocker", {0.4, 0, 0.1}),
       part("coupler", {0.2, 0, 0.2})},
      {joint("a", MechanismJointType::kRevolute, "ground", "crank", {0, 0, 0}, {0, 1, 0}),
       joint("b", MechanismJointType::kRevolute, "ground", "rocker", {0.4, 0, 0}, {0, 1, 0}),
       joint("c", MechanismJointType::kRevolute, "crank", "coupler", {0, 0, 0.2}, {0, 1, 0}),
       joint("d", MechanismJointType::kRevolute, "rocker", "coupler", {0.4, 0, 0.2}, {0, 1, 0})}};
  const auto model = buildMechanism("bars", bars);
  ASSERT_TRUE(model) << model.error().message();
  ASSERT_TRUE(model->closure);
  ASSERT_EQ(model->dof(), 1u);
  for (const double angle : {-0.9, -0.3, 0.0, 0.4, 1.1}) {
    const Pose X = poseOf(*model, {angle}, "coupler");
    EXPECT_NEAR(glm::length(X.p - dvec3(0.2 + 0.2 * std::sin(angle), 0.0, 0.2 * std::cos(angle))), 0.0, 1e-9) << angle;
    EXPECT_NEAR(glm::length(rotationVector(X.q)), 0.0, 1e-9);
  }
}

struct Fault {
  const char* what;
  const char* said;
  void (*spoil)(MechanismDefinition&);
};

TEST(Mechanism, FaultsAreNamedInOneSentence) {
  const MechanismDefinition sound{
      {part("frame", {0, 0, 0}), part("leaf", {0.5, 0, 0})},
      {joint("hinge", MechanismJointType::kRevolute, "frame", "leaf", {0, 0, 0}, {0, 0, 1})}};
  const Fault faults[] = {
      {"hinge", "axis of length zero", [](auto& d) { d.joints[0].axis_M = dvec3(0.0); }},
      {"hinge", "above its upper", [](auto& d) { std::swap(d.joints[0].lower, d.joints[0].upper); }},
      {"hinge", "no part is named 'door'", [](auto& d) { d.joints[0].child = "door"; }},
      {"hinge", "to itself", [](auto& d) { d.joints[0].child = "frame"; }},
      {"hinge", "without pitch", [](auto& d) { d.joints[0].type = MechanismJointType::kScrew; }},
      {"hinge", "leads back to itself", [](auto& d) { d.joints[0].coupling = JointCoupling{"hinge"}; }},
      {"hinge", "'latch', which does not exist", [](auto& d) { d.joints[0].coupling = JointCoupling{"latch"}; }},
      {"leaf", "no joint connects it", [](auto& d) { d.joints.clear(); }},
      {"leaf", "used twice", [](auto& d) { d.parts[0].name = "leaf"; }},
      {"door", "no parts", [](auto& d) { d = {}; }},
  };
  for (const Fault& fault : faults) {
    MechanismDefinition spoilt = sound;
    fault.spoil(spoilt);
    const auto model = buildMechanism("door", spoilt);
    ASSERT_FALSE(model) << fault.said;
    EXPECT_NE(model.error().message().find(fault.said), std::string::npos) << model.error().message();
    EXPECT_NE(model.error().message().find(fault.what), std::string::npos) << model.error().message();
  }
}

TEST(MechanismCommands, MakingMovingAndTakingApartCanBeUndone) {
  Document document;
  const EntityId frame = document.execute(AddEntity{solid("frame", {1, 0, 0})}).value();
  const EntityId leaf = document.execute(AddEntity{solid("leaf", {1.5, 0, 0})}).value();
  document.execute(AddEntity{solid("table", {3, 0, 0})}).value();
  document.execute(AddPairSet{{"Set 1", true, {"leaf"}, {"table"}}}).value();
  const auto hinge = joint("hinge", MechanismJointType::kRevolute, "frame", "leaf", {1.1, 0, 0}, {0, 0, 1});
  const auto door = document.execute(MakeMechanism{"door", {frame, leaf}, {hinge}});
  ASSERT_TRUE(door) << door.error().message();
  EXPECT_EQ(document.state().entities.size(), 2u);
  EXPECT_EQ(document.state().pair_sets.at(0).first, std::vector<std::string>{"door"});
  ASSERT_TRUE(document.execute(SetJoints{*door, {std::numbers::pi / 2}}));
  EXPECT_NEAR(glm::length(carrierPose(*document.find(*door), "leaf").p - dvec3(1.1, 0.4, 0.0)), 0.0, 1e-12);
  auto tighter = document.find(*door)->mechanism()->joints;
  tighter[0].upper = 1.0;
  ASSERT_TRUE(document.execute(EditMechanism{*door, tighter}));
  EXPECT_DOUBLE_EQ(document.find(*door)->joints().at(0), 1.0);
  tighter[0].axis_M = dvec3(0.0);
  EXPECT_FALSE(document.execute(EditMechanism{*door, tighter}));
  ASSERT_TRUE(document.undo());
  ASSERT_TRUE(document.execute(DissolveMechanism{*door}));
  ASSERT_NE(document.findByName("leaf"), nullptr);
  EXPECT_NEAR(glm::length(document.findByName("leaf")->X_WE.p - dvec3(1.1, 0.4, 0.0)), 0.0, 1e-12);
  EXPECT_NE(document.findByName("leaf")->id, document.findByName("frame")->id);
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(document.undo());
  EXPECT_EQ(document.state().entities.size(), 3u);
  EXPECT_EQ(document.state().pair_sets.at(0).first, std::vector<std::string>{"leaf"});
}

TEST(MechanismCommands, AMechanismSurvivesSavingByteForByte) {
  Document document;
  const EntityId frame = document.execute(AddEntity{solid("frame", {1, 0, 0})}).value();
  const EntityId nut = document.execute(AddEntity{solid("nut", {1.5, 0, 0})}).value();
  auto screw = joint("screw", MechanismJointType::kScrew, "frame", "nut", {1.5, 0, 0}, {1, 0, 0});
  screw.pitch = 0.01;
  const EntityId vice = document.execute(MakeMechanism{"vice", {frame, nut}, {screw}}).value();
  document.execute(SetJoints{vice, {1.5}}).value();
  const EntityId box = document.execute(AddEntity{solid("box", {1.6, 0, 0})}).value();
  document.execute(Attach{box, vice, "nut"}).value();
  const std::string text = documentText(document.state(), "/nowhere");
  Diagnostics notes;
  const auto read = parseDocument(text, "/nowhere", "test", notes);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(notes.warnings.empty());
  EXPECT_EQ(documentText(read->state(), "/nowhere"), text);
  EXPECT_EQ(read->findByName("vice")->kind(), EntityKind::kMechanism);
  EXPECT_EQ(read->findByName("box")->attachment.link, "nut");
}

TEST(Attachment, WhatHangsOnALinkGoesWithItAndUndoBringsItBack) {
  Document document;
  Diagnostics notes;
  const EntityId robot = document.execute(AddEntity{EntityLoader(".").load("library:hc6", 1.0, notes).value()}).value();
  const EntityId box = document.execute(AddEntity{solid("box", {1.0, 0, 0.9})}).value();
  const EntityId lid = document.execute(AddEntity{solid("lid", {1.0, 0, 1.1})}).value();
  ASSERT_TRUE(document.execute(Attach{box, robot, ""}));
  ASSERT_TRUE(document.execute(Attach{lid, box, ""}));
  EXPECT_EQ(document.find(box)->attachment.link, "tcp");
  EXPECT_FALSE(document.execute(Attach{robot, lid, ""})) << "a circle";
  EXPECT_FALSE(document.execute(Attach{box, robot, "no such link"}));
  const Pose before = document.find(lid)->X_WE;
  std::vector<double> q(document.find(robot)->robot()->dof(), 0.0);
  q[0] = std::numbers::pi / 2;
  ASSERT_TRUE(document.execute(SetJoints{robot, q}));
  EXPECT_NEAR(glm::length(document.find(lid)->X_WE.p - dvec3(-before.p.y, before.p.x, before.p.z)), 0.0, 1e-9);
  ASSERT_TRUE(document.undo());
  EXPECT_NEAR(glm::length(document.find(lid)->X_WE.p - before.p), 0.0, 1e-12);
  ASSERT_TRUE(document.execute(Detach{box}));
  ASSERT_TRUE(document.execute(SetJoints{robot, q}));
  EXPECT_NEAR(glm::length(document.find(lid)->X_WE.p - before.p), 0.0, 1e-12);
  ASSERT_TRUE(document.undo() && document.undo());
  ASSERT_TRUE(document.execute(RenameEntity{robot, "arm"}));
  EXPECT_EQ(document.find(box)->attachment.to, "arm");
  ASSERT_TRUE(document.execute(RemoveEntity{robot}));
  EXPECT_TRUE(document.find(box)->attachment.to.empty());
}

TEST(Tools, SeveralToolsOfWhichOneIsChosen) {
  Document document;
  Diagnostics notes;
  const EntityId robot = document.execute(AddEntity{EntityLoader(".").load("library:hc6", 1.0, notes).value()}).value();
  const ToolFrame gun{"gun", "tool0", Pose::translation({0, 0, 0.3})}, camera{"camera", "link_5", {}};
  ASSERT_TRUE(document.execute(SetTools{robot, {gun, camera}}));
  ASSERT_TRUE(document.execute(ChooseTool{robot, "gun"}));
  EXPECT_EQ(document.find(robot)->jointed().tip_link, "tool0");
  EXPECT_DOUBLE_EQ(document.find(robot)->jointed().X_LT.p.z, 0.3);
  EXPECT_FALSE(document.execute(ChooseTool{robot, "hammer"}));
  EXPECT_FALSE(document.execute(SetTools{robot, {gun, gun}}));
  EXPECT_FALSE(document.execute(SetTools{robot, {{"gun", "no link", {}}}}));
  const std::string text = documentText(document.state(), "/nowhere");
  const auto read = parseDocument(text, "/nowhere", "test", notes);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(documentText(read->state(), "/nowhere"), text);
  ASSERT_TRUE(document.execute(SetTools{robot, {{"gun", "tool0", Pose::translation({0, 0, 0.4})}}}));
  EXPECT_DOUBLE_EQ(document.find(robot)->jointed().X_LT.p.z, 0.4);
  ASSERT_TRUE(document.execute(SetTool{robot, "tcp", {}}));
  EXPECT_TRUE(document.find(robot)->jointed().tool.empty());
}

TEST(NamedPoses, AreKeptUndoneAndWritten) {
  Document document;
  Diagnostics notes;
  const EntityId robot = document.execute(AddEntity{EntityLoader(".").load("library:hc6", 1.0, notes).value()}).value();
  const std::vector<double> rest = kinematics::restPositions(*document.find(robot)->robot());
  ASSERT_FALSE(namedPosesOf(*document.find(robot)).empty());
  EXPECT_EQ(findNamedPose(*document.find(robot), "home"), rest);
  std::vector<double> park = rest;
  park[1] += 0.25;
  ASSERT_TRUE(document.execute(SetNamedPoses{robot, {{"park", park}, {"home", park}}}));
  EXPECT_EQ(findNamedPose(*document.find(robot), "park"), park);
  EXPECT_EQ(findNamedPose(*document.find(robot), "home"), park);
  EXPECT_TRUE(findNamedPose(*document.find(robot), "nowhere").empty());
  EXPECT_FALSE(document.execute(SetNamedPoses{robot, {{"park", park}, {"park", rest}}}));
  EXPECT_FALSE(document.execute(SetNamedPoses{robot, {{"short", {0.1}}}}));
  const std::string text = documentText(document.state(), "/nowhere");
  const auto read = parseDocument(text, "/nowhere", "test", notes);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(documentText(read->state(), "/nowhere"), text);
  EXPECT_EQ(findNamedPose(*read->state().entities[0], "park"), park);
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(findNamedPose(*document.find(robot), "home"), rest);
}

}  // namespace
}  // namespace hapticell::workcell
