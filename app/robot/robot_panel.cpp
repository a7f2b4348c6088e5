// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_panel.h"

#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/robot/cartesian_jog.h"
#include "app/robot/configuration_view.h"
#include "app/robot/holding_view.h"
#include "app/robot/joint_jog.h"
#include "app/robot/joint_mover.h"
#include "app/robot/load_line.h"
#include "app/robot/robot_context.h"
#include "app/robot/robot_stop.h"
#include "app/robot/robot_thumbnail.h"
#include "app/robot/stop_line.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/units.h"
#include "kinematics/model/jog.h"
#include "workcell/entity/named_poses.h"

namespace hapticell::app {
namespace {

constexpr JogStepSize kSteps[]{{0.1, 0.1}, {1.0, 1.0}, {5.0, 10.0}, {15.0, 50.0}};

QWidget* section(QVBoxLayout& column, const QString& heading, QVBoxLayout*& inside) {
  auto* holder = new QWidget;
  auto* rows = new QVBoxLayout(holder);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  inside = addSection(*rows, heading);
  column.addWidget(holder);
  return holder;
}

}  // namespace

RobotPanel::RobotPanel(RobotContext& context, MotionWorker& worker, JointMover& mover, QWidget* parent)
    : QWidget(parent), context_(context), mover_(mover) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addEmptyState(*column);
  content_ = new QWidget;
  column->addWidget(content_);
  column->addStretch(1);
  auto* inside = new QVBoxLayout(content_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(0);
  addHeading(*inside);
  addHolding(*inside);
  QVBoxLayout* list = nullptr;
  choosing_ = section(*inside, {}, list);
  configurations_ = new ConfigurationView(context, worker, mover);
  list->addWidget(configurations_);
  addJog(*inside);
  addMechanism(*inside);
  connect(&context_, &RobotContext::robotChanged, this, &RobotPanel::showRobot);
  connect(&context_, &RobotContext::documentChanged, this, [this] {
    held_->showNow();
    showNow();
  });
  connect(&mover_, &JointMover::stopped, this, [this](const QString& why, const QString& obstacle) {
    stop_->setStopped(why, obstacle);
    showNow();
  });
  connect(cartesian_, &CartesianJog::held, this, &RobotPanel::showHeldBack);
  connect(cartesian_, &CartesianJog::frameChosen, this,
          [this] { emit jogFrameChosen(cartesian_->frame(), cartesian_->frame_W().q); });
  showRobot();
}

void RobotPanel::addEmptyState(QVBoxLayout& column) {
  empty_ = new QWidget;
  auto* rows = new QVBoxLayout(empty_);
  rows->setContentsMargins(24, 48, 24, 24);
  rows->setSpacing(8);
  auto* picture = new QLabel;
  picture->setPixmap(icon("robot").pixmap(48, 48));
  picture->setAlignment(Qt::AlignCenter);
  rows->addWidget(picture);
  auto* title = makeLabel(tr("No robot is selected"), TextRole::kPanelState);
  title->setAlignment(Qt::AlignCenter);
  rows->addWidget(title);
  auto* how = makeLabel(tr("Click a robot or a mechanism in the scene or in the tree, or add one with Ctrl+Shift+I."),
                        TextRole::kText, true);
  how->setWordWrap(true);
  how->setAlignment(Qt::AlignCenter);
  rows->addWidget(how);
  auto* add = new QPushButton(tr("Add robot…"));
  add->setObjectName("buttonAddRobot");
  add->setProperty("main", true);
  auto* join = new QPushButton(tr("Join parts into a mechanism…"));
  connect(add, &QPushButton::clicked, this, &RobotPanel::libraryWanted);
  connect(join, &QPushButton::clicked, this, &RobotPanel::mechanismWanted);
  rows->addSpacing(8);
  rows->addWidget(add, 0, Qt::AlignHCenter);
  rows->addWidget(join, 0, Qt::AlignHCenter);
  column.addWidget(empty_);
}

void RobotPanel::addHeading(QVBoxLayout& column) {
  QVBoxLayout* rows = nullptr;
  section(column, {}, rows);
  rows->setSpacing(2);
  picture_ = new RobotThumbnail(context_);
  rows->addWidget(picture_);
  rows->addSpacing(4);
  name_ = makeLabel({}, TextRole::kPanelState);
  name_->setObjectName("labelRobot");
  kind_ = makeLive(2, TextRole::kSecond, true);
  rows->addWidget(name_);
  rows->addWidget(kind_);
  rows->addWidget(new LoadLine(context_, "labelLoad"));
}

void RobotPanel::addHolding(QVBoxLayout& column) {
  QVBoxLayout* rows = nullptr;
  holding_ = section(column, {}, rows);
  held_ = new HoldingView(context_);
  rows->addWidget(held_);
  connect(held_, &HoldingView::toolsWanted, this, &RobotPanel::toolsWanted);
}

void RobotPanel::addJog(QVBoxLayout& column) {
  QVBoxLayout* rows = nullptr;
  section(column, {}, rows);
  tabs_ = new Segmented({tr("Joints"), tr("Cartesian")});
  tabs_->setObjectName("segmentsJog");
  tabs_->setCurrent(0);
  step_ = new QComboBox;
  step_->setObjectName("comboStep");
  step_->setAccessibleName(tr("Step"));
  for (const JogStepSize& step : kSteps) {
    const auto number = [](double value) { return QString::number(value, 'f', value < 1.0 ? 1 : 0); };
    step_->addItem(
        tr("%1° · %2").arg(number(step.degrees), lengthText(0.001 * step.millimetres, step.millimetres < 1.0 ? 1 : 0)));
  }
  step_->setCurrentIndex(1);
  home_ = new QPushButton(icon("home"), tr("Home"));
  home_->setObjectName("buttonHome");
  home_->setToolTip(tr("Go home"));
  poses_ = new QPushButton(icon("down"), {});
  poses_->setObjectName("buttonPoses");
  poses_->setFixedWidth(24);
  poses_->setToolTip(tr("Named poses: go to one, or save this one"));
  poses_->setAccessibleName(tr("Named poses"));
  rows->addWidget(tabs_);
  auto* line = new QHBoxLayout;
  line->setSpacing(6);
  line->addWidget(makeLabel(tr("Step"), TextRole::kText, true));
  line->addWidget(step_, 1);
  auto* pair = new QHBoxLayout;
  pair->setSpacing(2);
  pair->addWidget(home_);
  pair->addWidget(poses_);
  line->addLayout(pair);
  rows->addLayout(line);
  jogs_ = new QStackedWidget;
  joints_ = new JointJog(context_, mover_);
  cartesian_ = new CartesianJog(context_, mover_);
  for (QWidget* tab : {static_cast<QWidget*>(joints_), static_cast<QWidget*>(cartesian_)}) {
    auto* holder = new QWidget;
    auto* inside = new QVBoxLayout(holder);
    inside->setContentsMargins(0, 2, 0, 0);
    inside->addWidget(tab);
    inside->addStretch(1);
    jogs_->addWidget(holder);
  }
  rows->addWidget(jogs_);
  stop_ = new RobotStop(context_, this);
  rows->addWidget(stop_->line());
  connect(tabs_, &Segmented::chosen, this, [this](int tab) {
    jogs_->setCurrentIndex(tab);
    emitShownTab();
    showNow();
  });
  connect(step_, &QComboBox::activated, this, &RobotPanel::showStep);
  connect(home_, &QPushButton::clicked, this, [this] { choosePose("home"); });
  connect(poses_, &QPushButton::clicked, this, &RobotPanel::fillPoses);
  showStep();
}

void RobotPanel::addMechanism(QVBoxLayout& column) {
  QVBoxLayout* rows = nullptr;
  mechanism_ = section(column, {}, rows);
  auto* edit = new QPushButton(tr("Edit joints…"));
  edit->setObjectName("buttonEditMechanism");
  auto* apart = new QPushButton(tr("Disassemble"));
  apart->setObjectName("buttonTakeApart");
  apart->setToolTip(tr("The parts become solids again, at their current placement"));
  rows->addWidget(sideBySide({edit, apart}));
  connect(edit, &QPushButton::clicked, this, &RobotPanel::mechanismWanted);
  connect(apart, &QPushButton::clicked, this, [this] {
    if (context_.robot()) context_.host().documentModel().execute(workcell::DissolveMechanism{context_.robot()->id});
  });
}

void RobotPanel::showHeldBack(const QString& why) {
  stop_->setHeldBack(why);
  showStop();
}

void RobotPanel::emitShownTab() {
  emit cartesianShown(isVisible() && context_.robot() && jogs_->currentIndex() == 1);
}

void RobotPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emitShownTab();
  showNow();
}

void RobotPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emitShownTab();
}

void RobotPanel::showStep() {
  const JogStepSize& step = kSteps[std::max(0, step_->currentIndex())];
  joints_->setStep(step);
  cartesian_->setStep(step);
}

void RobotPanel::showRobot() {
  const workcell::Entity* robot = context_.robot();
  empty_->setVisible(!robot);
  content_->setVisible(robot);
  stop_->forget();
  if (!robot) return;
  const bool mechanism = context_.isMechanism();
  name_->setText(QString::fromStdString(robot->name));
  const int joints = static_cast<int>(robot->robot()->dof());
  QString kind = tr("%1 · %2").arg(QString::fromStdString(robot->robot()->name), tr("%n joints", nullptr, joints));
  if (joints == 1) kind.replace(tr("1 joints"), tr("1 joint"));
  if (const auto* inverse = context_.inverse())
    kind += QStringLiteral(" · ") + tr("inverse: %1").arg(QString::fromStdString(inverse->name()));
  if (robot->locked) kind += QStringLiteral(" · ") + tr("locked in place");
  kind_->setText(kind);
  holding_->setVisible(!mechanism);
  choosing_->setVisible(!mechanism && context_.inverse());
  mechanism_->setVisible(mechanism);
  tabs_->button(1)->setVisible(!mechanism && context_.inverse());
  if (mechanism || !context_.inverse()) {
    tabs_->setCurrent(0);
    jogs_->setCurrentIndex(0);
  }
  emitShownTab();
  held_->showNow();
  picture_->showRobot();
  showNow();
}

