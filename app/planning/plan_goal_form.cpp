// SPDX-License-Identifier: Apache-2.0
#include "app/planning/plan_goal_form.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/controls/joint_row.h"
#include "app/controls/pose_text.h"
#include "app/controls/reference_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/value_field.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::app {

namespace {

/// Size of the shown unit of a robot's variable, in rad or m.
double unitOfVariable(const workcell::Entity& robot, std::size_t variable) {
  const kinematics::RobotModel& model = *robot.robot();
  return unitOf(model.joints[static_cast<std::size_t>(model.moving[variable])]);
}

/// Sizes of the shown units of all variables, those of the axes first.
std::vector<double> unitsOf(const workcell::Entity& robot, const PlanGoalForm::Axes& axes) {
  std::vector<double> units;
  const auto add = [&](const workcell::Entity& one) {
    for (std::size_t i = 0; i < one.joints().size(); ++i) units.push_back(unitOfVariable(one, i));
  };
  for (const workcell::Entity* axis : axes) add(*axis);
  add(robot);
  return units;
}

/// The frame that a plan moves: the tool, the entity's own, or the grip of a mannequin's hand.
Pose movedPose_W(const workcell::Entity& entity, mannequin::Side hand) {
  if (entity.figure()) return gripPose_W(entity, hand, entity.X_WE, entity.joints());
  return entity.robot() ? tcpPose_W(entity, entity.X_WE, entity.joints()) : entity.X_WE;
}

}  // namespace

