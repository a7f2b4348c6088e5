// SPDX-License-Identifier: Apache-2.0
// The dock ROS 2 in the whole window under a virtual display; another hapticell-ros2 plays the robot.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTemporaryDir>

#include "app/host/document_model.h"
#include "app/host/language.h"
#include "app/ros2/cell_copy.h"
#include "app/ros2/description_section.h"
#include "app/ros2/ros2_process.h"
#include "app/style/library_text.h"
#include "app/style/segmented.h"
#include "config/configuration.h"
#include "tests/app/pages/window_page.h"
#include "tests/support/ros2_domains.h"
#include "workcell/document/command.h"

namespace hapticell::app {
namespace {

constexpr int kDomain = test::kWindowDomain;

class Ros2Page : public WindowPage {
 public:
  Ros2Page() {
    trigger("actionRos2");
    find<QSpinBox>("spinRos2Domain")->setValue(kDomain);
    find<QCheckBox>("switchRos2ThisMachine")->setChecked(true);
    const auto folder = config::findShippedFile("workcells");
    is_open_ = folder && open(QString::fromStdString(*folder + "/demo.hcell"));
  }
  bool isOpen() const { return is_open_; }
  template <class Widget>
  Widget* find(const char* name) {
    auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << (name ? name : "");
    return found;
  }
  void click(const char* button) {
    find<QAbstractButton>(button)->click();
    settle();
  }
  QString topicsText() { return find<QPlainTextEdit>("textRos2Topics")->toPlainText(); }
  /// Another program that publishes the robot of the cell, its second joint turned by `turn`, until the page ends.
  const Ros2Process* playRobot(double turn) {
    workcell::Document other = window().documentModel().document();
    std::vector<double> joints = robot().joints();
    joints[1] += turn;
    EXPECT_TRUE(other.execute(workcell::SetJoints{robot().id, joints}));
    const auto cell = other_cell_.write(other);
    EXPECT_TRUE(cell);
    played_.start({{"do", "publish"}, {"domain", kDomain}, {"this_machine", true}, {"workcell", cell.value_or("")}, {"entity", "robot"}, {"seconds", 0}});
    return &played_;
  }
  std::string text(const char* label) { return find<QLabel>(label)->text().toStdString(); }
  const workcell::Entity& robot() { return *window().documentModel().document().findByName("robot"); }
  /// The first step of a motion from where the robot is, kept in the cell: `step` rad of a joint in half a second.
  void keepMotion(std::size_t joint, double step) {
    trajectory::Trajectory motion;
    motion.name = "step";
    motion.entity = "robot";
    motion.has_poses = false;
    for (const int moving : robot().robot()->moving)
      motion.joint_names.push_back(robot().robot()->joints[static_cast<std::size_t>(moving)].name);
    for (int i = 0; i <= 20; ++i) {
      const double s = i / 20.0;
      std::vector<double> joints = robot().joints();
      joints[joint] += step * s * s * (3.0 - 2.0 * s);
      motion.addFrame({0.5 * s, {}}, joints);
    }
    ASSERT_TRUE(window().documentModel().execute(
        workcell::AddTrajectory{{"step", folder_.filePath("step.htraj").toStdString(),
                                 std::make_shared<const trajectory::Trajectory>(std::move(motion))}}));
  }

