// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/widgets/calibration_section.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/kit/form.h"

namespace hapticell::app {
namespace {

QLabel* wrapped(const char* name, TextRole role, bool quiet) {
  QLabel* label = makeLabel({}, role, quiet);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

}  // namespace

CalibrationSection::CalibrationSection(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(state_ = wrapped("labelCalibrated", TextRole::kText, false));
  column->addWidget(step_ = wrapped("labelCalibrationStep", TextRole::kText, false));
  column->addWidget(said_ = wrapped("labelCalibrationSaid", TextRole::kSecond, true));
  begin_ = new QPushButton(tr("Calibrate…"));
  done_ = new QPushButton(tr("Done"));
  cancel_ = new QPushButton(tr("Cancel"));
  begin_->setObjectName("buttonCalibrateStylus");
  done_->setObjectName("buttonCalibrationDone");
  done_->setProperty("main", true);
  cancel_->setObjectName("buttonCalibrationCancel");
  column->addWidget(sideBySide({begin_, done_, cancel_}));
  connect(begin_, &QPushButton::clicked, this, [this] {
    at_ = 0;
    show();
  });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    at_ = -1;
    show();
  });
  connect(done_, &QPushButton::clicked, this, [this] {
    const int step = at_++;
    if (!condition_ || at_ >= static_cast<int>(condition_->calibration.size())) at_ = -1;
    emit stepDone(static_cast<unsigned>(step));
    show();
  });
  show();
}

void CalibrationSection::setCondition(const std::optional<haptic::DeviceCondition>& condition, bool connected) {
  if (condition == condition_ && connected == connected_) return;
  condition_ = condition;
  connected_ = connected;
  const bool can = condition_ && condition_->answers && at_ < static_cast<int>(condition_->calibration.size());
  if (!can) at_ = -1;
  show();
}

void CalibrationSection::show() {
  const bool has_steps = condition_ && !condition_->calibration.empty();
  const bool can = has_steps && condition_->answers;
  QString state = tr("No haptic server is responding.");
  if (connected_ && !condition_) state = tr("The simulated stylus needs no calibration.");
  if (condition_ && !condition_->answers) state = tr("The device is not responding.");
  if (condition_ && condition_->answers) {
    state = condition_->calibrated ? tr("Calibrated.") : tr("Not calibrated. Forces stay off until it is.");
    if (condition_->docked) state += QLatin1Char(' ') + tr("The stylus is in its inkwell.");
    if (!has_steps && condition_->calibrated) state += QLatin1Char(' ') + tr("No action needed.");
  }
  state_->setText(state);
  const bool runs = can && at_ >= 0;
  step_->setVisible(runs);
  if (runs) {
    step_->setText(tr("Step %1 of %2: %3")
                       .arg(at_ + 1)
                       .arg(condition_->calibration.size())
                       .arg(QString::fromStdString(condition_->calibration[static_cast<std::size_t>(at_)])));
  }
  const QString said = condition_ ? QString::fromStdString(condition_->sentence) : QString();
  said_->setText(said);
  said_->setVisible(!said.isEmpty());
  begin_->parentWidget()->setVisible(can);
  begin_->setVisible(!runs);
  done_->setVisible(runs);
  cancel_->setVisible(runs);
}

}  // namespace hapticell::app
