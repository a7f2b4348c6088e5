// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace hapticell::app {

/// Progress of an import or of opening a cell. GUI thread.
class ImportProgress : public QWidget {
  Q_OBJECT
 public:
  explicit ImportProgress(QWidget* parent = nullptr);
  /// `words`: the present stage; `share`: 0 to 1 of the whole; `seconds_left`: shown if long enough.
  void showWork(const QString& words, double share, double seconds_left);

 private:
  QLabel *stage_, *share_;
  QProgressBar* bar_;
};

}  // namespace hapticell::app
