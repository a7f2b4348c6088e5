// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "trajectory/programs/writing/program_export.h"

class QComboBox;
class QLineEdit;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class ValueField;

/// As what the current motion is exported, and what a robot program is written with. GUI thread.
class ProgramFields : public QObject {
  Q_OBJECT
 public:
  explicit ProgramFields(QVBoxLayout& section, QObject* parent = nullptr);

  QString format() const;  ///< MotionFormat::word.
  trajectory::ProgramOptions options() const;
  QWidget* firstRow() const { return first_row_; }

 private:
  QComboBox* format_;
  ValueField *speed_, *blend_;
  QLineEdit *tool_, *base_;
  QWidget* first_row_;
};

}  // namespace hapticell::app
