// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/program_fields.h"

#include <QComboBox>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/trajectory/docks/named_field.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/motions/usual_format.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::app {

ProgramFields::ProgramFields(QVBoxLayout& section, QObject* parent) : QObject(parent) {
  format_ = new QComboBox;
  format_->setObjectName("comboMotionFormat");
  for (const MotionFormat& format : motionFormats()) format_->addItem(format.name, format.word);
  first_row_ = addRow(section, tr("Format"), format_);
  speed_ = namedField("fieldProgramSpeed", {tr("mm/s"), 0, 1, 5000, 10}, 250);
  blend_ = namedField("fieldBlend", {tr("mm"), 1, 0, 200, 1}, 2.0);
  blend_->setToolTip(tr("Blend radius between moves"));
  addRow(section, tr("Speed"), sideBySide({speed_, blend_}));
  tool_ = new QLineEdit;
  tool_->setObjectName("editProgramTool");
  tool_->setPlaceholderText(tr("as in the controller"));
  addRow(section, tr("Tool"), tool_);
  base_ = new QLineEdit;
  base_->setObjectName("editProgramBase");
  base_->setPlaceholderText(tr("as in the controller"));
  addRow(section, tr("Base"), base_);
}

void ProgramFields::setRobot(const kinematics::RobotModel* robot) {
  if (!robot || robot->name == robot_) return;
  robot_ = robot->name;
  if (const int row = format_->findData(usualFormat(*robot)); row >= 0) format_->setCurrentIndex(row);
}

QString ProgramFields::format() const {
  return format_->currentData().toString();
}

trajectory::ProgramOptions ProgramFields::options() const {
  trajectory::ProgramOptions options;
  options.speed = 1e-3 * speed_->value();
  options.blend = 1e-3 * blend_->value();
  options.tool = tool_->text().trimmed().toStdString();
  options.base = base_->text().trimmed().toStdString();
  return options;
}

}  // namespace hapticell::app
