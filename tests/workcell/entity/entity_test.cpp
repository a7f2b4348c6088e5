// SPDX-License-Identifier: Apache-2.0
#include "workcell/entity/entity.h"

#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "workcell/entity/mechanism.h"

namespace hapticell::workcell {
namespace {

std::shared_ptr<const geometry::TriangleMesh> box() {
  return std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)));
}

/// One of each kind, in the order of EntityKind.
std::vector<Entity> oneOfEach() {
  const auto model = std::make_shared<const kinematics::RobotModel>();
  std::vector<Entity> all(std::variant_size_v<EntityBody>);
  all[0].body = Solid{box()};
  all[1].body = Robot{{.model = model, .joints = {0.5}, .tip_link = "flange"}};
  all[2].body = Mechanism{{.model = model, .joints = {0.1}}, std::make_shared<const MechanismDefinition>()};
  all[3].body = Assembly{};
  all[4].body = Mannequin{{.model = model}, nullptr};
  all[5].body = CellFrame{};
  return all;
}

TEST(Entity, KindIsThatOfItsBody) {
  EXPECT_EQ(Entity{}.kind(), EntityKind::kSolid);
  const char* const words[] = {"solid", "robot", "mechanism", "assembly", "mannequin", "frame"};
  const std::vector<Entity> all = oneOfEach();
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].kind(), static_cast<EntityKind>(k));
    EXPECT_STREQ(wordOf(all[k].kind()), words[k]);
    EXPECT_EQ(hasShape(all[k].kind()), k != 3 && k != 5) << words[k];
    EXPECT_EQ(isMachine(all[k]), k == 1 || k == 2) << words[k];
  }
}

TEST(Entity, WhatItsBodyHasNotIsEmpty) {
  const std::vector<Entity> all = oneOfEach();
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].mesh() != nullptr, k == 0);
    EXPECT_EQ(checkedMesh(all[k]) != nullptr, k == 0);
    EXPECT_EQ(all[k].robot() != nullptr, k == 1 || k == 2 || k == 4);
    EXPECT_EQ(all[k].mechanism() != nullptr, k == 2);
    EXPECT_EQ(all[k].proxy().kind, CollisionProxy::Kind::kNone);
    EXPECT_EQ(all[k].figure(), nullptr);
  }
  EXPECT_EQ(all[1].joints(), std::vector{0.5});
  EXPECT_EQ(all[1].jointed().tip_link, "flange");
  EXPECT_TRUE(all[0].joints().empty() && all[0].jointed().tools.empty());
}

TEST(Entity, IsChangedThroughItsBody) {
  Entity entity;
  entity.editSolid() = {box(), {CollisionProxy::Kind::kConvex, 0.0, 0.001, box()}};
  EXPECT_EQ(checkedMesh(entity), entity.proxy().mesh);
  entity.setJoints({1.0});
  EXPECT_TRUE(entity.joints().empty());
  entity.body = Robot{};
  entity.setJoints({1.0, 2.0});
  entity.editJointed().tool = "gripper";
  EXPECT_EQ(entity.joints(), (std::vector{1.0, 2.0}));
  EXPECT_EQ(entity.jointed().tool, "gripper");
  EXPECT_EQ(entity.mesh(), nullptr);
}

TEST(EntityDeathTest, ABodyThatIsNotThereIsABrokenContract) {
  Entity solid, frame;
  frame.body = CellFrame{};
  EXPECT_DEATH(solid.editJointed(), "own != nullptr");
  EXPECT_DEATH(frame.editSolid(), "solid != nullptr");
}

}  // namespace
}  // namespace hapticell::workcell
