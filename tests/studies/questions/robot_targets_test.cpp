// SPDX-License-Identifier: Apache-2.0
#include "studies/questions/robot_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "manipulation/scene/scene_service.h"
#include "studies/document/study_section.h"
#include "studies/questions/question_kinds.h"
#include "tests/support/test_data.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {
namespace {

/// A robot on the ground, a block beside it, and a question about targets.
class RobotTargetsOf : public testing::Test {
 protected:
  void ask(const std::string& keys) {
    folder_.write("poses.csv", "x,y,z,qw,qx,qy,qz\n0.1,0,0.4,0,1,0,0\n5,0,0.4,0,1,0,0\n");
    auto document = StudyDocument::parse(
        "cell = \"a.hcell\"\n[[vary]]\nwhat = \"position\"\n[[ask]]\nwhat = \"reach\"\n" + keys, folder_.path() / "s.hstudy");
    ASSERT_TRUE(document) << document.error().message();
    inputs_.document = *document;
    for (const auto& [what, name, p] : {std::tuple{"library:ur5e", "robot", dvec3(0.0)},
                                        std::tuple{"box:0.1,0.1,0.1", "block", dvec3(0.3, 0.3, 0.05)}}) {
      Diagnostics notes;
      auto entity = workcell::EntityLoader(".").load(what, 0.0, notes);
      ASSERT_TRUE(entity) << entity.error().message();
      entity->name = name;
      entity->X_WE = Pose::translation(p);
      ASSERT_TRUE(inputs_.cell.execute(workcell::AddEntity{std::move(*entity)}));
    }
  }
  Expected<TargetList> list() {
    SectionReader reader(inputs_.document.questions[0]);
    return readTargetList(reader, inputs_.document.questions[0], inputs_);
  }
  std::string fault(const std::string& keys) {
    inputs_ = {};
    ask(keys);
    const auto read = list();
    return read ? "read" : read.error().message();
  }

  test::TemporaryFolder folder_;
  StudyInputs inputs_;
};

TEST_F(RobotTargetsOf, ReadsTheirFileWithTurnsAndClearance) {
  ask("entity = \"robot\"\ntargets = \"poses.csv\"\nframe = \"block\"\nturns = 2\nclearance = 0.01\n");
  const auto read = list();
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->robot, "robot");
  EXPECT_EQ(read->file, folder_.path() / "poses.csv");
  EXPECT_EQ(read->turns, 2);
  EXPECT_EQ(read->clearance, 0.01);
  ASSERT_EQ(read->X_FT.size(), 2u);
  EXPECT_EQ(inputs_.files, std::vector<std::filesystem::path>{read->file}) << "results depend on it";
  TargetList other = *read;
  EXPECT_EQ(other.key(), read->key());
  other.turns = 3;
  EXPECT_NE(other.key(), read->key());
}

TEST_F(RobotTargetsOf, RefusesWhatIsNoListOfTargets) {
  const std::string robot = "entity = \"robot\"\n", file = "targets = \"poses.csv\"\n";
  EXPECT_NE(fault(file).find("entity"), std::string::npos);
  EXPECT_NE(fault(robot).find("targets"), std::string::npos);
  EXPECT_NE(fault("entity = \"block\"\n" + file).find("without joints"), std::string::npos);
  EXPECT_NE(fault(robot + file + "frame = \"nobody\"\n").find("nobody"), std::string::npos);
  EXPECT_NE(fault(robot + "frames = [\"nowhere\"]\n").find("nowhere"), std::string::npos);
  EXPECT_NE(fault(robot + file + "turns = 1.5\n").find("turns"), std::string::npos);
  EXPECT_NE(fault(robot + "targets = \"none.csv\"\n").find("none.csv"), std::string::npos);
}

TEST_F(RobotTargetsOf, EverySolutionBringsTheToolThereUpToATurnAboutItsAxis) {
  ask("entity = \"robot\"\ntargets = \"poses.csv\"\nframe = \"block\"\nturns = 2\n");
  const auto read = list();
  ASSERT_TRUE(read) << read.error().message();
  VariantCell cell(inputs_);
  const auto solved = solvedTargets(cell, *read);
  ASSERT_TRUE(solved) << solved.error().message();
  const RobotTargets& found = **solved;
  ASSERT_EQ(found.targets.size(), 2u);
  EXPECT_EQ(found.reached(), 1u) << "5 m away is out of reach";
  EXPECT_FALSE(found.allReached());
  ASSERT_FALSE(found.targets[0].free.empty());
  const workcell::Entity& robot = *cell.document.findByName("robot");
  const dvec3 p_WT = dvec3(0.3, 0.3, 0.05) + dvec3(0.1, 0.0, 0.4);
  for (const auto& solution : found.targets[0].free) {
    std::vector<Pose> X_BL;
    kinematics::forwardKinematics(*robot.robot(), solution.joints, X_BL);
    const Pose X_WT = robot.X_WE * X_BL[static_cast<std::size_t>(found.tip)] * robot.jointed().X_LT;
    EXPECT_LT(glm::distance(X_WT.p, p_WT), 1e-6);
    EXPECT_LT(glm::distance(X_WT.q * dvec3(0.0, 0.0, 1.0), dvec3(0.0, 0.0, -1.0)), 1e-6);
    EXPECT_NEAR(std::abs((X_WT.q * dvec3(1.0, 0.0, 0.0)).x), 1.0, 1e-6) << "by half turns";
  }
  EXPECT_EQ(*solvedTargets(cell, *read), *solved) << "solved once for a variant";
}

TEST(QuestionKinds, EachNameHasItsOwnMaker) {
  const auto kinds = questionKinds();
  const auto makerOf = [&](const std::string& name) {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.name == name; });
    return kind == kinds.end() ? nullptr : kind->make;
  };
  EXPECT_EQ(makerOf("reach"), &makeReach);
  EXPECT_EQ(makerOf("configuration"), &makeConfiguration);
  EXPECT_EQ(makerOf("clearance"), &makeClearance);
  EXPECT_EQ(makerOf("joint_margin"), &makeJointMargin);
  EXPECT_EQ(makerOf("manipulability"), &makeManipulability);
  EXPECT_EQ(makerOf("cycle_time"), &makeCycleTime);
  EXPECT_EQ(makerOf("motion"), &makeMotion);
  EXPECT_EQ(makerOf("posture"), &makePosture);
  EXPECT_EQ(makerOf("sight"), &makeSight);
}

TEST_F(RobotTargetsOf, AnUnknownQuestionIsRefusedWithTheKnownOnes) {
  ask("entity = \"robot\"\n");
  inputs_.document.questions[0].kind = "colour";
  const auto refused = makeQuestion(inputs_.document.questions[0], inputs_);
  ASSERT_FALSE(refused);
  for (const QuestionKind& kind : questionKinds())
    EXPECT_NE(refused.error().message().find(kind.name), std::string::npos) << kind.name;
}

}  // namespace
}  // namespace hapticell::studies
