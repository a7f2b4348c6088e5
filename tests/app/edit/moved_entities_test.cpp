// SPDX-License-Identifier: Apache-2.0
#include "app/edit/moved_entities.h"

#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/shapes/shapes.h"
#include "workcell/document/document.h"

namespace hapticell::app {
namespace {

using workcell::EntityKind;

workcell::EntityId add(workcell::Document& document, const char* name, EntityKind kind = EntityKind::kSolid,
                       const char* parent = "") {
  workcell::Entity entity;
  entity.name = name;
  entity.parent = parent;
  if (kind == EntityKind::kSolid)
    entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({1, 1, 1}))};
  else
    entity.body = workcell::Assembly{};
  const auto id = document.execute(workcell::AddEntity{entity});
  EXPECT_TRUE(id.has_value());
  return id.value_or(0);
}

TEST(MovedTogether, LeavesOutWhatIsLockedAndWhatGoesAlongAnyway) {
  workcell::Document document;
  const auto assembly = add(document, "assembly", EntityKind::kAssembly);
  const auto inside = add(document, "inside", EntityKind::kSolid, "assembly");
  const auto deep = add(document, "deep", EntityKind::kSolid, "inside");
  const auto carrier = add(document, "carrier"), carried = add(document, "carried"), locked = add(document, "locked");
  const auto beside = add(document, "beside", EntityKind::kSolid, "carrier");
  document.execute(workcell::Attach{carried, carrier, ""});
  document.execute(workcell::SetProperties{.id = locked, .locked = true});
  const auto moved = movedTogether(document.state(), {assembly, inside, deep, carrier, carried, locked, beside, 999});
  EXPECT_EQ(moved, (std::vector<workcell::EntityId>{assembly, carrier, beside}))
      << "what stands below a solid stays where it is unless it is chosen";
  EXPECT_EQ(movedTogether(document.state(), {deep, carried}), (std::vector<workcell::EntityId>{deep, carried}));
}

TEST(MovedTogether, CommandsMoveEachOnceByTheSameMotion) {
  workcell::Document document;
  const auto a = add(document, "a"), b = add(document, "b");
  document.execute(workcell::SetPlacement{b, Pose::translation({1, 0, 0})});
  const Pose M_W{{0, 0, 0.5}, glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 0, 1))};
  for (const auto& command : moveCommands(document.state(), {a, b, 77}, M_W))
    ASSERT_TRUE(document.execute(command).has_value());
  EXPECT_NEAR(glm::length(document.find(a)->X_WE.p - dvec3(0, 0, 0.5)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(document.find(b)->X_WE.p - dvec3(0, 1, 0.5)), 0.0, 1e-12);
}

TEST(Steps, GoToTheNextMultipleAndNoneChangesNothing) {
  EXPECT_DOUBLE_EQ(stepped(0.0149, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(stepped(-0.016, 0.01), -0.02);
  EXPECT_DOUBLE_EQ(stepped(0.0149, 0.0), 0.0149);
}

RC_GTEST_PROP(MotionOnto, PutsOneFrameOntoTheOther, ()) {
  const auto any = [] {
    const dvec3 turn(*rc::gen::inRange(-300, 300) * 0.01, *rc::gen::inRange(-300, 300) * 0.01,
                     *rc::gen::inRange(-300, 300) * 0.01);
    return Pose{{*rc::gen::inRange(-9, 9) * 0.1, *rc::gen::inRange(-9, 9) * 0.1, *rc::gen::inRange(-9, 9) * 0.1},
                quaternionFromRotationVector(turn)};
  };
  const Pose X_WF = any(), X_WT = any();
  const Pose along = motionOnto(X_WF, X_WT, true, false) * X_WF;
  RC_ASSERT(glm::length(along.p - X_WT.p) < 1e-9);
  RC_ASSERT(glm::length(along.rotate({0, 0, 1}) - X_WT.rotate({0, 0, 1})) < 1e-9);
  const Pose flat = motionOnto(X_WF, X_WT, true, true) * X_WF;
  RC_ASSERT(glm::length(flat.p - X_WT.p) < 1e-9);
  RC_ASSERT(glm::length(flat.rotate({0, 0, 1}) + X_WT.rotate({0, 0, 1})) < 1e-9);
  const Pose shifted = motionOnto(X_WF, X_WT, false, true) * X_WF;
  RC_ASSERT(glm::length(shifted.p - X_WT.p) < 1e-9);
  RC_ASSERT(glm::length(rotationVector(shifted.q * glm::conjugate(X_WF.q))) < 1e-6);
}

}  // namespace
}  // namespace hapticell::app
