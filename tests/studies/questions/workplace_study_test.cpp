// SPDX-License-Identifier: Apache-2.0
// A station that is moved along a direction. The search for a workplace: workplace/workplace_search_test.cpp.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mannequin/shape/figure_model.h"
#include "studies/runner/study.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {
namespace {

namespace fs = std::filesystem;

class WorkplaceStudy : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("workplace_study_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    workcell::Document document;
    const auto add = [&](const std::string& what, const std::string& name) {
      Diagnostics notes;
      auto entity = workcell::EntityLoader(folder_).load(what, 0.0, notes);
      EXPECT_TRUE(entity) << entity.error().message();
      entity->name = name;
      return *entity;
    };
    workcell::Entity worker = add("mannequin:male:50", "worker");
    const auto stands = mannequin::toModel(
        *worker.figure(), *mannequin::libraryPosture(*worker.figure(), "both_hands_forward"));
    worker.X_WE = stands.X_WE;
    worker.setJoints(stands.joints);
    ASSERT_TRUE(document.execute(workcell::AddEntity{worker}));
    workcell::Entity bench = add("box:0.4,0.8,0.04", "bench");
    bench.X_WE = Pose::translation({0.75, 0.0, 0.85});
    ASSERT_TRUE(document.execute(workcell::AddEntity{bench}));
    ASSERT_TRUE(workcell::saveDocument(document, folder_ / "cell.hcell"));
    cell_ = document.snapshotEntities();
  }
  void TearDown() override { fs::remove_all(folder_); }

  Expected<std::unique_ptr<const Study>> study(const std::string& vary, const std::string& ask) {
    std::ofstream(folder_ / "s.hstudy") << "cell = \"cell.hcell\"\n" << vary << ask;
    return Study::load(folder_ / "s.hstudy", "test");
  }

  const std::string kVary =
      "[[vary]]\nwhat = \"position\"\nname = \"height\"\nentities = [\"bench\"]\naxis = \"z\"\nvalues = [-0.1, 0.0, 0.15]\n"
      "[[vary]]\nwhat = \"position\"\nname = \"distance\"\nentity = \"bench\"\ndirection = [2.0, 0.0, 0.0]\n"
      "values = [-0.1, 0.0, 0.1]\n";
  const std::string kAsk =
      "[[ask]]\nwhat = \"posture\"\nentity = \"worker\"\nbodies = [\"female:5\", \"female:50\", \"male:50\", \"male:95\"]\n"
      "frame = \"bench\"\nmethods = [\"rula\"]\n";
  fs::path folder_;
  std::vector<workcell::Entity> cell_;
};

TEST_F(WorkplaceStudy, MovesAlongTheDirection) {
  const auto made = study(kVary, kAsk);
  ASSERT_TRUE(made) << made.error().message();
  const auto values = (*made)->space().values(8);
  const auto cell = (*made)->cellOf(values);
  ASSERT_TRUE(cell);
  EXPECT_NEAR(cell->findByName("bench")->X_WE.p.x, 0.85, 1e-12);
  EXPECT_NEAR(cell->findByName("bench")->X_WE.p.z, 1.0, 1e-12);
  for (const char* wrong : {"direction = [0.0, 0.0, 0.0]\n", "direction = [1.0, 0.0]\n",
                            "direction = [1.0, 0.0, 0.0]\naxis = \"x\"\n", ""})
    EXPECT_FALSE(study("[[vary]]\nwhat = \"position\"\nentity = \"bench\"\nvalues = [0.0]\n" + std::string(wrong), kAsk))
        << wrong;
}

}  // namespace
}  // namespace hapticell::studies
