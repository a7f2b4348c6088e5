// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/robot_link_section.h"

#include <QComboBox>
#include <QJsonArray>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/ros2/ros2_network.h"
#include "app/ros2/ros2_topics.h"
#include "app/style/library_text.h"
#include "app/style/live_label.h"
#include "app/style/segmented.h"

namespace hapticell::app {

namespace {

// As often as robots publish their joints. Half: the robot jerks in RViz; twice: the same with more work.
constexpr int kPoseMilliseconds = 20;

QJsonArray jsonOf(const std::vector<double>& numbers) {
  QJsonArray list;
  for (const double number : numbers) list.append(number);
  return list;
}

}  // namespace

RobotLinkSection::RobotLinkSection(Host& host, const Ros2Network& network, Ros2Topics& topics, QWidget* parent)
    : QWidget(parent), host_(host), network_(network), topics_(topics) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout& section = *addSection(*column, tr("Robot"));
  robot_ = new QComboBox;
  robot_->setObjectName("choiceRos2Robot");
  addRow(section, tr("Robot"), robot_);
  way_ = new Segmented({tr("Publish"), tr("Mirror")});
  way_->setObjectName("segmentsRos2Way");
  way_->setToolTip(tr("Publish: joints, frames, description and scene of the robot as it moves here. Mirror: the robot here "
                      "follows the joint states of another program."));
  way_->setCurrent(0);
  addRow(section, tr("Direction"), way_);
  joints_ = new TopicChoice("choiceRos2Joints", topics, "sensor_msgs::msg::dds_::JointState_", "/joint_states");
  joints_->setToolTip(tr("Topic of the joint states that the robot here follows. Default: /joint_states"));
  addRow(section, tr("Joint states"), joints_);
  start_ = makeButton("buttonRos2", tr("Start the link"));
  keep_ = makeButton("buttonRos2KeepPose", tr("Keep pose"), tr("Set the robot of the cell to the received joints, as one undo step"));
  section.addWidget(sideBySide({start_, keep_}));
  line_ = makeLive(3, TextRole::kSecond, true);
  line_->setObjectName("labelRos2");
  section.addWidget(line_);
  timer_.setInterval(kPoseMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &RobotLinkSection::sendPose);
  connect(way_, &Segmented::chosen, this, &RobotLinkSection::show);
  connect(start_, &QPushButton::clicked, this, &RobotLinkSection::toggle);
  connect(keep_, &QPushButton::clicked, this, &RobotLinkSection::keepPose);
  connect(&process_, &Ros2Process::said, this, &RobotLinkSection::take);
  connect(&process_, &Ros2Process::ended, this, [this](const QJsonObject&, const QString& sentence) { finish(sentence); });
  connect(&host_.documentModel(), &DocumentModel::changed, this, &RobotLinkSection::show);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    mirrors_ = false;  // The trial ends with its document.
    process_.stop();
  });
  connect(&host_.documentModel(), &DocumentModel::trialEnded, this, [this] {
    if (mirrors_) process_.stop();
    mirrors_ = false;
  });
  show();
}

bool RobotLinkSection::isMirror() const {
  return way_->current() == 1;
}

void RobotLinkSection::toggle() {
  if (process_.isRunning()) {
    process_.stop();
  } else {
    begin();
  }
  show();
}

void RobotLinkSection::begin() {
  problem_.clear();
  figures_.clear();
  heard_.clear();
  const workcell::Document& document = host_.documentModel().document();
  const workcell::Entity* const robot = document.findByName(robot_->currentText().toStdString());
  if (!robot) return;
  const auto copy = copy_.write(document);
  if (!copy) {
    problem_ = shownText(copy.error());
    return;
  }
  entity_ = robot->id;
  QJsonObject job = network_.job("link");
  job["workcell"] = *copy;
  job["entity"] = robot_->currentText();
  job["mirror"] = isMirror();
  job["joint_topic"] = joints_->topic();
  process_.start(job);
  if (isMirror()) {
    host_.documentModel().beginTrial();
    mirrors_ = true;
  } else {
    timer_.start();
  }
}

void RobotLinkSection::sendPose() {
  const workcell::Entity* const robot = host_.documentModel().document().find(entity_);
  if (!robot) return process_.stop();
  Pose X_WE = robot->X_WE;
  std::vector<double> joints = robot->joints();
  if (const auto& snapshot = host_.snapshot())
    for (const auto& state : snapshot->entities)
      if (state.id == entity_) X_WE = state.X_WE, joints = state.joints;
  process_.write({{"joints", jsonOf(joints)},
                  {"place", jsonOf({X_WE.p.x, X_WE.p.y, X_WE.p.z, X_WE.q.w, X_WE.q.x, X_WE.q.y, X_WE.q.z})}});
}

void RobotLinkSection::take(const QJsonObject& line) {
  if (line.contains("heard")) return takeHeard(line.value("heard").toArray());
  if (!line.contains("topics")) return;
  topics_.take(line.value("topics").toArray());
  if (mirrors_) {
    figures_ = tr("On. The robot follows %1, %2 messages a second.")
                   .arg(joints_->topic())
                   .arg(qRound(line.value("heard_hz").toDouble()));
  } else {
    figures_ = tr("On. Published joint states: %1; programs that read them: %2")
                   .arg(line.value("published").toObject().value("/joint_states").toInt())
                   .arg(line.value("readers").toObject().value("/joint_states").toInt());
  }
  show();
}

void RobotLinkSection::takeHeard(const QJsonArray& joints) {
  const workcell::Entity* const robot = host_.documentModel().document().find(entity_);
  if (!mirrors_ || !robot || robot->joints().size() != static_cast<std::size_t>(joints.size())) return;
  heard_.clear();
  for (const auto& joint : joints) heard_.push_back(joint.toDouble());
  host_.documentModel().executeWithin({workcell::SetJoints{entity_, heard_}});
}

void RobotLinkSection::keepPose() {
  const std::vector<double> joints = heard_;
  if (mirrors_) host_.documentModel().endTrial();
  if (!joints.empty()) host_.documentModel().execute(workcell::SetJoints{entity_, joints});
  show();
}

void RobotLinkSection::finish(const QString& sentence) {
  timer_.stop();
  problem_ = sentence;
  if (std::exchange(mirrors_, false)) host_.documentModel().endTrial();
  show();
}

void RobotLinkSection::show() {
  const bool is_on = process_.isRunning();
  const QStringList robots = robotNames(host_.documentModel().document());
  QStringList shown;
  for (int i = 0; i < robot_->count(); ++i) shown << robot_->itemText(i);
  if (shown != robots && !is_on) {
    const QString chosen = robot_->currentText();
    robot_->clear();
    robot_->addItems(robots);
    robot_->setCurrentIndex(std::max(0, static_cast<int>(robots.indexOf(chosen))));
  }
  robot_->setEnabled(!is_on);
  way_->setEnabled(!is_on);
  joints_->setEnabled(!is_on && isMirror());
  start_->setEnabled(is_on || !robots.isEmpty());
  start_->setText(is_on ? tr("Stop the link") : tr("Start the link"));
  keep_->setEnabled(mirrors_ && !heard_.empty());
  if (!problem_.isEmpty()) return line_->setText(problem_);
  if (robots.isEmpty()) return line_->setText(tr("The cell has no robot."));
  if (!is_on) return line_->setText(tr("Off. Nothing is published or received."));
  line_->setText(figures_.isEmpty() ? tr("Starting…") : figures_);
}

}  // namespace hapticell::app
