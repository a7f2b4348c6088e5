// SPDX-License-Identifier: Apache-2.0
// The trainer's first hour by real events: a part, an expert's gesture, an exercise of one's own, shown, run with
// forces and scored; the cell is as it was.
#include <gtest/gtest.h>

#include <QFileInfo>
#include <QPlainTextEdit>

#include "app/host/document_model.h"
#include "app/trajectory/training/training_panel.h"
#include "tests/app/pages/walk_page.h"

namespace hapticell::app {
namespace {

struct TrainerWalk : WalkPage {
  TrainingPanel& panel() { return *window().findChild<TrainingPanel*>(); }
  double boxAt() { return document().find(box)->X_WE.p.x; }
  /// With the box in the hand to the right, until `done`.
  template <class Done>
  void leadUntil(Done done) {
    pointInto(0.4, 0.4);
    press(Qt::Key_H);
    press(Qt::Key_B);
    ASSERT_TRUE(until([this] { return now().stylus.held == box; }, kPatience));
    // Steps of a hand, and back a little where it went too far: on a slow machine a step is felt late.
    for (int i = 0; i < 90 && !done(); ++i) {
      drag(i < 60 ? 4 : -4, 0);
      until(done, 30);
    }
    EXPECT_TRUE(until(done, kPatience));
    press(Qt::Key_B);
    press(Qt::Key_H);
  }
  void buildCell() {
    choose("menuInsert", "actionInsertPart");
    clickText("listParts", "Box");
    clickOn("buttonInsertPart");
    ASSERT_TRUE(until([this] { return entities() == 1u; }, kPatience));
    box = window().selection().current();
    pointInto(0.4, 0.4);
    press(Qt::Key_F, Qt::ShiftModifier);
    picture("trainer-1-part");
  }
  void recordExpert() {
    press(Qt::Key_Space, Qt::ControlModifier);
    ASSERT_TRUE(until([this] { return now().stylus.forces_on; }, kPatience));
    pointInto(0.4, 0.4);
    clickTool("actionRecord");
    const double from = boxAt();
    int moves = 0;
    leadUntil([&] { return ++moves > 25; });
    clickTool("actionRecord");
    ASSERT_TRUE(until([this] { return state().trajectories.size() == 1u; }, kPatience));
    EXPECT_NE(boxAt(), from);
    press(Qt::Key_Escape);
    EXPECT_TRUE(until([this] { return !now().stylus.forces_on; }, kPatience));
    withFile(folder.filePath("cell.hcell"), [this] { clickTool("actionSave"); });
    ASSERT_TRUE(until([this] { return !window().documentModel().isDirty(); }, kPatience));
    picture("trainer-2-recorded");
  }
  void makeExercise() {
    choose("menuTrajectory", "actionTraining");
    panel().setExercises(folder.filePath("own"));
    panel().setResults(folder.filePath("ana.htrain"));
    clickOn("buttonNewExercise");
    clickOn("editExerciseName");
    typeText("Bring it over");
    press(Qt::Key_Tab);
    typeText("Lead the box to the right.");
    picture("trainer-3-exercise");
    clickOn("buttonSaveExercise");
    ASSERT_TRUE(until([this] { return QFileInfo::exists(folder.filePath("own/Bring-it-over.hexercise")); }, kPatience));
    EXPECT_EQ(find<QComboBox>("comboExercise")->currentText(), "Bring it over");
  }
  workcell::EntityId box = 0;
  QTemporaryDir folder;
};

TEST(TrainerWalk, AnOwnExerciseMadeShownRunAndScored) {
  TrainerWalk walk;
  walk.buildCell();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.recordExpert();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.makeExercise();
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  walk.clickOn("buttonShowMe");
  WalkPage::until([] { return false; }, 400);
  walk.picture("trainer-4-shown");
  walk.clickOn("buttonShowMe");
  const double rest = walk.boxAt();
  const auto steps = walk.document().undoTexts();
  walk.clickOn("buttonStartRun");
  ASSERT_TRUE(walk.panel().isRunning());
  EXPECT_TRUE(WalkPage::until([&] { return walk.now().stylus.forces_on; }, WalkPage::kPatience)) << "switched on by Start";
  walk.leadUntil([&] { return !walk.panel().isRunning(); });
  ASSERT_EQ(walk.panel().session().attempts.size(), 1u);
  EXPECT_EQ(walk.panel().session().attempts.front().score.completed, 1.0);
  EXPECT_NEAR(walk.boxAt(), rest, 1e-9) << "back in its place";
  EXPECT_FALSE(walk.window().documentModel().isDirty());
  EXPECT_EQ(walk.document().undoTexts(), steps);
  walk.picture("trainer-5-scored");
  std::puts(walk.counted().c_str());
  EXPECT_LE(walk.clicks(), 15) << walk.counted();
  EXPECT_LE(walk.keys(), 15) << walk.counted();
}

}  // namespace
}  // namespace hapticell::app
