// SPDX-License-Identifier: Apache-2.0
#include "studies/runner/study_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "kinematics/model/robot_model.h"
#include "studies/store/result_merge.h"
#include "studies/store/result_ranking.h"
#include "workcell/format/document_io.h"
#include "workcell/import/entity_source.h"

namespace hapticell::studies {
namespace {

namespace fs = std::filesystem;

/// A cell with a small robot on a box and a block beside it.
class StudyRun : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("study_run_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    workcell::Document document;
    workcell::EntityLoader loader(folder_);
    const auto add = [&](const std::string& what, const std::string& name, const Pose& X_WE) {
      Diagnostics notes;
      auto entity = loader.load(what, 0.0, notes);
      ASSERT_TRUE(entity) << entity.error().message();
      entity->name = name;
      entity->X_WE = X_WE;
      ASSERT_TRUE(document.execute(workcell::AddEntity{std::move(*entity)}));
    };
    add("library:ur5e", "robot", Pose::translation({0.0, 0.0, 0.4}));
    add("box:0.3,0.3,0.4", "foot", Pose::translation({0.0, 0.0, 0.2}));
    add("box:0.2,0.8,0.3", "block", Pose::translation({0.55, 0.0, 0.5}));
    ASSERT_TRUE(workcell::saveDocument(document, folder_ / "cell.hcell"));
    std::ofstream(folder_ / "targets.csv") << "x,y,z,qw,qx,qy,qz\n0.4,0.3,0.8,0,1,0,0\n0.5,0,0.75,0,1,0,0\n"
                                              "0.3,-0.4,0.6,0,1,0,0\n0.65,0,0.55,0,1,0,0\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::unique_ptr<const Study> study(const std::string& more) {
    std::ofstream(folder_ / "s.hstudy") << "cell = \"cell.hcell\"\n" << more;
    auto study = Study::load(folder_ / "s.hstudy", "test");
    EXPECT_TRUE(study) << study.error().message();
    return study ? std::move(*study) : nullptr;
  }

  std::string csvAfter(const Study& study, const std::string& name, RunOptions options) {
    auto store = ResultStore::openOrCreate(folder_ / name, study.head());
    EXPECT_TRUE(store) << store.error().message();
    const auto summary = runStudy(study, *store, options);
    EXPECT_TRUE(summary) << summary.error().message();
    return *csvOf(*store);
  }

