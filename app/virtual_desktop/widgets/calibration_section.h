// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "haptic/protocol/device_condition.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

/// The stylus's calibration on the device check page: whether it is calibrated, what the user does step by step, and
/// the result. Falcon, Omni and Touch detect their steps themselves; simulated devices have none.
class CalibrationSection : public QWidget {
  Q_OBJECT
 public:
  explicit CalibrationSection(QWidget* parent = nullptr);
  /// Sets what the server reports about the device; empty before its first report.
  void setCondition(const std::optional<haptic::DeviceCondition>& condition, bool connected);

 signals:
  /// The user has completed that step.
  void stepDone(unsigned step);

 private:
  void show();

  QLabel *state_, *step_, *said_;
  QPushButton *begin_, *done_, *cancel_;
  std::optional<haptic::DeviceCondition> condition_;
  bool connected_ = false;
  int at_ = -1;  // The present step; -1: none.
};

}  // namespace hapticell::app
