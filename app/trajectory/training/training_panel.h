// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "manipulation/session/exercise.h"
#include "trajectory/training/training.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class MotionList;
class ProgressPlot;
class TrainingPlay;
class ValueField;

/// The dock *Training*: exercises (shipped ones, own ones, or the current motion as one), the expert's motion shown,
/// runs in which it leads the stylus and waits, runs without guidance apart from them, the score of each, each beside
/// the expert's, and the trainee's progress, kept in a file. GUI thread.
class TrainingPanel : public QWidget {
  Q_OBJECT
 public:
  TrainingPanel(Host& host, MotionList& list, QWidget* parent = nullptr);
  ~TrainingPanel() override;

  /// Reads an exercise; its cell is opened by exerciseOpened(). False where it cannot be read.
  bool openExercise(const QString& path);
  /// Makes an exercise of the current motion, in the cell as it is.
  void useCurrentMotion();
  /// Another document follows: a run that goes on is given up, and an exercise of the cell goes; one whose own cell it
  /// is that follows stays.
  void forgetCell();
  /// Takes what was recorded while a run went on; false where none does.
  bool takeRecorded(const std::vector<trajectory::Trajectory>& recorded);
  /// The trainee's file; empty: results are kept by exercise and name among the user's data.
  void setResults(const QString& path);
  /// Where exercises that are made here are kept; they stand in the list behind the shipped ones.
  void setExercises(const QString& folder);
  const trajectory::TrainingSession& session() const { return session_; }
  bool isRunning() const { return run_ != nullptr; }
  /// The run that goes on is led: its guide, its path and the expert's ghost are shown.
  bool isLed() const { return run_ && kind() == trajectory::RunKind::kPractice; }
  /// s of the expert's motion where the trainee is; 0 while no run goes on.
  double expertTime() const { return run_ ? run_->expertTime() : 0.0; }
  /// Where the moved frame of the exercise's entity is; called at each of the window's steps while a run goes on.
  void follow(const Pose& X_WM);
  /// The cell that cellWanted() asked for is there; or will not be, and why.
  void cellCame(const QString& problem = {});

 signals:
  void cellWanted(const QString& path);  ///< The exercise's workcell is to be opened.
  /// The guide of the run as it stands now; nothing: none.
  void guideChanged(const std::optional<hapticell::workcell::Guide>& guide);
  void runStarted(const hapticell::trajectory::Trajectory& expert);
  void runEnded();
  void sceneWanted();  ///< A run or a play begins: what else is played ends.
  void told(const QString& line, bool careful);

 private:
  void addExercise(QVBoxLayout& column);
  void addTrainee(QVBoxLayout& column);
  void addRun(QVBoxLayout& column);
  void addResults(QVBoxLayout& column);
  void fillExercises();
  void chooseExercise(int index);
  void editExercise(bool fresh);
  trajectory::RunKind kind() const;
  bool mayStart();
  void play(const trajectory::Trajectory& run);
  void replayRun();
  std::string keepRun(const trajectory::Trajectory& run);
  void fillRuns();
  void say(const QString& line, bool careful);
  void setExercise(const manipulation::Exercise& exercise, trajectory::Trajectory expert);
  bool forcesAreOff() const;
  void switchForcesOn();
  void showForces();
  void showKind();
  void start();
  bool placeAtBeginning();
  void endRun();
  void dropRun();
  void giveUp();
  void finish(const trajectory::Trajectory& run);
  void cancel();
  void loadResults();
  void keepResults();
  QString resultsFile() const;
  void exportResults();
  void show();
  void showGuide();

  Host& host_;
  MotionList& list_;
  std::optional<manipulation::Exercise> exercise_;
  trajectory::Trajectory expert_;
  std::unique_ptr<manipulation::TrainingRun> run_;
  trajectory::TrainingSession session_;
  QString results_, own_folder_, exercise_file_;
  QString note_;  ///< The last that was said; until the next run.
  TrainingPlay* play_;
  bool cell_wanted_ = false;  ///< The exercise's own cell is being opened.
  QComboBox *exercises_, *kind_, *runs_;
  QLineEdit* trainee_;
  QLabel *text_, *state_, *forces_, *score_, *unaided_, *help_label_;
  ValueField *radius_, *help_;
  QProgressBar* way_;
  QPushButton *start_, *without_, *use_, *show_me_, *new_, *edit_, *replay_, *export_;
  ProgressPlot* plot_;
};

}  // namespace hapticell::app
