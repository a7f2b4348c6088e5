// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

namespace hapticell::app {

/// The program's event loop, which survives running out of memory.
///
/// If an event needs more memory than available (std::bad_alloc), only that event is given up; document commands are
/// done completely or not at all. Other exceptions are program errors and end it: hence the recovery copies.
class Application : public QApplication {
  Q_OBJECT
 public:
  using QApplication::QApplication;

  /// Receives the events of all objects. False for an event that was given up.
  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// Emitted from the GUI thread after the failed event was left.
  void outOfMemory();
};

class Host;

/// What the window does then: reverts an open undo step, and shows a message with what to do.
void reportOutOfMemory(Host& host);

}  // namespace hapticell::app
