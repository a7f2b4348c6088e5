// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "trajectory/motion/trajectory.h"

class QCheckBox;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;

/// How far an edited path may leave the recorded one. GUI thread.
class CleanFields : public QObject {
  Q_OBJECT
 public:
  explicit CleanFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// A joint may move a tool a metre away by as much.
  trajectory::PathTolerance tolerance() const;
  bool keepsFree() const;  ///< Of collisions.
  QWidget* firstRow() const { return first_row_; }

 private:
  ValueField *tolerance_, *turn_tolerance_;
  QCheckBox* keep_free_;
  QWidget* first_row_;
};

}  // namespace hapticell::app