void RobotPanel::showNow() {
  if (!isVisible() || !context_.robot()) return;
  (jogs_->currentIndex() == 0) ? joints_->showNow() : cartesian_->showNow();
  held_->setFree(context_.isFree());
  home_->setEnabled(context_.isFree());
  poses_->setEnabled(context_.isFree());
  showStop();
}

void RobotPanel::showStop() {
  stop_->show();
}

void RobotPanel::choosePose(const QString& name) {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  stop_->setHeldBack({});
  const std::vector<double> pose = workcell::findNamedPose(*robot, name.toStdString());
  if (!pose.empty()) mover_.travel(tr("Move %1 to %2").arg(QString::fromStdString(robot->name), name), pose);
}

void RobotPanel::fillPoses() {
  const workcell::Entity* robot = context_.robot();
  if (!robot) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const auto& pose : workcell::namedPosesOf(*robot)) {
    const QString name = QString::fromStdString(pose.name);
    menu->addAction(name, this, [this, name] { choosePose(name); });
  }
  menu->addSeparator();
  menu->addAction(tr("Save this pose…"), this, &RobotPanel::keepPose);
  QMenu* drop = menu->addMenu(tr("Delete"));
  drop->setEnabled(!robot->jointed().named_poses.empty());
  for (const auto& pose : robot->jointed().named_poses) {
    const std::string name = pose.name;
    drop->addAction(QString::fromStdString(name), this, [this, name] {
      if (!context_.robot()) return;
      workcell::SetNamedPoses poses{context_.robot()->id, context_.robot()->jointed().named_poses};
      std::erase_if(poses.poses, [&](const auto& known) { return known.name == name; });
      context_.host().documentModel().execute(poses);
    });
  }
  // popup() returns at once: the scene goes on under the menu.
  menu->popup(poses_->mapToGlobal(QPoint(0, poses_->height() + 2)));
}

void RobotPanel::keepPose() {
  auto* ask = new QInputDialog(this);
  ask->setObjectName("dialogPoseName");
  ask->setAttribute(Qt::WA_DeleteOnClose);
  ask->setModal(false);
  ask->setWindowTitle(tr("Save this pose"));
  ask->setLabelText(tr("Name of the pose (home replaces home)"));
  connect(ask, &QInputDialog::textValueSelected, this, [this](const QString& name) {
    const workcell::Entity* robot = context_.robot();
    if (!robot || name.trimmed().isEmpty()) return;
    workcell::SetNamedPoses poses{robot->id, robot->jointed().named_poses};
    const std::string wanted = name.trimmed().toStdString();
    std::erase_if(poses.poses, [&](const auto& known) { return known.name == wanted; });
    poses.poses.push_back({wanted, robot->joints()});
    context_.host().documentModel().execute(poses);
  });
  ask->show();
}

}  // namespace hapticell::app
