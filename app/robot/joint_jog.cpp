// SPDX-License-Identifier: Apache-2.0
#include "app/robot/joint_jog.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "app/controls/joint_row.h"
#include "app/robot/robot_context.h"
#include "app/style/value_field.h"
#include "kinematics/model/jog.h"

namespace hapticell::app {

JointJog::JointJog(RobotContext& context, JointMover& mover, QWidget* parent)
    : QWidget(parent), context_(context), mover_(mover), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(4);
  connect(&context_, &RobotContext::robotChanged, this, &JointJog::rebuild);
  rebuild();
}

void JointJog::rebuild() {
  while (QLayoutItem* item = column_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  rows_.clear();
  const workcell::Entity* robot = context_.robot();
  for (std::size_t i = 0; robot && i < robot->robot()->dof(); ++i) addRow(i);
  showNow();
}

void JointJog::addRow(std::size_t variable) {
  const workcell::Entity* robot = context_.robot();
  const auto& joint = robot->robot()->joints[static_cast<std::size_t>(robot->robot()->moving[variable])];
  JointRow::Scale scale = scaleOf(joint, variable);
  scale.ends = true;
  Row row;
  row.unit = unitOf(joint);
  row.slides = joint.type == kinematics::JointType::kPrismatic;
  row.scale = new JointRow(scale);
  row.scale->setObjectName(QStringLiteral("jogScale%1").arg(variable + 1));
  row.field = new ValueField({scale.unit, 1, scale.lower, scale.upper, 1.0});
  row.field->setObjectName(QStringLiteral("jogField%1").arg(variable + 1));
  row.field->setAccessibleName(scale.name);
  row.field->setFixedWidth(66);
  row.less = new HoldButton("minus", tr("Decrease %1 by one step").arg(scale.name));
  row.less->setObjectName(QStringLiteral("jogLess%1").arg(variable + 1));
  row.more = new HoldButton("plus", tr("Increase %1 by one step").arg(scale.name));
  row.more->setObjectName(QStringLiteral("jogMore%1").arg(variable + 1));
  auto* holder = new QWidget;
  auto* line = new QHBoxLayout(holder);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(4);
  line->addWidget(row.scale, 1);
  line->addWidget(row.field);
  line->addWidget(row.less);
  line->addWidget(row.more);
  column_->addWidget(holder);
  rows_.push_back(row);
  connectRow(variable);
}

void JointJog::connectRow(std::size_t variable) {
  const Row& row = rows_[variable];
  const auto begin = [this, variable] { mover_.begin(stepText(variable)); };
  connect(row.scale, &JointRow::began, this, begin);
  connect(row.scale, &JointRow::moved, this, [this, variable](double value) { moveTo(variable, value); });
  connect(row.scale, &JointRow::ended, this, [this](bool keep) { mover_.end(keep); });
  connect(row.field, &ValueField::edited, this, [this, begin, variable](double value) {
    begin();
    moveTo(variable, value);
    mover_.end();
  });
  for (HoldButton* button : {row.less, row.more}) {
    connectJog(
        button, mover_, [this, variable] { return stepText(variable); },
        [this, variable, up = button == row.more] { stepBy(variable, up ? 1 : -1); });
  }
}

QString JointJog::stepText(std::size_t variable) const {
  const QString name = context_.robot() ? QString::fromStdString(context_.robot()->name) : QString();
  return tr("Jog %1 of %2").arg(context_.jointName(variable), name);
}

void JointJog::moveTo(std::size_t variable, double shown) {
  const workcell::Entity* robot = context_.robot();
  if (!robot || variable >= robot->joints().size()) return;
  const double target = shown * rows_[variable].unit;
  mover_.moveTo(kinematics::jogJoint(*robot->robot(), robot->joints(), static_cast<int>(variable),
                                     target - robot->joints()[variable])
                    .q);
}

void JointJog::stepBy(std::size_t variable, int direction) {
  const workcell::Entity* robot = context_.robot();
  if (!robot || variable >= robot->joints().size()) return;
  const Row& row = rows_[variable];
  const double step = (row.slides ? step_.millimetres : step_.degrees) * row.unit * direction;
  mover_.moveTo(kinematics::jogJoint(*robot->robot(), mover_.target(), static_cast<int>(variable), step).q);
}

void JointJog::showNow() {
  const std::vector<double> q = context_.joints();
  const bool free = context_.isFree();
  for (std::size_t i = 0; i < rows_.size() && i < q.size(); ++i) {
    const Row& row = rows_[i];
    const double shown = q[i] / row.unit;
    row.scale->setEnabled(free);
    row.field->setEnabled(free);
    row.less->setEnabled(free);
    row.more->setEnabled(free);
    if (!row.scale->isDragged()) row.scale->setValue(shown);
    row.field->setProperty("limit", row.scale->isAtLimit());
    if (!row.field->hasFocus()) row.field->setValue(shown);
  }
}

}  // namespace hapticell::app
