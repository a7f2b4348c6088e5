// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "app/trajectory/training/training_results.h"
#include "manipulation/session/exercise.h"
#include "trajectory/training/training.h"

class QLineEdit;
class QVBoxLayout;

namespace hapticell::app {

class ExerciseSection;
class Host;
class MotionList;
class ResultsSection;
class RunSection;
class TrainingPlay;
class ValueField;

/// The panel *Training*. It lists exercises (shipped ones, own ones, or one made from the current motion) and shows the
/// expert's motion. It starts runs with guidance, which waits for the trainee, and runs without it. It shows each run's
/// score next to the expert's, and the trainee's progress, which is stored in a file. GUI thread.
class TrainingPanel : public QWidget {
  Q_OBJECT
 public:
  TrainingPanel(Host& host, MotionList& list, QWidget* parent = nullptr);
  ~TrainingPanel() override;

  /// Reads an exercise, and asks for its cell by cellWanted(). False if the exercise cannot be read.
  bool openExercise(const QString& path);
  /// Opens the exercise of the training results `path` (*.htrain) and continues in that file. Prefers an exercise next
  /// to the file to one of the library.
  void openResults(const QString& path);
  /// Makes an exercise of the current motion, in the cell as it is.
  void useCurrentMotion();
  /// Another document follows: cancels a running run, and closes the exercise unless the new document is its own
  /// cell.
  void forgetCell();
  /// Takes the recording of the running run; false if no run is running.
  bool takeRecorded(const std::vector<trajectory::Trajectory>& recorded);
  /// Sets the trainee's file; empty: results are kept by exercise and name in the user's data.
  void setResults(const QString& path);
  /// Sets the folder for exercises made here; the list shows them after the shipped ones.
  void setExercises(const QString& folder);
  const trajectory::TrainingSession& session() const { return results_.session(); }
  bool isRunning() const { return run_ != nullptr; }
  /// Whether the present run has guidance: its guide, its path and the expert's ghost are shown.
  bool isLed() const;
  /// The trainee's position along the expert's motion, s; 0 without a run.
  double expertTime() const { return run_ ? run_->expertTime() : 0.0; }
  /// Sets the present pose of the moved frame; called at each step of the window during a run.
  void follow(const Pose& X_WM);
  /// Reports that the cell of cellWanted() is open, or why it cannot be opened.
  void cellCame(const QString& problem = {});

 signals:
  void cellWanted(const QString& path);  ///< Asks to open the exercise's workcell.
  /// The present guide of the run; empty: none.
  void guideChanged(const std::optional<hapticell::workcell::Guide>& guide);
  void runStarted(const hapticell::trajectory::Trajectory& expert);
  void runEnded();
  void sceneWanted();  ///< A run or playback starts: any other playback must end.
  void told(const QString& line, bool careful);

 private:
  void addExercise(QVBoxLayout& column);
  void addTrainee(QVBoxLayout& column);
  void addRun(QVBoxLayout& column);
  void addResults(QVBoxLayout& column);
  void editExercise(bool fresh);
  bool mayStart();
  void play(const trajectory::Trajectory& run);
  void replayRun();
  void say(const QString& line, bool careful);
  void setExercise(const manipulation::Exercise& exercise, trajectory::Trajectory expert);
  void switchForcesOn();
  void start();
  bool placeAtBeginning();
  void endRun();
  void dropRun();
  void giveUp();
  void finish(const trajectory::Trajectory& run);
  void cancel();
  void loadResults();
  void exportResults();
  double neededPoints() const;   ///< Score needed to pass.
  static std::string nowText();  ///< ISO 8601, with the time zone.
  void show();
  void showGuide();

  Host& host_;
  MotionList& list_;
  std::optional<manipulation::Exercise> exercise_;
  trajectory::Trajectory expert_;
  std::unique_ptr<manipulation::TrainingRun> run_;
  TrainingResults results_;
  QString exercise_file_;
  QString note_;  ///< The last note; until the next run.
  TrainingPlay* play_;
  bool cell_wanted_ = false;  ///< The exercise's own cell is being opened.
  QLineEdit* trainee_;
  ValueField *radius_, *help_;
  ExerciseSection* exercises_;
  RunSection* runs_;
  ResultsSection* shown_results_;
};

}  // namespace hapticell::app
