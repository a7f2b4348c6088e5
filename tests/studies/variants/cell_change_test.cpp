// SPDX-License-Identifier: Apache-2.0
#include "studies/variants/cell_change.h"

#include <gtest/gtest.h>

#include "workcell/import/entity_source.h"

namespace hapticell::studies {
namespace {

workcell::Entity loaded(const std::string& what, const std::string& name, const Pose& X_WE) {
  Diagnostics notes;
  auto entity = workcell::EntityLoader(".").load(what, 0.0, notes);
  EXPECT_TRUE(entity) << entity.error().message();
  entity->name = name;
  entity->X_WE = X_WE;
  return *entity;
}

/// A robot hangs on a foot, a gripper on the robot; a block stands apart, locked.
class CellChange : public testing::Test {
 protected:
  void SetUp() override {
    const auto add = [&](workcell::Entity entity) { return *given_.execute(workcell::AddEntity{std::move(entity)}); };
    foot_ = add(loaded("box:0.3,0.3,0.4", "foot", Pose::translation({0.0, 0.0, 0.2})));
    robot_ = add(loaded("library:ur5e", "robot", Pose::translation({0.0, 0.0, 0.4})));
    const auto grip = add(loaded("box:0.1,0.1,0.1", "grip", Pose::translation({0.5, 0.0, 0.5})));
    block_ = add(loaded("box:0.2,0.8,0.3", "block", Pose::translation({0.55, 0.0, 0.5})));
    ASSERT_TRUE(given_.execute(workcell::Attach{robot_, foot_, ""}));
    ASSERT_TRUE(given_.execute(workcell::Attach{grip, robot_, ""}));
    workcell::SetProperties lock;
    lock.id = block_;
    lock.locked = true;
    ASSERT_TRUE(given_.execute(lock));
    variant_ = given_;
  }
  void expectTaken(workcell::Document present) {
    const auto commands = commandsFor(given_, variant_, present.state());
    ASSERT_TRUE(commands) << commands.error().message();
    for (const workcell::Command& command : *commands) ASSERT_TRUE(present.execute(command));
    for (const auto& wanted : variant_.state().entities) {
      const workcell::Entity& now = *present.findByName(wanted->name);
      EXPECT_LT(glm::length(now.X_WE.p - wanted->X_WE.p), 1e-9) << wanted->name;
      EXPECT_EQ(now.joints(), wanted->joints()) << wanted->name;
      EXPECT_EQ(now.source.path, wanted->source.path) << wanted->name;
    }
    EXPECT_TRUE(present.findByName("block")->locked);
  }

  workcell::Document given_, variant_;
  workcell::EntityId foot_ = 0, robot_ = 0, block_ = 0;
};

TEST_F(CellChange, IsEmptyWhereNothingChanged) {
  EXPECT_TRUE(changedEntities(given_, variant_).empty());
  EXPECT_TRUE(commandsFor(given_, variant_, given_.state())->empty());
}

TEST_F(CellChange, MovesCarriersBeforeWhatTheyCarry) {
  ASSERT_TRUE(variant_.execute(workcell::SetPlacement{foot_, Pose::translation({0.7, -0.3, 0.2})}));
  ASSERT_TRUE(variant_.execute(workcell::SetPlacement{robot_, Pose::translation({0.75, -0.3, 0.4})}));
  EXPECT_EQ(changedEntities(given_, variant_).size(), 3U);
  expectTaken(given_);
}

TEST_F(CellChange, TakesAnotherRobotAndKeepsLocks) {
  ASSERT_TRUE(variant_.execute(workcell::ReplaceShape{robot_, loaded("library:kuka_kr16_2", "robot", Pose())}));
  workcell::SetProperties lock;
  lock.id = block_;
  lock.locked = false;
  ASSERT_TRUE(variant_.execute(lock));
  ASSERT_TRUE(variant_.execute(workcell::SetPlacement{block_, Pose::translation({0.55, 0.0, 0.9})}));
  expectTaken(given_);
}

TEST_F(CellChange, LeavesTheRestOfAnotherCellAndNamesWhatItLacks) {
  ASSERT_TRUE(variant_.execute(workcell::SetPlacement{foot_, Pose::translation({0.7, -0.3, 0.2})}));
  workcell::Document other = given_;
  ASSERT_TRUE(other.execute(workcell::AddEntity{loaded("box:1,1,1", "more", Pose::translation({3.0, 0.0, 0.0}))}));
  expectTaken(other);
  ASSERT_TRUE(other.execute(workcell::RenameEntity{foot_, "stand"}));
  const auto refused = commandsFor(given_, variant_, other.state());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("'foot'"), std::string::npos) << refused.error().message();
}

}  // namespace
}  // namespace hapticell::studies
