// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "trajectory/training/training.h"

namespace hapticell::app {

/// A trainee's results at one exercise, and their file; runs are stored next to it. GUI thread.
class TrainingResults {
 public:
  const trajectory::TrainingSession& session() const { return session_; }
  trajectory::TrainingSession& session() { return session_; }
  /// Sets the file; empty: named by trainee and exercise, in the user's data.
  void setPath(const QString& path) { path_ = path; }
  /// Reads the results of this trainee at this exercise (empty: none, nothing is read). Error: the file cannot be read;
  /// then there are no results yet.
  Expected<void> load(const QString& trainee, const std::string& exercise);
  Expected<void> keep() const;
  /// Writes a run next to the results; returns its name relative to them.
  Expected<std::string> keepRun(const trajectory::Trajectory& run) const;
  Expected<trajectory::Trajectory> readRun(std::size_t attempt) const;

 private:
  QString file() const;

  QString path_, trainee_;
  std::string exercise_;
  trajectory::TrainingSession session_;
};

}  // namespace hapticell::app
