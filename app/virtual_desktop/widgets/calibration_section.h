// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "haptic/protocol/device_condition.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

/// The stylus's calibration on the device check page: whether it is calibrated, what the user does step by step, what
/// came of it. Falcon, Omni and Touch tell their steps by themselves; simulated devices have none.
class CalibrationSection : public QWidget {
  Q_OBJECT
 public:
  explicit CalibrationSection(QWidget* parent = nullptr);
  /// What the server says of the device; nothing while it has not said anything.
  void setCondition(const std::optional<haptic::DeviceCondition>& condition, bool connected);

 signals:
  /// The user has done that step.
  void stepDone(unsigned step);

 private:
  void show();

  QLabel *state_, *step_, *said_;
  QPushButton *begin_, *done_, *cancel_;
  std::optional<haptic::DeviceCondition> condition_;
  bool connected_ = false;
  int at_ = -1;  // The step that is being done; -1: none.
};

}  // namespace hapticell::app
