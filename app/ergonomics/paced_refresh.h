// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hapticell::app {

/// Asks for numbers to be shown at most ten times a second: those that change faster are not read, and cost frames
/// while a hand is drawn. GUI thread.
class PacedRefresh : public QObject {
  Q_OBJECT
 public:
  PacedRefresh();
  /// They are to be shown: now, or a little later. `at_once`: now in any case.
  void ask(bool at_once);
  /// They have been shown.
  void shown() { since_shown_.start(); }

 signals:
  void due();

 private:
  QElapsedTimer since_shown_;
  QTimer late_;
};

}  // namespace hapticell::app
