// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/timing_fields.h"

#include <QComboBox>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/trajectory/docks/named_field.h"

namespace hapticell::app {

TimingFields::TimingFields(QVBoxLayout& section, QObject* parent) : QObject(parent) {
  timing_ = new QComboBox;
  timing_->setObjectName("comboTiming");
  timing_->addItems(
      {tr("As recorded"), tr("Constant speed"), tr("Fastest within limits"), tr("Fastest, limited jerk")});
  timing_->setCurrentIndex(2);
  addRow(section, tr("Times"), timing_);
  speed_ = namedField("fieldSpeed", {tr("mm/s"), 0, 1, 5000, 10}, 100);
  speed_row_ = addRow(section, tr("Speed"), speed_);
  jerk_time_ = namedField("fieldJerkTime", {tr("ms"), 0, 5, 2000, 10}, 100);
  jerk_row_ = addRow(section, tr("Ramp"), jerk_time_);
  jerk_time_->setToolTip(tr("Time to reach the greatest acceleration"));
  connect(timing_, &QComboBox::currentIndexChanged, this, &TimingFields::show);
  show();
}

bool TimingFields::isAsRecorded() const {
  return timing_->currentIndex() == 0;
}

trajectory::RetimingOptions TimingFields::options() const {
  trajectory::RetimingOptions options;
  options.mode =
      timing_->currentIndex() == 1 ? trajectory::TimingMode::kConstantSpeed : trajectory::TimingMode::kTimeOptimal;
  options.speed = speed();
  if (timing_->currentIndex() == 3) options.limits.jerk = {1e-3 * jerk_time_->value()};
  return options;
}

double TimingFields::speed() const {
  return 1e-3 * speed_->value();
}

void TimingFields::show() {
  speed_row_->setVisible(timing_->currentIndex() == 1);
  jerk_row_->setVisible(timing_->currentIndex() == 3);
}

}  // namespace hapticell::app
