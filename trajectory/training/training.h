// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::trajectory {

/// Share of the expert's way from which a run counts as complete: a hand that stops a hair before the end is there.
// Half the rest: some runs are never complete; twice: a run is complete 4 % before the end.
constexpr double kCompleteShare = 0.98;

/// A trainee's run compared with the expert's motion.
struct TrainingScore {
  double completed = 0.0;                            ///< Share of the expert's path that was completed, 0 .. 1.
  double time = 0.0, expert_time = 0.0;              ///< s
  double mean_deviation = 0.0, max_deviation = 0.0;  ///< m from the expert's path.
  double mean_turn = 0.0;                            ///< rad
  double mean_force = 0.0, max_force = 0.0;          ///< N on the hand; 0 where none was recorded.
  /// Logarithm of the dimensionless jerk of the hand's motion (N. Hogan, D. Sternad, "Sensitivity of smoothness
  /// measures to movement duration, amplitude, and arrests", J. Motor Behavior 41(6), 2009): about -7 for one smooth
  /// reach, lower if the motion is less smooth.
  double smoothness = 0.0, expert_smoothness = 0.0;
  int contacts = 0;           ///< Number of contacts.
  double contact_time = 0.0;  ///< s
  /// 0 to 100, from path completed, time, deviation, force, smoothness and contacts, each relative to the expert's; 100
  /// is as good as the expert.
  double points = 0.0;
};

/// The parts of the score; weights need not add up to 1. A part with weight 0 does not count.
struct ScoringRule {
  double deviation = 0.02;  ///< m of mean deviation at which all points of this part are lost.
  double force = 5.0;       ///< N above the expert's greatest force at which all are lost.
  double slowness = 3.0;    ///< Times the expert's time at which all are lost.
  double smoothness = 6.0;  ///< Difference from the expert's value at which all are lost.
  int contacts = 5;         ///< Contacts more than the expert's at which all are lost.
  double weight_time = 1.0, weight_deviation = 2.0, weight_force = 1.0, weight_smoothness = 1.0, weight_contacts = 1.0;
};

/// Scores a run against the expert's motion of the same moved frame. A run without motion has 0 points.
/// @pre the expert has frames
TrainingScore scoreRun(const Trajectory& expert, const Trajectory& run, const ScoringRule& rule = {});

/// Guidance for the next run (0 .. 1): a fifth less after a success (at least `pass` points, whole path completed), a
/// tenth more after two failures in a row, otherwise unchanged.
double nextHelp(double help, bool success, bool failed_before);

/// The purpose of a run. Only practice is guided; points of guided runs do not prove that something was learned.
enum class RunKind {
  kPractice,   ///< With the guidance that the runs before call for.
  kRetention,  ///< Without guidance, some time after the practice.
  kTransfer    ///< Without guidance, at an exercise that was not practised.
};
/// "practice", "retention", "transfer", as in the files.
const char* wordOf(RunKind kind);
/// The reverse; empty: no such kind.
std::optional<RunKind> parseRunKind(const std::string& word);

/// One run of a trainee.
struct TrainingAttempt {
  std::string date;  ///< ISO 8601, local time with zone as the caller gave it.
  double help = 1.0;
  bool success = false;
  TrainingScore score;
  RunKind kind = RunKind::kPractice;
  std::string recording = {};  ///< File of the run, relative to the results file; empty: not kept.
};

/// All runs of one trainee at one exercise, in a file of its own (*.htrain, JSON).
struct TrainingSession {
  std::string trainee, exercise;
  std::vector<TrainingAttempt> attempts;
  /// Guidance at the start of the next practice: 1 for the first. Runs without guidance do not change it.
  double nextHelp() const;
  std::size_t count(RunKind kind) const;
  /// Seconds from the newest practice before this date (ISO 8601) to the date; empty: no practice before it, or a date
  /// that cannot be read. Dates without a zone are compared unchanged.
  std::optional<double> restBefore(const std::string& date) const;
};

/// Errors name file and attempt; a newer version is refused.
Expected<TrainingSession> readTraining(const std::filesystem::path& file);
/// The same from a text; errors use `name` as the file.
Expected<TrainingSession> parseTraining(std::string_view text, const std::string& name);
std::string toJsonText(const TrainingSession& session);
/// One line per attempt, header with units; kind and rest_s (s since the practice before it) come last.
std::string toCsvText(const TrainingSession& session);

}  // namespace hapticell::trajectory
