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

/// The format for exporting the current motion, and the options of a robot program. GUI thread.
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
