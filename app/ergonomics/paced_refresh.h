// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hapticell::app {

/// Limits a refresh of numbers to ten times a second: numbers that change faster cannot be read, and cost frames while
/// a hand is dragged. GUI thread.
class PacedRefresh : public QObject {
  Q_OBJECT
 public:
  PacedRefresh();
  /// Asks for a refresh: now, or a little later. `at_once`: now in any case.
  void ask(bool at_once);
  /// The numbers have been refreshed.
  void shown() { since_shown_.start(); }

 signals:
  void due();

 private:
  QElapsedTimer since_shown_;
  QTimer late_;
};

}  // namespace hapticell::app
