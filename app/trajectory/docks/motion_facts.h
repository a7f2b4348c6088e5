// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class MotionList;

/// Name and facts of the current motion, the result of the last edit, and the progress of a longer one. GUI thread.
class MotionFacts : public QObject {
  Q_OBJECT
 public:
  /// Adds name and facts. The list must outlive it.
  MotionFacts(MotionList& list, QVBoxLayout& section, QObject* parent = nullptr);
  /// Adds the line of results and the progress bar below what was added in between.
  void addResult(QVBoxLayout& section);

  void show();
  void showLine(const QString& line, bool careful);
  void markMissed();  ///< Makes the shown result red, because it missed what was asked, until the next one.

 private:
  void showProgress();

  MotionList& list_;
  QLineEdit* name_;
  QLabel *facts_, *line_, *busy_;
  QProgressBar* progress_;
  QPushButton* cancel_;
};

}  // namespace hapticell::app
