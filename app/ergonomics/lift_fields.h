// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "mannequin/ergonomics/scores/work_task.h"

class QCheckBox;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

class ValueField;

/// The section *Lifting (NIOSH)* of a task: whether a load is lifted, how far and how far to the side. GUI thread.
class LiftFields : public QObject {
  Q_OBJECT
 public:
  /// A function that changes the shown task.
  using Change = std::function<void(const std::function<void(ergonomics::WorkTask&)>&)>;
  LiftFields(QVBoxLayout& column, Change change, QObject* parent = nullptr);
  void show(const ergonomics::WorkTask& task);

 private:
  Change change_;
  QCheckBox* lift_;
  QWidget* lift_rows_;
  ValueField *lift_distance_, *asymmetry_;
};

}  // namespace hapticell::app
