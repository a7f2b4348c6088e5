// SPDX-License-Identifier: Apache-2.0
// Drafts of mechanisms, samples and the gizmo's arithmetic, without a display.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "app/robot/mechanism_draft.h"
#include "app/robot/mechanism_samples.h"
#include "app/viewport/tools/gizmo.h"
#include "geometry/shapes/shapes.h"
#include "workcell/document/document.h"

namespace hapticell::app {
namespace {

using workcell::MechanismJointType;

workcell::Entity box(const std::string& name, const dvec3& p_W) {
  workcell::Entity entity;
  entity.name = name;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.2)))};
  entity.X_WE = Pose::translation(p_W);
  return entity;
}

PickedFeature bore(const dvec3& p_W, const dvec3& axis_W) {
  PickedFeature feature;
  feature.surface_W.type = collision::SurfaceType::kCylinder;
  feature.surface_W.p_M = p_W;
  feature.surface_W.axis_M = axis_W;
  feature.surface_W.radius = 0.02;
  feature.p_WHit = feature.p_WQ = p_W + dvec3(0.02, 0, 0.1);
  return feature;
}

TEST(MechanismDraft, AHingeOnAPickedBoreTurnsThePartAboutIt) {
  workcell::Document document;
  ASSERT_TRUE(document.execute(workcell::AddEntity{box("frame", {0, 0, 0})}).has_value());
  ASSERT_TRUE(document.execute(workcell::AddEntity{box("leaf", {1, 0, 0})}).has_value());
  MechanismDraft draft{0, "door", {}};
  draft.joints.push_back(newJoint(draft, MechanismJointType::kRevolute));
  EXPECT_TRUE(faultOf(draft, document.state()).has_value()) << "it has no parts yet";
  draft.joints[0].parent = "frame";
  draft.joints[0].child = "leaf";
  layAxis(draft.joints[0], bore({0.5, 0.3, 0}, {0, 0, 1}));
  EXPECT_FALSE(faultOf(draft, document.state()).has_value());
  EXPECT_EQ(partsOf(draft), (std::vector<std::string>{"frame", "leaf"}));
  const auto command = commandOf(draft, document.state());
  ASSERT_TRUE(command.has_value());
  ASSERT_TRUE(document.execute(*command).has_value());
  const workcell::Entity* door = document.findByName("door");
  ASSERT_TRUE(door && door->robot());
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*door->robot(), {0.5 * std::numbers::pi}, X_BL);
  const Pose X_WLeaf = door->X_WE * X_BL[static_cast<std::size_t>(door->robot()->findLink("leaf"))];
  // By hand: (1, 0) turned by a quarter about (0.5, 0.3) is (0.8, 0.8).
  EXPECT_LT(glm::length(X_WLeaf.p - dvec3(0.8, 0.8, 0)), 1e-12);
  ASSERT_TRUE(document.undo());
  EXPECT_TRUE(document.findByName("leaf")) << "one step";
}

TEST(MechanismDraft, EditingKeepsTheJointsWhereTheyAreInTheCell) {
  workcell::Document document;
  const Pose X_WB{{2, 1, 0}, quaternionFromRotationVector(dvec3(0, 0, 0.7))};
  auto parts = sampleParts(MechanismSample::kDoor, X_WB, document);
  ASSERT_TRUE(parts.has_value());
  workcell::MakeMechanism make{parts->name, {}, parts->joints};
  for (const auto& part : parts->parts) make.parts.push_back(*document.execute(workcell::AddEntity{part}));
  ASSERT_TRUE(document.execute(make).has_value());
  const workcell::Entity* door = document.findByName(parts->name);
  ASSERT_TRUE(door);
  MechanismDraft draft = draftOf(*door);
  ASSERT_EQ(draft.joints.size(), parts->joints.size());
  for (std::size_t i = 0; i < draft.joints.size(); ++i) {
    EXPECT_LT(glm::length(draft.joints[i].p_MJ - parts->joints[i].p_MJ), 1e-12);
    EXPECT_LT(glm::length(draft.joints[i].axis_M - parts->joints[i].axis_M), 1e-12);
  }
  for (auto& joint : draft.joints)
    if (joint.type == MechanismJointType::kRevolute) joint.upper = 1.0;
  EXPECT_FALSE(faultOf(draft, document.state()).has_value());
  ASSERT_TRUE(document.execute(*commandOf(draft, document.state())).has_value());
  const workcell::Entity* changed = document.findByName(parts->name);
  EXPECT_NEAR(changed->robot()->joints[static_cast<std::size_t>(changed->robot()->moving[0])].upper, 1.0, 1e-12);
}

