// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QSocketNotifier;

namespace hapticell::app {

/// Reports that the system asks the program to end (SIGTERM at shutdown, SIGHUP when the terminal closes, SIGINT), in
/// the thread that made it, from its event loop. One at a time; does nothing on systems without such signals.
class EndSignals : public QObject {
  Q_OBJECT
 public:
  explicit EndSignals(QObject* parent = nullptr);
  ~EndSignals() override;

 signals:
  void asked(int number);

 private:
  QSocketNotifier* notifier_ = nullptr;
};

}  // namespace hapticell::app
