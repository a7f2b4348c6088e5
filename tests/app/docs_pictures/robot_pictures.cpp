// SPDX-License-Identifier: Apache-2.0
// Pictures of the docks of robots.
#include <QLabel>
#include <QPlainTextEdit>
#include <QTableView>

#include "app/studies/study_panel.h"
#include "tests/app/docs_pictures/picture_page.h"

namespace hapticell::app {
namespace {

/// A configuration beside the present one, as a ghost.
void configurations(const PictureTask& task) {
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({2.45, -1.85, 1.85}, {0.72, 0.1, 0.80});
  page.showDock("dockCollisions");
  page.select(page.document().findByName("robot")->id);
  page.showDock("dockRobot");
  auto* table = page.find<QTableView>("tableConfigurations");
  ASSERT_NE(table, nullptr);
  constexpr int kRow = 2;
  ASSERT_TRUE(PicturePage::until([&] { return table->model()->rowCount() > kRow; }, PicturePage::kPatience));
  PicturePage::rest(2000);  // The ways there are computed, and the rows sorted by them.
  page.click(table->viewport(), table->visualRect(table->model()->index(kRow, 0)).center());
  const auto ghosts = [&] { return page.window().viewport().scene().ghosts().size(); };
  ASSERT_TRUE(PicturePage::until([&] { return ghosts() == 1u; }, PicturePage::kPatience)) << "no ghost";
  page.keep();
}

void library(const PictureTask& task) {
  PicturePage page(PictureTask{task.name, {1200, 800}, task.dock, task.file, {}}, Stylus::kNone);
  page.trigger("actionAddRobot");
  page.keepDock(task.size);
}

/// Places of a robot at the car door, coloured, with one of them shown in the scene.
void study(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("studies/car-door.hcell"));
  page.trigger("actionStudy");
  auto* panel = page.find<StudyPanel>("studyPanel");
  ASSERT_NE(panel, nullptr);
  const auto folder = page.document().path().parent_path();
  panel->openFile(QString::fromStdString((folder / "car-door-robot.hstudy").string()));
  page.press("buttonRunStudy");
  auto* rows = page.find<QTableView>("tableResults");
  constexpr int kVariants = 49;
  constexpr int kRun = 10 * PicturePage::kPatience;
  ASSERT_TRUE(PicturePage::until([&] { return rows->model()->rowCount() == kVariants; }, kRun));
  page.chooseSegment("segmentsResults", 1);
  page.lookFrom(-40, 35, page.window().viewport().scene().bounds_W());
  page.keep();
}

/// Statements typed into the console: what they print, and a row of parts that they have added.
void pythonConsole(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.look({2.45, -1.85, 1.85}, {0.72, 0.1, 0.80});
  page.activate();
  page.trigger("actionPythonConsole");
  auto* field = page.find<QPlainTextEdit>("fieldConsoleInput");
  auto* state = page.find<QLabel>("labelConsoleState");
  auto* output = page.find<QPlainTextEdit>("textConsoleOutput");
  ASSERT_TRUE(field != nullptr && state != nullptr && output != nullptr);
  const auto ready = [&] { return state->text().contains("ready"); };
  ASSERT_TRUE(PicturePage::until(ready, PicturePage::kPatience)) << output->toPlainText().toStdString();
  const auto run = [&](const QString& statement, const QString& expected) {
    QTest::keyClicks(field, statement);
    QTest::keyClick(field, Qt::Key_Return);
    return PicturePage::until([&] { return output->toPlainText().contains(expected) && ready(); }, PicturePage::kPatience);
  };
  ASSERT_TRUE(run("cell", "<Workcell"));
  ASSERT_TRUE(run("[len(cell.robot('robot').ik_all(cell.robot('robot').fk()))]", "\n["));
  const auto steps = page.document().undoTexts().size();
  ASSERT_TRUE(run("cell.add('sphere:0.06', name='ball', pose=[0.55, -0.35, 1.0, 1, 0, 0, 0])", "['ball']"));
  ASSERT_TRUE(PicturePage::until([&] { return page.document().undoTexts().size() > steps; }, PicturePage::kPatience));
  ASSERT_TRUE(run("cell.move('bal', None)", "no entity is named 'bal'"));
  ASSERT_TRUE(run("cell.distances('ball', 0.5)", "\n>>> cell.distances"));
  page.keep();
}

}  // namespace

std::vector<DocsPicture> robotPictures() {
  return {{"robot-configurations", {1300, 731}, "dockRobot", configurations, {1600, 900}},
          {"robot-library", {345, 980}, "dockAddRobot", library},
          {"python-console", {1300, 731}, "dockPythonConsole", pythonConsole, {1600, 900}},
          {"study", {1600, 1000}, "dockStudyResults", study}};
}

}  // namespace hapticell::app
