// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/studies/study_runner.h"

class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class LiveLabel;
class StudyDraft;
class ValueField;

/// Runs the study: here, with progress and time left, or on a cluster, whose script is shown before it is submitted.
class StudyRunSection : public QWidget {
  Q_OBJECT
 public:
  StudyRunSection(Host& host, StudyDraft& draft, StudyRunner& runner, QWidget* parent = nullptr);
  /// "1 h 05 min", "12 s"
  static QString durationText(double seconds);

 signals:
  /// The study must be in a file first: true if it is.
  bool saveWanted();

 private:
  void addCluster(QVBoxLayout& column);
  bool isReady();
  void run();
  void makeScript();
  void submit();
  void refresh();
  QString resultsFile() const;

  Host& host_;
  StudyDraft& draft_;
  StudyRunner& runner_;
  QPushButton *run_, *stop_, *cluster_, *script_, *submit_;
  QProgressBar* bar_;
  LiveLabel* says_;
  QWidget* cluster_page_;
  ValueField *chunks_, *cpus_;
  QLineEdit *time_, *partition_;
  QPlainTextEdit* text_;
  std::optional<studies::SlurmJob> job_;  ///< Whose script is shown.
  QString output_, last_;                 ///< last_: how the last run ended.
};

}  // namespace hapticell::app