TEST(MechanismDraft, FlippingTheAxisKeepsTheMotion) {
  workcell::MechanismJoint joint;
  joint.axis_M = {0, 0, 1};
  joint.lower = -0.2;
  joint.upper = 1.0;
  flipAxis(joint);
  EXPECT_EQ(joint.axis_M, dvec3(0, 0, -1));
  EXPECT_DOUBLE_EQ(joint.lower, -1.0);
  EXPECT_DOUBLE_EQ(joint.upper, 0.2);
  joint.lower = -std::numeric_limits<double>::infinity();
  joint.upper = std::numeric_limits<double>::infinity();
  flipAxis(joint);
  EXPECT_TRUE(joint.lower < 0 && joint.upper > 0);
}

TEST(MechanismDraft, NamesALockedPart) {
  workcell::Document document;
  workcell::Entity locked = box("frame", {0, 0, 0});
  locked.locked = true;
  ASSERT_TRUE(document.execute(workcell::AddEntity{locked}).has_value());
  ASSERT_TRUE(document.execute(workcell::AddEntity{box("leaf", {1, 0, 0})}).has_value());
  MechanismDraft draft{0, "door", {newJoint({}, MechanismJointType::kPrismatic)}};
  draft.joints[0].parent = "frame";
  draft.joints[0].child = "leaf";
  EXPECT_EQ(english(faultOf(draft, document.state()).value().found), "'frame' is locked in place");
}

TEST(MechanismSamples, EachIsAWorkingMechanism) {
  for (const MechanismSample sample :
       {MechanismSample::kDoor, MechanismSample::kGripper, MechanismSample::kTurntable}) {
    workcell::Document document;
    auto parts = sampleParts(sample, Pose::identity(), document);
    ASSERT_TRUE(parts.has_value()) << nameOf(sample);
    workcell::MakeMechanism make{parts->name, {}, parts->joints};
    for (const auto& part : parts->parts) make.parts.push_back(*document.execute(workcell::AddEntity{part}));
    ASSERT_TRUE(document.execute(make).has_value()) << nameOf(sample);
    const workcell::Entity* made = document.findByName(parts->name);
    ASSERT_TRUE(made && made->robot());
    EXPECT_EQ(made->robot()->dof(), 1u) << nameOf(sample);
  }
}

