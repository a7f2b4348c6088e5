// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/training/path_progress.h"
#include "trajectory/training/training.h"
#include "trajectory/motion/trajectory.h"
#include "workcell/document/document.h"
#include "workcell/entity/guide.h"

namespace hapticell::manipulation {

/// An exercise: a cell, an expert's recording in it, and the guidance for the trainee. Stored in a file (*.hexercise,
/// JSON) next to the cell and the recording that it names.
struct Exercise {
  std::string name, text;           ///< Its name; the task, for the trainee.
  std::filesystem::path workcell;   ///< Absolute.
  std::filesystem::path recording;  ///< Absolute: the expert's motion (*.htraj), of one entity of the cell.
  double tube_radius = 0.02;        ///< m around the expert's path.
  double lead = 0.012;              ///< m by which the guidance pulls ahead of the trainee.
  double stiffness = 200.0;         ///< N/m at full guidance, up to 500.
  double pass = 60.0;               ///< Score from which a run is successful.
  trajectory::ScoringRule rule;
};

/// Errors name the file and the field; numbers out of range are errors. Does not read the files that it names.
Expected<Exercise> readExercise(const std::filesystem::path& file);
/// The text of an exercise for a file in `folder`.
std::string exerciseText(const Exercise& exercise, const std::filesystem::path& folder);
/// Reads a written exercise and compares every field of it with what was to be written. Error: the field with its found
/// and expected value, or why the file cannot be read (a number out of range).
Expected<void> checkExercise(const Exercise& wanted, const std::filesystem::path& written);
/// The *.hexercise files of a folder, by name.
std::vector<std::filesystem::path> exercisesIn(const std::filesystem::path& folder);

/// One run of a trainee: follows it along the expert's path, makes the guide, and scores it. The guide moves with the
/// trainee and waits: it reaches only `lead` ahead of the trainee. One thread.
class TrainingRun {
 public:
  /// @pre the expert has frames
  TrainingRun(const Exercise& exercise, trajectory::Trajectory expert, double help);

  /// Sets the present pose of the moved frame.
  void follow(const Pose& X_WM);
  /// The present guide; without guidance only the tube around the path remains, and with `help` 0 not even that.
  workcell::Guide guide() const;
  double share() const { return progress_.share(); }
  double help() const { return help_; }
  /// The path is completed: the run can be ended. It is half way between where a run counts as complete and the end, as
  /// the recording that is scored has frames of other times than those given to follow().
  bool isDone() const { return progress_.share() > 0.5 * (trajectory::kCompleteShare + 1.0); }
  const trajectory::Trajectory& expert() const { return expert_; }
  /// Time at which the expert was where the trainee is now, s since the start of the recording.
  double expertTime() const { return progress_.timeAt(progress_.way()) - expert_[0].t; }
  /// Pose of the expert a little ahead, shown to the trainee.
  Pose ahead() const { return progress_.expertAt(std::min(progress_.length(), progress_.way() + exercise_.lead)); }

  /// Scores the recording of the run; `date` as ISO 8601.
  trajectory::TrainingAttempt finish(const trajectory::Trajectory& run, const std::string& date) const;

  static constexpr const char* kGuideName = "training";

 private:
  Exercise exercise_;
  trajectory::Trajectory expert_;
  trajectory::PathProgress progress_;
  double help_ = 1.0;
};

}  // namespace hapticell::manipulation
