// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "collision/queries/proximity_query.h"
#include "geometry/shapes/mass_properties.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"

namespace hapticell::workcell {
namespace {

class Demonstration : public ::testing::Test {
 protected:
  void SetUp() override {
    auto loaded = loadDocument(test::sourceFile("config/workcells/demo.hcell"), diagnostics_);
    ASSERT_TRUE(loaded) << loaded.error().message();
    document_ = std::move(*loaded);
    robot_ = document_.findByName("robot");
    ASSERT_NE(robot_, nullptr);
    kinematics::forwardKinematics(*robot_->robot(), robot_->joints(), X_BL_);
  }

  Pose linkInWorld(const std::string& name) const {
    return robot_->X_WE * X_BL_[static_cast<std::size_t>(robot_->robot()->findLink(name))];
  }

  Diagnostics diagnostics_;
  Document document_;
  const Entity* robot_ = nullptr;
  std::vector<Pose> X_BL_;
};

TEST_F(Demonstration, OpensWithoutAWord) {
  EXPECT_TRUE(diagnostics_.warnings.empty()) << english(diagnostics_.warnings);
}

TEST_F(Demonstration, SavingItChangesNoByte) {
  const auto path = test::sourceFile("config/workcells/demo.hcell");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(documentText(document_.state(), path.parent_path()), text);
}

TEST_F(Demonstration, RobotHoldsThePartThirtyMillimetresOverItsSeatWithTheToolDown) {
  EXPECT_EQ(robot_->robot()->dof(), 6u);
  const Pose X_WT = linkInWorld("tcp");
  EXPECT_NEAR(glm::distance(X_WT.p, dvec3(0.99, 0.0, 0.75 + 0.055 + 0.030)), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(X_WT.rotate({0, 0, 1}), dvec3(0, 0, -1)), 0.0, 1e-6);
  EXPECT_NEAR(linkInWorld("housing_4711").p.z, 0.78, 1e-6);
}

TEST_F(Demonstration, NothingTouchesTheRobotAtTheStart) {
  for (const auto& other : document_.state().entities) {
    if (other->id == robot_->id || other->name == "Pedestal" || !other->mesh()) continue;
    const auto obstacle = collision::MeshCollider::build(*other->mesh());
    for (std::size_t link = 0; link < robot_->robot()->links.size(); ++link) {
      for (const kinematics::LinkShape& shape : robot_->robot()->links[link].collisions) {
        const auto moved = collision::MeshCollider::build(*shape.mesh);
        const auto result = collision::distance(moved, robot_->X_WE * X_BL_[link] * shape.X_LS, obstacle, other->X_WE);
        EXPECT_GT(result.distance, 0.01) << robot_->robot()->links[link].name << " and " << other->name;
      }
    }
  }
}

TEST_F(Demonstration, EverySolidIsClosed) {
  for (const auto& entity : document_.state().entities) {
    if (!entity->mesh()) continue;
    EXPECT_GT(geometry::massProperties(*entity->mesh()).volume, 1e-6) << entity->name;
  }
}

}  // namespace
}  // namespace hapticell::workcell
