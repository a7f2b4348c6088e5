// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace hapticell::app {

/// How far an import or the opening of a cell is. GUI thread.
class ImportProgress : public QWidget {
  Q_OBJECT
 public:
  explicit ImportProgress(QWidget* parent = nullptr);
  /// `words`: what is done now; `share`: 0 to 1 of the whole; `seconds_left`: said where it is worth it.
  void showWork(const QString& words, double share, double seconds_left);

 private:
  QLabel *stage_, *share_;
  QProgressBar* bar_;
};

}  // namespace hapticell::app
