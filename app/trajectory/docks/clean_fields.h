// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "trajectory/motion/trajectory.h"

class QCheckBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;

/// How far an edited path may deviate from the recorded one. GUI thread.
class CleanFields : public QObject {
  Q_OBJECT
 public:
  explicit CleanFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// The joint tolerance is the turn that moves a tool at 1 m by the path tolerance.
  trajectory::PathTolerance tolerance() const;
  bool keepsFree() const;  ///< From collisions.
  QWidget* firstRow() const { return first_row_; }

 private:
  ValueField *tolerance_, *turn_tolerance_;
  QCheckBox* keep_free_;
  QWidget* first_row_;
};

}  // namespace hapticell::app