 private:
  QTemporaryDir folder_;
  CellCopy other_cell_;
  Ros2Process played_;
  bool is_open_ = false;
};

TEST(Ros2Dock, PublishesTheRobotAndListsWhoElseIsThere) {
  Ros2Page page;
  ASSERT_TRUE(page.isOpen());
  EXPECT_EQ(page.find<QComboBox>("choiceRos2Robot")->currentText(), "robot");
  EXPECT_EQ(page.text("labelRos2"), "Off. Nothing is published or received.");
  page.click("buttonRos2");
  Ros2Process listener;
  QJsonArray heard;
  QObject::connect(&listener, &Ros2Process::said, &listener, [&heard](const QJsonObject& line) {
    if (line.contains("heard")) heard = line.value("heard").toArray();
  });
  CellCopy copy;
  const auto cell = copy.write(page.window().documentModel().document());
  ASSERT_TRUE(cell);
  listener.start({{"do", "link"}, {"domain", kDomain}, {"this_machine", true}, {"workcell", *cell}, {"entity", "robot"}, {"mirror", true}});
  std::vector<double> joints = page.robot().joints();
  joints[1] -= 0.05;
  ASSERT_TRUE(page.window().documentModel().execute(workcell::SetJoints{page.robot().id, joints}));
  EXPECT_TRUE(Ros2Page::until([&] { return !heard.isEmpty() && std::abs(heard[1].toDouble() - joints[1]) < 1e-12; }, 60000));
  EXPECT_TRUE(Ros2Page::until([&] { return page.text("labelRos2").ends_with("programs that read them: 1"); }, 60000))
      << page.text("labelRos2");
  EXPECT_TRUE(page.find<QPlainTextEdit>("textRos2Topics")->toPlainText().contains("/joint_states\n    sensor_msgs/JointState, 0 → 1"))
      << page.find<QPlainTextEdit>("textRos2Topics")->toPlainText().toStdString();
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until([&] { return page.text("labelRos2") == "Off. Nothing is published or received."; }, 60000))
      << page.text("labelRos2");
}

TEST(Ros2Dock, TheRobotFollowsAnotherOneAndReturns) {
  Ros2Page page;
  ASSERT_TRUE(page.isOpen());
  const std::vector<double> before = page.robot().joints();
  std::vector<double> there = before;
  there[1] -= 0.125;
  workcell::Document other = page.window().documentModel().document();
  ASSERT_TRUE(other.execute(workcell::SetJoints{page.robot().id, there}));
  CellCopy copy;
  const auto cell = copy.write(other);
  ASSERT_TRUE(cell);
  Ros2Process robot;
  robot.start({{"do", "publish"}, {"domain", kDomain}, {"this_machine", true}, {"workcell", *cell}, {"seconds", 0}});
  page.find<Segmented>("segmentsRos2Way")->setCurrent(1);
  page.click("buttonRos2");
  const auto follows = [&] { return std::abs(page.robot().joints()[1] - there[1]) < 1e-12; };
  EXPECT_TRUE(Ros2Page::until(follows, 60000));
  EXPECT_FALSE(page.window().documentModel().isDirty());
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until([&] { return page.robot().joints() == before; }, 60000));
  EXPECT_TRUE(Ros2Page::until([&] { return page.find<Segmented>("segmentsRos2Way")->isEnabled(); }, 60000));
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until(follows, 60000));
  page.click("buttonRos2KeepPose");
  EXPECT_TRUE(follows());
  EXPECT_TRUE(page.window().documentModel().isDirty());
}

TEST(Ros2Dock, FindsTopicsMirrorsTheChosenOneAndImportsTheRobot) {
  Ros2Page page;
  ASSERT_TRUE(page.isOpen());
  auto* joints = page.find<QComboBox>("choiceRos2Joints");
  EXPECT_EQ(joints->currentText(), "/joint_states");
  EXPECT_FALSE(joints->isEnabled()) << "published is always there";
  EXPECT_EQ(page.text("labelRos2Topics"), "Press 'Find topics' to see what other programs publish.");
  const Ros2Process* const robot = page.playRobot(-0.125);
  ASSERT_TRUE(robot->isRunning());
  page.click("buttonRos2Topics");
  EXPECT_TRUE(Ros2Page::until([&] { return page.find<QComboBox>("choiceRos2Description")->findText("/robot_description") >= 0 &&
                                           page.topicsText().contains("/robot_description\n    std_msgs/String, 1 → 0"); }, 60000))
      << page.topicsText().toStdString();
  // And the whole robot, from its description.
  const std::size_t entities = page.entities();
  const QTemporaryDir folder;
  const QString path = folder.filePath("heard.urdf");
  page.find<DescriptionSection>(nullptr)->importTo(path);
  EXPECT_TRUE(Ros2Page::until([&] { return page.entities() > entities; }, 60000)) << page.text("labelRos2Import");
  EXPECT_TRUE(QFile::exists(path));
  const auto& all = page.window().documentModel().document().state().entities;
  EXPECT_EQ(all.back()->robot()->moving.size(), page.robot().robot()->moving.size());
  page.window().documentModel().undo();
  EXPECT_EQ(page.entities(), entities) << "one step of undo";
  page.find<Segmented>("segmentsRos2Way")->setCurrent(1);
  page.find<Segmented>("segmentsRos2Way")->chosen(1);
  EXPECT_TRUE(joints->isEnabled());
  joints->setEditText("nobody/joint_states");
  const std::vector<double> before = page.robot().joints();
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until([&] { return page.text("labelRos2") == "On. The robot follows /nobody/joint_states, 0 messages a second."; }, 60000))
      << page.text("labelRos2");
  EXPECT_EQ(page.robot().joints(), before);
  EXPECT_FALSE(joints->isEnabled());
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until([&] { return joints->isEnabled(); }, 60000));
  joints->setCurrentIndex(joints->findText("/joint_states"));
  page.click("buttonRos2");
  EXPECT_TRUE(Ros2Page::until([&] { return std::abs(page.robot().joints()[1] - before[1] + 0.125) < 1e-12; }, 60000));
}

