// SPDX-License-Identifier: Apache-2.0
// Pictures of the docks of robots.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTest>
#include <QTableView>

#include "app/ros2/cell_copy.h"
#include "app/ros2/ros2_process.h"
#include "app/studies/study_panel.h"
#include "tests/app/docs_pictures/picture_page.h"
#include "tests/support/ros2_domains.h"

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

/// The way of a gear once the parts before it have gone.
void access(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("access/gearbox.hcell"));
  page.trigger("actionAccess");
  const workcell::Entity* gear = page.document().findByName("gear 1");
  ASSERT_NE(gear, nullptr);
  page.window().selection().set(gear->id);
  page.press("buttonAccessPart");
  page.press("buttonAccessAsk");
  auto* steps = page.find<QListWidget>("listAccessSteps");
  constexpr int kSearch = 10 * PicturePage::kPatience;
  ASSERT_TRUE(PicturePage::until([&] { return steps->count() > 0; }, kSearch));
  page.press("buttonAccessAside");
  page.lookFrom(-40, 35, page.window().viewport().scene().bounds_W());
  page.keep();
}

/// A way of the shipped robot to other joints, with its figures.
void planning(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.select(page.document().findByName("robot")->id);
  page.trigger("actionPlanPath");
  page.chooseEntry("choicePlanGoal", "Joints");
  page.press("buttonPlanTake");
  auto* joints = page.find<QLineEdit>("editPlanJoints");
  ASSERT_NE(joints, nullptr);
  QStringList words = joints->text().split(';');
  ASSERT_EQ(words.size(), 6);
  constexpr double kTurn = 40.0, kLift = -25.0;  // degrees
  words[0] = QString::number(words[0].toDouble() + kTurn);
  words[1] = QString::number(words[1].toDouble() + kLift);
  joints->setText(words.join(";"));
  page.press("buttonPlanPath");
  constexpr int kSearch = 10 * PicturePage::kPatience;
  const auto* stop = page.find<QAbstractButton>("buttonPlanStop");
  ASSERT_TRUE(PicturePage::until([&] { return !stop->isEnabled(); }, kSearch));
  page.look({2.45, -1.85, 1.85}, {0.72, 0.1, 0.80});
  page.keep();
}

/// The mannequin at the sill of the trunk, with the wish of each agent.
void agents(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("agents/trunk.hcell"));
  const workcell::Entity* worker = page.document().findByName("worker");
  ASSERT_NE(worker, nullptr);
  page.select(worker->id);
  page.trigger("actionAgents");
  page.press("buttonAgentEntity");
  page.type("fieldAgentGoalX", "930");
  page.type("fieldAgentGoalY", "-160");
  page.type("fieldAgentGoalZ", "800");
  page.press("buttonAgentsStart");
  const auto* says = page.find<QLabel>("labelAgentsSay");
  ASSERT_TRUE(PicturePage::until([&] { return says->text().contains("sill"); }, 10 * PicturePage::kPatience));
  page.lookFrom(-40, 25, page.window().viewport().scene().bounds_W());
  page.keep();
}

/// The demonstration cell asked and changed from the console.
void console(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.trigger("actionPythonConsole");
  auto* state = page.find<QLabel>("labelConsoleState");
  auto* field = page.find<QPlainTextEdit>("fieldConsoleInput");
  auto* output = page.find<QPlainTextEdit>("textConsoleOutput");
  ASSERT_TRUE(state && field && output);
  const auto isReady = [&] { return state->text().contains("ready"); };
  ASSERT_TRUE(PicturePage::until(isReady, PicturePage::kPatience)) << state->text().toStdString();
  const char* const statements[]{"robot = cell['robot']", "robot.joints.round(2)", "cell.distances('robot')[0].distance",
                                 "cell.set_joints('robot', robot.joints + [0.3, 0, 0, 0, 0, 0])"};
  for (const char* statement : statements) {
    field->setPlainText(statement);
    QTest::keyClick(field, Qt::Key_Return);
    PicturePage::rest(300);
    ASSERT_TRUE(PicturePage::until(isReady, PicturePage::kPatience)) << statement;
  }
  EXPECT_FALSE(output->toPlainText().contains("Error")) << output->toPlainText().toStdString();
  page.look({2.45, -1.85, 1.85}, {0.72, 0.1, 0.80});
  page.keep();
}

/// The robot of the demonstration follows another program, whose topics are listed.
void ros2(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  ASSERT_TRUE(page.openShipped("workcells/demo.hcell"));
  page.trigger("actionRos2");
  constexpr int kDomain = test::kPicturesDomain;
  page.find<QSpinBox>("spinRos2Domain")->setValue(kDomain);
  page.find<QCheckBox>("switchRos2ThisMachine")->setChecked(true);
  const workcell::EntityId robot = page.document().findByName("robot")->id;
  const double turned = page.document().find(robot)->joints()[0] + 0.4;
  workcell::Document other = page.document();
  std::vector<double> joints = page.document().find(robot)->joints();
  joints[0] = turned;
  ASSERT_TRUE(other.execute(workcell::SetJoints{robot, joints}));
  CellCopy copy;
  const auto cell = copy.write(other);
  ASSERT_TRUE(cell);
  Ros2Process played;
  played.start({{"do", "publish"}, {"domain", kDomain}, {"this_machine", true}, {"workcell", *cell}, {"seconds", 0}});
  page.press("buttonRos2Topics");
  const auto* list = page.find<QPlainTextEdit>("textRos2Topics");
  const auto* find = page.find<QAbstractButton>("buttonRos2Topics");
  ASSERT_TRUE(PicturePage::until([&] { return list->toPlainText().contains("/joint_states") && find->isEnabled(); }, PicturePage::kPatience));
  page.chooseSegment("segmentsRos2Way", 1);
  page.press("buttonRos2");
  const auto follows = [&] { return std::abs(page.document().find(robot)->joints()[0] - turned) < 1e-9; };
  ASSERT_TRUE(PicturePage::until(follows, PicturePage::kPatience)) << "it does not follow";
  const auto* says = page.find<QLabel>("labelRos2");
  ASSERT_TRUE(PicturePage::until([&] { return says->text().startsWith("On."); }, PicturePage::kPatience));
  page.look({2.45, -1.85, 1.85}, {0.72, 0.1, 0.80});
  page.keep();
}

}  // namespace

std::vector<DocsPicture> robotPictures() {
  return {{"robot-configurations", {1300, 731}, "dockRobot", configurations, {1600, 900}},
          {"robot-library", {345, 980}, "dockAddRobot", library},
          {"study", {1600, 1000}, "dockStudyResults", study},
          {"access", {1600, 1000}, "dockAccess", access},
          {"planning", {1600, 1000}, "dockPlan", planning},
          {"agents", {1600, 1000}, "dockAgents", agents},
          {"python-console", {1600, 1000}, "dockPythonConsole", console},
          {"ros2", {1600, 1000}, "dockRos2", ros2}};
}

}  // namespace hapticell::app