  fs::path folder_;
  const std::string kGrid =
      "[[vary]]\nwhat = \"position\"\nname = \"x\"\nentity = \"robot\"\naxis = \"x\"\nfrom = -0.2\nto = 0.2\nsteps = 5\n"
      "[[vary]]\nwhat = \"position\"\nname = \"z\"\nentity = \"block\"\naxis = \"z\"\nvalues = [0.0, 0.2]\n"
      "[[ask]]\nwhat = \"reach\"\nentity = \"robot\"\ntargets = \"targets.csv\"\nframe = \"block\"\n"
      "[[ask]]\nwhat = \"clearance\"\nentity = \"robot\"\ntargets = \"targets.csv\"\nframe = \"block\"\n"
      "[[ask]]\nwhat = \"cycle_time\"\nentity = \"robot\"\ntargets = \"targets.csv\"\nframe = \"block\"\n"
      "[[require]]\nvalue = \"reach.share\"\nat_least = 0.5\n[[objective]]\nvalue = \"clearance.least\"\n"
      "goal = \"greatest\"\n";
  const std::string kWorldTargets =
      "[[ask]]\nwhat = \"reach\"\nentity = \"robot\"\ntargets = \"targets.csv\"\n"
      "[[ask]]\nwhat = \"joint_margin\"\nentity = \"robot\"\ntargets = \"targets.csv\"\n";
};

TEST_F(StudyRun, RowsAreEqualForThreadsChunksAndInterruptions) {
  const auto grid = study(kGrid);
  ASSERT_TRUE(grid);
  const std::string one = csvAfter(*grid, "one", {.jobs = 1});
  EXPECT_EQ(csvAfter(*grid, "two", {.jobs = 2}), one);
  std::vector<fs::path> parts;
  for (std::size_t chunk = 1; chunk <= 3; ++chunk) {
    const std::string name = "chunk" + std::to_string(chunk);
    csvAfter(*grid, name, {.chunk = chunk, .chunks = 3, .jobs = 1});
    parts.push_back(folder_ / name);
  }
  ASSERT_TRUE(mergeResults(parts, folder_ / "merged", false));
  EXPECT_EQ(*csvOf(*ResultStore::open(folder_ / "merged", false)), one);

  std::atomic<bool> cancelled{false};
  RunOptions stopped{.jobs = 1, .cancelled = &cancelled};
  stopped.progress = [&](const RunProgress& now) { cancelled = now.done >= 3; };
  const std::string part = csvAfter(*grid, "stopped", stopped);
  EXPECT_LT(part.size(), one.size());
  EXPECT_EQ(csvAfter(*grid, "stopped", {.jobs = 2}), one);
}

TEST_F(StudyRun, RowsAreHandedOutAsTheyAreKept) {
  const auto grid = study(kGrid);
  ASSERT_TRUE(grid);
  std::vector<ResultRow> rows;
  RunOptions options{.jobs = 2};
  options.rows = [&](const std::vector<ResultRow>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
  csvAfter(*grid, "handed", options);
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  std::vector<ResultRow> kept;
  const auto store = ResultStore::open(folder_ / "handed", false);
  ASSERT_TRUE(store->forEachRow([&](const ResultRow& row) {
    kept.push_back(row);
    return Expected<void>();
  }));
  EXPECT_EQ(rows, kept);
  // The front and the best of memory are those of the store.
  const auto document = StudyDocument::parse(store->head().study, store->head().file);
  const auto front = paretoRows(*store, *document);
  const auto indices = paretoIndices(kept, store->head().answers, document->objectives);
  ASSERT_TRUE(front && indices);
  ASSERT_EQ(front->size(), indices->size());
  for (std::size_t i = 0; i < indices->size(); ++i) EXPECT_EQ(kept[(*indices)[i]], (*front)[i]);
  EXPECT_EQ(kept[*bestIndex(kept)], bestRows(*store, 1)->front());
  EXPECT_FALSE(paretoIndices(kept, store->head().answers, {}));
}

TEST_F(StudyRun, TargetsMayBeFramesOfTheCell) {
  Diagnostics notes;
  auto cell = workcell::loadDocument(folder_ / "cell.hcell", notes);
  ASSERT_TRUE(cell);
  const Pose X_WT = Pose({0.4, 0.3, 0.8}, dquat(0.0, 1.0, 0.0, 0.0));
  ASSERT_TRUE(cell->execute(workcell::AddEntity{workcell::makeFrame("weld", X_WT)}));
  const workcell::Entity& block = *cell->findByName("block");
  ASSERT_TRUE(cell->execute(workcell::SetFrames{
      block.id, {{"grip", block.X_WE.inverse() * Pose({0.5, 0.0, 0.75}, dquat(0.0, 1.0, 0.0, 0.0))}}}));
  ASSERT_TRUE(workcell::saveDocument(*cell, folder_ / "cell.hcell"));
  std::ofstream(folder_ / "two.csv") << "x,y,z,qw,qx,qy,qz\n0.4,0.3,0.8,0,1,0,0\n0.5,0,0.75,0,1,0,0\n";
  const std::string vary = "[[vary]]\nwhat = \"position\"\nname = \"x\"\nentity = \"robot\"\naxis = \"x\"\n"
                           "from = -0.3\nto = 0.2\nsteps = 6\n[[ask]]\nwhat = \"reach\"\nentity = \"robot\"\n";
  const auto by_frames = study(vary + "frames = [\"weld\", \"block/grip\"]\n");
  ASSERT_TRUE(by_frames);
  const std::string rows = csvAfter(*by_frames, "frames", {.jobs = 1});
  const auto by_file = study(vary + "targets = \"two.csv\"\n");
  ASSERT_TRUE(by_file);
  EXPECT_EQ(csvAfter(*by_file, "file", {.jobs = 1}), rows);
  for (const char* wrong : {"frames = [\"no such\"]\n", "frames = [\"weld\"]\ntargets = \"two.csv\"\n", "",
                            "frames = [\"weld\"]\nframe = \"block\"\n"}) {
    std::ofstream(folder_ / "s.hstudy") << "cell = \"cell.hcell\"\n" << vary << wrong;
    EXPECT_FALSE(Study::load(folder_ / "s.hstudy", "test")) << wrong;
  }
}

TEST_F(StudyRun, AVariantIsTheCellThatItWasMeasuredIn) {
  const auto grid = study(kGrid);
  ASSERT_TRUE(grid);
  const auto values = grid->space().values(7);
  const auto document = grid->cellOf(values);
  ASSERT_TRUE(document) << document.error().message();
  EXPECT_NEAR(document->findByName("robot")->X_WE.p.x, std::get<double>(values[0]), 1e-12);
  EXPECT_NEAR(document->findByName("block")->X_WE.p.z, 0.5 + std::get<double>(values[1]), 1e-12);
  EXPECT_EQ(grid->evaluate(7, values), grid->evaluate(7, values));
  // The robot touches its foot in the given cell: that is no contact of a variant.
  EXPECT_FALSE(grid->notes().empty());
}

/// Where the arm goes through the block in the given cell, that pair had been left out, and no variant met the block.
TEST_F(StudyRun, APairThatOverlapsDeeplyInTheGivenCellIsChecked) {
  Diagnostics notes;
  auto cell = workcell::loadDocument(folder_ / "cell.hcell", notes);
  ASSERT_TRUE(cell);
  const workcell::Entity& robot = *cell->findByName("robot");
  std::vector<Pose> X_BL;
  kinematics::forwardKinematics(*robot.robot(), robot.joints(), X_BL);
  const Pose X_WT = robot.X_WE * X_BL[static_cast<std::size_t>(robot.robot()->defaultTip())];
  ASSERT_TRUE(cell->execute(workcell::SetPlacement{cell->findByName("block")->id, Pose::translation(X_WT.p)}));
  ASSERT_TRUE(workcell::saveDocument(*cell, folder_ / "cell.hcell"));
  const auto grid = study(kGrid);
  ASSERT_TRUE(grid);
  std::string all;
  for (const Text& note : grid->notes()) all += english(note) + "\n";
  EXPECT_NE(all.find("are not checked: 'robot' with 'foot'"), std::string::npos) << all;
  const std::size_t checked = all.find("are checked: 'robot/");
  ASSERT_NE(checked, std::string::npos) << all;
  EXPECT_NE(all.find("with 'block'", checked), std::string::npos) << all;
}

TEST_F(StudyRun, ASearchComesAtLeastAsFarAsAGrid) {
  const std::string range = "[[vary]]\nwhat = \"position\"\nname = \"x\"\nentity = \"robot\"\naxis = \"x\"\n"
                            "from = -0.3\nto = 0.2\n";
  const std::string goal = "[[require]]\nvalue = \"reach.share\"\nat_least = 1.0\n"
                           "[[objective]]\nvalue = \"joint_margin.least\"\ngoal = \"greatest\"\n";
  const auto search = study(range + "[search]\nevaluations = 40\nstarts = 2\n" + kWorldTargets + goal);
  ASSERT_TRUE(search);
  const std::string rows = csvAfter(*search, "search", {.jobs = 2});
  EXPECT_EQ(csvAfter(*search, "again", {.jobs = 1}), rows);
  const auto found = bestRows(*ResultStore::open(folder_ / "search", false), 1);
  const auto grid = study(range + "steps = 11\n" + kWorldTargets + goal);
  ASSERT_TRUE(grid);
  csvAfter(*grid, "grid", {.jobs = 2});
  const auto best = bestRows(*ResultStore::open(folder_ / "grid", false), 1);
  ASSERT_TRUE(found && best && !found->empty() && !best->empty());
  if (best->front().feasible) {
    EXPECT_TRUE(found->front().feasible);
    EXPECT_LE(std::get<double>(found->front().objective), std::get<double>(best->front().objective) + 0.02);
  }
}

TEST_F(StudyRun, AnotherRobotStandsInTheSamePlace) {
  const auto robots = study(
      "[[vary]]\nwhat = \"robot\"\nname = \"which\"\nentity = \"robot\"\nvalues = [\"library:ur5e\", "
      "\"library:kuka_kr6_r900\", \"library:omnid_delta\"]\n" +
      kWorldTargets);
  ASSERT_TRUE(robots);
  const ResultRow ur = robots->evaluate(0, robots->space().values(0));
  const ResultRow kuka = robots->evaluate(1, robots->space().values(1));
  EXPECT_TRUE(ur.note.empty()) << ur.note;
  EXPECT_TRUE(kuka.note.empty()) << kuka.note;
  EXPECT_NE(ur.answers, kuka.answers);
}

TEST_F(StudyRun, RefusesNamesThatDoNotExist) {
  std::ofstream(folder_ / "s.hstudy") << "cell = \"cell.hcell\"\n" << kGrid << "[[objective]]\nvalue = \"reach.shore\"\n";
  const auto wrong = Study::load(folder_ / "s.hstudy", "test");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message().find("reach.share"), std::string::npos) << wrong.error().message();
  std::ofstream(folder_ / "s.hstudy") << "cell = \"cell.hcell\"\n[[vary]]\nwhat = \"position\"\nentity = \"rabot\"\n"
                                         "axis = \"x\"\nvalues = [1.0]\n[[ask]]\nwhat = \"reach\"\n";
  const auto entity = Study::load(folder_ / "s.hstudy", "test");
  ASSERT_FALSE(entity);
  EXPECT_NE(entity.error().message().find("line 2"), std::string::npos) << entity.error().message();
  EXPECT_NE(entity.error().message().find("robot"), std::string::npos);
}

}  // namespace
}  // namespace hapticell::studies
