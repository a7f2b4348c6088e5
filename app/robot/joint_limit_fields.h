// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "app/robot/mechanism_draft.h"

class QCheckBox;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

class ValueField;

/// Joint limits, speed, drag and pitch of a joint of a mechanism: in degrees, or in millimetres for slides. GUI thread.
class JointLimitFields : public QObject {
  Q_OBJECT
 public:
  /// A function that changes the shown joint.
  using Edit = std::function<void(const std::function<void(workcell::MechanismJoint&)>&)>;
  JointLimitFields(QVBoxLayout& rows, Edit edit, QObject* parent = nullptr);
  void show(const workcell::MechanismJoint& joint);

 private:
  void connectFields();

  Edit edit_;
  QCheckBox* limited_;
  ValueField *lower_[2], *upper_[2], *velocity_[2], *friction_[2], *pitch_;
  QWidget *limit_row_[2], *effort_row_[2], *pitch_row_;
};

}  // namespace hapticell::app
