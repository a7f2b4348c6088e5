// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <array>

#include "manipulation/session/exercise.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class MotionList;
class ValueField;

/// Makes an exercise from the open cell and one of its motions, or changes one: name, task, the expert's motion,
/// guidance for the trainee and what costs points. Problems are shown below their fields, and nothing is saved until
/// they are solved. Not modal, so that the cell can be saved meanwhile. Closes with the cell. GUI thread.
class ExerciseEditor : public QDialog {
  Q_OBJECT
 public:
  /// `folder`: where to save the exercise.
  ExerciseEditor(Host& host, MotionList& list, const QString& folder, QWidget* parent = nullptr);
  /// Fills the fields from an exercise; `file`: its file; empty: it is for the open cell and not saved yet. An exercise
  /// from another folder is saved as a copy.
  void edit(const QString& file, const manipulation::Exercise& exercise, const trajectory::Trajectory& expert);

 signals:
  void saved(const QString& file);

 private:
  void addWords(QVBoxLayout& column);
  void addMotion(QVBoxLayout& column);
  void addNumbers(QVBoxLayout& column);
  void takeMotions();
  const trajectory::Trajectory* chosenMotion() const;
  bool usesOpenCell() const;
  QString nameProblem() const;
  QString motionProblem() const;
  QString cellProblem() const;
  bool check();
  void showHeld();
  void save();

  Host& host_;
  MotionList& list_;
  QString folder_, file_;
  manipulation::Exercise exercise_;
  trajectory::Trajectory expert_;
  bool tried_ = false;  ///< Problems are shown after the first attempt to save.
  QLineEdit* name_;
  QPlainTextEdit* text_;
  QComboBox* motion_;
  QLabel *held_, *cell_, *name_problem_, *text_problem_, *motion_problem_, *cell_problem_, *file_problem_;
  std::array<ValueField*, 7> numbers_;
  std::array<double, 7> began_;  ///< Values of the fields at the start.
};

}  // namespace hapticell::app