PlanGoalForm::PlanGoalForm(Host& host, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  kind_ = new QComboBox;
  kind_->setObjectName("choicePlanGoal");
  offer({kPose, kFrame, kJoints, kOut});
  addRow(*column, tr("Goal"), kind_);
  pose_page_ = new QWidget;
  auto* rows = new QVBoxLayout(pose_page_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(6);
  const QString names[] = {"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < pose_.size(); ++i) {
    pose_[i] = new ValueField({i < 3 ? QStringLiteral("mm") : QStringLiteral("°"), 1, -1e6, 1e6, 1.0});
    pose_[i]->setObjectName("fieldPlan" + names[i]);
    addRow(*rows, names[i], pose_[i]);
  }
  column->addWidget(pose_page_);
  frame_ = new ReferenceChoice(host, {});
  frame_->setObjectName("choicePlanFrame");
  frame_row_ = addRow(*column, tr("Frame"), frame_);
  joints_ = new QLineEdit;
  joints_->setObjectName("editPlanJoints");
  joints_->setPlaceholderText(tr("0; -90; 90; 0; 0; 0 (degrees, mm)"));
  joints_row_ = addRow(*column, tr("Joints"), joints_);
  take_ = new QPushButton(tr("Take where it is now"));
  take_->setObjectName("buttonPlanTake");
  take_->setToolTip(tr("Move it to the goal, click here, then move it back to where the path begins."));
  column->addWidget(take_);
  connect(take_, &QPushButton::clicked, this, &PlanGoalForm::takeWanted);
  connect(kind_, &QComboBox::currentIndexChanged, this, &PlanGoalForm::showKind);
  showKind();
}

void PlanGoalForm::offer(const std::vector<Kind>& kinds) {
  const QString words[] = {tr("Pose"), tr("Frame"), tr("Joints"), tr("Out of the cell")};
  const QVariant chosen = kind_->currentData();
  const QSignalBlocker quiet(kind_);
  kind_->clear();
  for (const Kind kind : kinds) kind_->addItem(words[kind], static_cast<int>(kind));
  kind_->setCurrentIndex(std::max(0, kind_->findData(chosen)));
}

void PlanGoalForm::offerFor(const workcell::Entity& entity) {
  if (entity.figure()) {
    if (kind_->count() != 2) {
      offer({kPose, kFrame});
      showKind();
    }
    return;
  }
  const bool by_joints = entity.robot() != nullptr;
  const Kind own = by_joints ? kJoints : kOut;
  if (kind_->count() == 3 && kind_->findData(static_cast<int>(own)) >= 0) return;
  offer({kPose, kFrame, own});
  showKind();
}

void PlanGoalForm::showKind() {
  const int kind = kind_->currentData().toInt();
  pose_page_->setVisible(kind == kPose);
  frame_row_->setVisible(kind == kFrame);
  joints_row_->setVisible(kind == kJoints);
  take_->setVisible(kind == kPose || kind == kJoints);
}

void PlanGoalForm::take(const workcell::Entity& entity, mannequin::Side hand, const Axes& axes) {
  const auto numbers = poseNumbers(movedPose_W(entity, hand));
  for (std::size_t i = 0; i < pose_.size(); ++i) {
    pose_[i]->setValue(numbers[i]);
    taken_[i] = pose_[i]->value();
  }
  if (entity.robot() && !entity.figure()) takeJoints(entity, axes);
}

void PlanGoalForm::takeJoints(const workcell::Entity& entity, const Axes& axes) {
  std::vector<double> joints;
  for (const workcell::Entity* axis : axes) joints.insert(joints.end(), axis->joints().begin(), axis->joints().end());
  joints.insert(joints.end(), entity.joints().begin(), entity.joints().end());
  const std::vector<double> units = unitsOf(entity, axes);
  QStringList words;
  for (std::size_t i = 0; i < joints.size(); ++i) words << QString::number(joints[i] / units[i], 'f', 3);
  taken_joints_ = words.join("; ");
  joints_->setText(taken_joints_);
}

void PlanGoalForm::takeAxes(const workcell::Entity& entity, const Axes& axes) {
  if (joints_->text() == taken_joints_) takeJoints(entity, axes);
}

bool PlanGoalForm::isAsTaken() const {
  for (std::size_t i = 0; i < pose_.size(); ++i)
    if (pose_[i]->value() != taken_[i]) return false;
  return true;
}

Expected<planning::Goal> PlanGoalForm::goal(const workcell::Entity& entity, const Axes& axes) const {
  const int kind = kind_->currentData().toInt();
  if (kind == kOut) return planning::Goal(planning::goal::OutOfCell{});
  if (kind == kFrame) {
    const auto X_WT = frame_->frame_W();
    if (X_WT) return planning::Goal(planning::goal::ToPose{*X_WT});
    return makeError({.place = "goal", .found = "no frame", .expected = "a frame of the cell, or of a part"});
  }
  if (kind == kPose) {
    std::array<double, 6> numbers{};
    for (std::size_t i = 0; i < pose_.size(); ++i) numbers[i] = pose_[i]->value();
    return planning::Goal(planning::goal::ToPose{poseFromNumbers(numbers)});
  }
  const QStringList words = joints_->text().split(';', Qt::SkipEmptyParts);
  const std::size_t own = entity.joints().size();
  std::vector<double> units = unitsOf(entity, axes);
  const std::size_t all = units.size();
  if (static_cast<std::size_t>(words.size()) == own) units.erase(units.begin(), units.end() - static_cast<std::ptrdiff_t>(own));
  std::vector<double> joints;
  for (const QString& word : words) {
    bool is_number = false;
    const double value = word.trimmed().toDouble(&is_number);
    if (is_number && std::isfinite(value) && joints.size() < units.size()) joints.push_back(value * units[joints.size()]);
  }
  const auto count = static_cast<std::size_t>(words.size());
  if (joints.size() != count || (count != own && count != all) || count == 0)
    return makeError({.place = "goal",
                      .found = Text("%1 joints", joints.size()),
                      .expected = own == all ? Text("%1 numbers, separated by semicolons", own)
                                             : Text("%1 numbers, separated by semicolons: those of the external axes "
                                                    "first; or %2 of its own, and the axes stay",
                                                    all, own)});
  return planning::Goal(planning::goal::ToJoints{std::move(joints)});
}

}  // namespace hapticell::app
