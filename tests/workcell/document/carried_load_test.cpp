// SPDX-License-Identifier: Apache-2.0
#include "workcell/document/carried_load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/shapes/shapes.h"
#include "tests/support/test_data.h"
#include "workcell/document/document.h"
#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_library.h"

namespace hapticell::workcell {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A cell with a robot at home; parts are hung on it where they are asked for.
class LoadCell {
 public:
  LoadCell() {
    Diagnostics notes;
    Entity made = EntityLoader(".").load("library:kuka_kr16_2", 0.0, notes).value();
    made.name = "Robot";
    made.X_WE = Pose::translation({1.0, 2.0, 0.0});
    robot_ = document_.execute(AddEntity{std::move(made)}).value();
  }
  const Entity& robot() const { return *document_.find(robot_); }
  /// A cube of 0.1 m whose middle is at p_K of `link` of what `on` names.
  EntityId hang(const std::string& name, double mass, const std::string& on, const std::string& link,
                const dvec3& p_K) {
    const Entity* carrier = document_.findByName(on);
    Entity part;
    part.name = name;
    part.contact.mass = mass;
    part.body = Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)))};
    part.X_WE = carrierPose(*carrier, link) * Pose::translation(p_K);
    const EntityId to = carrier->id;
    const EntityId id = document_.execute(AddEntity{std::move(part)}).value();
    EXPECT_TRUE(document_.execute(Attach{id, to, link}).has_value());
    return id;
  }
  CarriedLoad load() const { return carriedLoad(document_.state(), robot()); }
  Document& document() { return document_; }
  std::string firstMovedLink() const {
    const kinematics::RobotModel& model = *robot().robot();
    return model.links[static_cast<std::size_t>(model.joints[static_cast<std::size_t>(model.moving[0])].child_link)]
        .name;
  }

 private:
  Document document_;
  EntityId robot_ = 0;
};

TEST(CarriedLoad, AddsChainsAndFindsTheirCentreInEveryPosture) {
  LoadCell cell;
  EXPECT_EQ(verdictOn(cell.load(), 16.0), LoadVerdict::kNothing);
  const std::string tip = cell.robot().jointed().tip_link;
  cell.hang("Gripper", 3.0, "Robot", tip, {0.0, 0.0, 0.1});
  cell.hang("Part", 9.0, "Gripper", {}, {0.2, 0.0, 0.1});
  for (const double turn : {0.0, 0.5}) {
    std::vector<double> q = cell.robot().joints();
    for (double& joint : q) joint += turn;
    ASSERT_TRUE(cell.document().execute(SetJoints{cell.robot().id, q}).has_value());
    const CarriedLoad load = cell.load();
    EXPECT_NEAR(load.mass, 12.0, 1e-12);
    EXPECT_EQ(load.link, tip);
    EXPECT_LT(glm::length(load.p_LC - dvec3(0.15, 0.0, 0.175)), 1e-9);  // (3 x 0.1 + 9 x 0.2) / 12 along z.
    EXPECT_THAT(load.starting, IsEmpty());
    EXPECT_EQ(verdictOn(load, 16.0), LoadVerdict::kAllowed);
    EXPECT_EQ(verdictOn(load, 11.9), LoadVerdict::kTooHeavy);
    EXPECT_EQ(verdictOn(load, 0.0), LoadVerdict::kOpen);
  }
}

TEST(CarriedLoad, AMassThatNobodyEnteredIsNamedAndNeverAllowed) {
  LoadCell cell;
  const std::string tip = cell.robot().jointed().tip_link;
  cell.hang("Gripper", Entity{}.contact.mass, "Robot", tip, {});
  EXPECT_THAT(cell.load().starting, ElementsAre("Gripper"));
  EXPECT_EQ(verdictOn(cell.load(), 16.0), LoadVerdict::kOpen);
  cell.hang("Part", 17.0, "Robot", tip, {});
  EXPECT_EQ(verdictOn(cell.load(), 16.0), LoadVerdict::kTooHeavy);
}

TEST(CarriedLoad, WhatHangsOnAnotherLinkIsNoLoadOfTheFlange) {
  LoadCell cell;
  cell.hang("Valves", 5.0, "Robot", cell.firstMovedLink(), {});
  EXPECT_EQ(cell.load().mass, 0.0);
  ASSERT_EQ(cell.load().other.size(), 1U);
  EXPECT_EQ(cell.load().other[0]->name, "Valves");
  EXPECT_EQ(verdictOn(cell.load(), 16.0), LoadVerdict::kNothing);
}

TEST(RatedPayload, IsTheMakersOrNotKnown) {
  EXPECT_EQ(ratedPayload("library:kuka_kr16_2").value(), 16.0);
  EXPECT_EQ(ratedPayload("library:hc6").value(), 12.0);
  EXPECT_EQ(ratedPayload("arm.urdf").value(), 0.0);
  EXPECT_FALSE(ratedPayload("library:nobodys").has_value());
  Diagnostics notes;
  for (const LibraryRobot& robot : listLibraryRobots(notes))
    EXPECT_EQ(ratedPayload("library:" + robot.name).value(), robot.sheet.payload) << robot.name;
}

}  // namespace
}  // namespace hapticell::workcell
