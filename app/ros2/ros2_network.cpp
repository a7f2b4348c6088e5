// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/ros2_network.h"

#include <QCheckBox>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/kit/form.h"

namespace hapticell::app {

Ros2Network::Ros2Network(QWidget* parent)
    : QWidget(parent), domain_(new QSpinBox), this_machine_(new QCheckBox(tr("Only programs on this machine"))) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout& section = *addSection(*column, tr("Network"));
  domain_->setObjectName("spinRos2Domain");
  domain_->setRange(0, 232);
  domain_->setValue(qEnvironmentVariableIntValue("ROS_DOMAIN_ID"));
  domain_->setToolTip(tr("As ROS_DOMAIN_ID of the other programs. Default: 0"));
  addRow(section, tr("Domain"), domain_);
  this_machine_->setObjectName("switchRos2ThisMachine");
  this_machine_->setChecked(qEnvironmentVariable("ROS_LOCALHOST_ONLY") == "1");
  section.addWidget(this_machine_);
}

QJsonObject Ros2Network::job(const QString& what) const {
  return {{"do", what}, {"domain", domain_->value()}, {"this_machine", this_machine_->isChecked()}, {"texts", true}};
}

}  // namespace hapticell::app