TEST(MechanismSamples, TheGrippersFingersMoveApartTogether) {
  workcell::Document document;
  auto parts = sampleParts(MechanismSample::kGripper, Pose::identity(), document);
  ASSERT_TRUE(parts.has_value());
  workcell::MakeMechanism make{parts->name, {}, parts->joints};
  for (const auto& part : parts->parts) make.parts.push_back(*document.execute(workcell::AddEntity{part}));
  ASSERT_TRUE(document.execute(make).has_value());
  const workcell::Entity* gripper = document.findByName(parts->name);
  std::vector<Pose> closed, open;
  kinematics::forwardKinematics(*gripper->robot(), {0.0}, closed);
  kinematics::forwardKinematics(*gripper->robot(), {0.03}, open);
  const auto moved = [&](const char* link) {
    const auto i = static_cast<std::size_t>(gripper->robot()->findLink(link));
    return open[i].p - closed[i].p;
  };
  EXPECT_LT(glm::length(moved("Finger, left") - dvec3(-0.03, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(moved("Finger, right") - dvec3(0.03, 0, 0)), 1e-12);
}

/// A camera that looks at the gizmo from a direction that shows all handles.
struct Seen {
  ViewSize view{800, 600};
  Camera camera;
  Gizmo gizmo;
  Seen() {
    gizmo.X_WG = {{0.3, -0.2, 0.5}, quaternionFromRotationVector(dvec3(0.1, 0.2, 0.3))};
    camera.target_W = gizmo.X_WG.p;
    camera.distance = 2.0;
    camera.azimuth = 0.7;
    camera.elevation = 0.5;
    gizmo.size = 0.2;
  }
  Ray rayTo(const dvec3& p_W) const { return camera.rayThrough(*camera.project(p_W, view), view); }
};

TEST(Gizmo, APointOfAnArrowIsHitAndReadBack) {
  const Seen seen;
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 along(0.0);
    along[axis] = 0.9 * seen.gizmo.size;
    const dvec3 p_W = seen.gizmo.X_WG * along;
    const auto handle = seen.gizmo.hit(*seen.camera.project(p_W, seen.view), seen.camera, seen.view);
    ASSERT_TRUE(handle.has_value());
    EXPECT_EQ(handle->axis, axis);
    EXPECT_FALSE(handle->turns);
    const auto value = seen.gizmo.valueOf(*handle, seen.rayTo(p_W));
    ASSERT_TRUE(value.has_value());
    EXPECT_NEAR(*value, 0.9 * seen.gizmo.size, 1e-9);
  }
  EXPECT_FALSE(seen.gizmo.hit({5, 5}, seen.camera, seen.view).has_value());
}

TEST(Gizmo, ARingIsReadAsAnAngleAndTurnsThePose) {
  const Seen seen;
  const Gizmo::Handle about_z{2, true};
  const auto at = [&](double angle) {
    const double r = 0.75 * seen.gizmo.size;
    return seen.gizmo.X_WG * dvec3(r * std::cos(angle), r * std::sin(angle), 0);
  };
  const auto from = seen.gizmo.valueOf(about_z, seen.rayTo(at(0.3)));
  const auto to = seen.gizmo.valueOf(about_z, seen.rayTo(at(0.8)));
  ASSERT_TRUE(from && to);
  EXPECT_NEAR(*to - *from, 0.5, 1e-9);
  const Pose X_WT = seen.gizmo.X_WG;
  const Pose turned = seen.gizmo.dragged(about_z, *from, *to, X_WT);
  EXPECT_LT(glm::length(turned.p - X_WT.p), 1e-12);
  const dvec3 expected = X_WT.rotate(dvec3(std::cos(0.5), std::sin(0.5), 0));
  EXPECT_LT(glm::length(turned.rotate(dvec3(1, 0, 0)) - expected), 1e-9);
}

TEST(Gizmo, AnArrowMovesAlongItsAxisAlone) {
  const Seen seen;
  const Pose moved = seen.gizmo.dragged({1, false}, 0.02, 0.07, seen.gizmo.X_WG);
  EXPECT_LT(glm::length(moved.p - seen.gizmo.X_WG * dvec3(0, 0.05, 0)), 1e-12);
  EXPECT_EQ(moved.q, seen.gizmo.X_WG.q);
}

TEST(Gizmo, AnAxisSeenFromItsEndSaysNothing) {
  Seen seen;
  const dvec3 x_W = seen.gizmo.X_WG.rotate(dvec3(1, 0, 0));
  const Ray along{seen.gizmo.X_WG.p - x_W, x_W};
  EXPECT_FALSE(seen.gizmo.valueOf({0, false}, along).has_value());
  EXPECT_FALSE(seen.gizmo.valueOf({1, true}, along).has_value()) << "a ring from its edge";
}

}  // namespace
}  // namespace hapticell::app
