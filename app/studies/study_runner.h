// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/system/error.h"
#include "studies/cluster/cluster_run.h"
#include "studies/runner/study_run.h"

namespace hapticell::app {

/// The version that rows of studies name, as the command line has it: both can continue each other's runs.
std::string studyVersion();

/// Runs a study in the background on all cores, or follows its job on a cluster; one at a time. GUI thread; signals come
/// ten times a second at most.
class StudyRunner : public QObject {
  Q_OBJECT
 public:
  enum class State { kIdle, kPreparing, kRunning, kStopping, kCluster };
  struct Progress {
    std::size_t done = 0, total = 0;
    std::optional<double> seconds_left;  ///< Empty before the first one is done.
  };

  explicit StudyRunner(QObject* parent = nullptr);
  /// Cancels; the thread ends by itself after the variants that are being evaluated.
  ~StudyRunner() override;

  State state() const;
  bool isBusy() const { return run_ != nullptr; }
  Progress progress() const;
  /// Chunks of the job in Slurm, and its number. @pre state() is kCluster
  studies::ClusterProgress clusterProgress() const;

  /// Runs what the store does not have yet. The results file is `results` if it is new or of this very study, else the
  /// first free of "NAME-2", "NAME-3" ...; began() gives its name. Does nothing while isBusy().
  void start(const QString& study, const QString& results);
  /// Submits and follows a job; its merged results are then in `output`. Does nothing while isBusy().
  void submit(const studies::SlurmJob& job, const QString& output, const studies::ClusterOptions& options);
  /// Ends the run after the variants that are being evaluated; rows so far are kept. A job in Slurm continues.
  void cancel();

 signals:
  /// The study is ready and its results file is open; `study` also gives the cells of variants. `rows` were there before.
  void began(const QString& results, std::shared_ptr<const hapticell::studies::Study> study,
             const std::vector<hapticell::studies::ResultRow>& rows);
  void rowsCame(const std::vector<hapticell::studies::ResultRow>& rows);
  void progressed();
  /// Not complete: it was cancelled.
  void ended(bool complete);
  void failed(const hapticell::Error& error);
  /// A job has ended and its results are there.
  void merged(const QString& results);

 private:
  struct Run;
  void begin(std::shared_ptr<Run> run);
  void look();

  std::shared_ptr<Run> run_;  ///< Null: idle.
  QTimer poll_;
};

}  // namespace hapticell::app