/// The window's sentences in a language for as long as this lives.
class InLanguage {
 public:
  explicit InLanguage(const char* language) : is_there_(translator_.loadLanguage(language)) {
    if (is_there_) QCoreApplication::installTranslator(&translator_);
  }
  ~InLanguage() { QCoreApplication::removeTranslator(&translator_); }
  InLanguage(const InLanguage&) = delete;
  InLanguage& operator=(const InLanguage&) = delete;
  bool isThere() const { return is_there_; }

 private:
  Translator translator_;
  bool is_there_;
};

TEST(Ros2Process, SaysWhyNotInTheLanguageOfTheWindow) {
  const InLanguage french("fr");
  if (!french.isThere()) GTEST_SKIP() << "built without Qt's Linguist tools";
  Ros2Process process;
  QString said;
  QObject::connect(&process, &Ros2Process::ended, &process, [&said](const QJsonObject& result, const QString& sentence) {
    EXPECT_TRUE(result.isEmpty());
    said = sentence;
  });
  process.start({{"do", "listen"}, {"domain", kDomain}, {"this_machine", true}, {"texts", true}, {"seconds", 0.01}, {"description", "/nowhere/a.urdf"},
                 {"description_topic", "/nobody"}});
  EXPECT_TRUE(Ros2Page::until([&] { return !said.isEmpty(); }, 60000));
  EXPECT_EQ(said, shownText(Error{"/nobody", "", Text("no message within %1 s", 1), "a program that publishes it",
                                  "Check ROS_DOMAIN_ID on both sides, and that the network lets multicast through."}));
  EXPECT_FALSE(said.contains("no message within") || said.contains("Check ROS_DOMAIN_ID")) << said.toStdString();
}

TEST(Ros2Dock, AsksBeforeARobotMoves) {
  Ros2Page page;
  ASSERT_TRUE(page.isOpen());
  page.keepMotion(1, -0.1);
  EXPECT_FALSE(page.find<QAbstractButton>("buttonRos2Send")->isEnabled());
  page.find<QLineEdit>("fieldRos2Action")->setText("arm/follow_joint_trajectory");
  page.click("buttonRos2Send");
  const auto box = [&] { return page.window().findChild<QMessageBox*>("boxRos2Confirm"); };
  ASSERT_TRUE(Ros2Page::until([&] { return box() != nullptr; }, 60000)) << page.text("labelRos2Motion");
  EXPECT_TRUE(box()->text().startsWith("The real robot 'robot' will move for 0.5 s, its tool at up to 250 mm/s"))
      << box()->text().toStdString();
  EXPECT_TRUE(box()->informativeText().contains("Action: /arm/follow_joint_trajectory"));
  EXPECT_FALSE(page.find<QAbstractButton>("buttonRos2Stop")->isEnabled());
  box()->reject();
  EXPECT_TRUE(Ros2Page::until([&] { return page.text("labelRos2Motion") == "Not sent."; }, 60000)) << page.text("labelRos2Motion");
}

TEST(Ros2Dock, RefusesAMotionThatMeetsTheCell) {
  Ros2Page page;
  ASSERT_TRUE(page.isOpen());
  page.keepMotion(0, 0.1);
  page.find<QLineEdit>("fieldRos2Action")->setText("/arm/follow_joint_trajectory");
  page.click("buttonRos2Send");
  EXPECT_TRUE(Ros2Page::until([&] { return page.text("labelRos2Motion").find("meets 'Clamp tower A'") != std::string::npos; }, 60000))
      << page.text("labelRos2Motion");
  EXPECT_EQ(page.window().findChild<QMessageBox*>("boxRos2Confirm"), nullptr);
}

}  // namespace
}  // namespace hapticell::app
