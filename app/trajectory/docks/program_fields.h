// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "trajectory/programs/writing/program_export.h"

class QComboBox;
class QLineEdit;
class QWidget;
class QVBoxLayout;

namespace hapticell::kinematics {
struct RobotModel;
}

namespace hapticell::app {

class ValueField;

/// The format for exporting the current motion, and the options of a robot program. GUI thread.
class ProgramFields : public QObject {
  Q_OBJECT
 public:
  explicit ProgramFields(QVBoxLayout& section, QObject* parent = nullptr);

  /// The robot of the current motion; null if it is not a robot's. Chooses the format of another robot than before; for
  /// the same one, the user's choice stays.
  void setRobot(const kinematics::RobotModel* robot);
  QString format() const;  ///< MotionFormat::word.
  trajectory::ProgramOptions options() const;
  QWidget* firstRow() const { return first_row_; }

 private:
  QComboBox* format_;
  ValueField *speed_, *blend_;
  QLineEdit *tool_, *base_;
  QWidget* first_row_;
  std::string robot_;  ///< Name of the model that the format was chosen for.
};

}  // namespace hapticell::app
