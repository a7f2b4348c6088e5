// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

namespace hapticell::app {

/// The program's event loop, which lives through the end of memory.
///
/// Where what an event began needs more memory than there is (std::bad_alloc), that event ends there; document commands
/// are done whole or not at all. Other exceptions are faults of the program and end it: copies are kept for that.
class Application : public QApplication {
  Q_OBJECT
 public:
  using QApplication::QApplication;

  /// Events of all objects pass here. False for one that was given up.
  bool notify(QObject* receiver, QEvent* event) override;

 signals:
  /// From the GUI thread, when the given-up event has been left.
  void outOfMemory();
};

class Host;

/// What the window does then: an open step of the document is taken back, and a message says what to do.
void reportOutOfMemory(Host& host);

}  // namespace hapticell::app
