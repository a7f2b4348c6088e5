// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "haptic/client/tcp_link.h"

namespace hapticell::app {

/// Whether an address means this machine: localhost, 127.x.x.x or ::1.
bool isThisStation(const QString& host);

/// Tries a haptic server and its code, and keeps the code when it fits: what `hapticell-cli pair` does, for the window.
/// It connects as a watcher, so the stylus is taken from nobody. GUI thread; never waits.
class StationPairing : public QObject {
  Q_OBJECT
 public:
  explicit StationPairing(QObject* parent = nullptr);

  /// Begins; tried() follows in any case, at the latest after kPatience. An empty `code` stands for the one that is
  /// kept already, or for none (this machine). A running trial is given up.
  void start(const QString& host, int port, const QString& code);
  void cancel();
  bool isRunning() const { return link_ != nullptr; }

  /// Whether this user has a code for that server.
  static bool knows(const QString& host, int port);

  /// ms that a station may take to answer, in a network with losses. Half: slow ones fail; twice: one waits for a wrong
  /// address.
  static constexpr int kPatience = 5000;

 signals:
  /// `sentence` names the device, or says what is wrong and what to do.
  void tried(bool fits, const QString& sentence);

 private:
  void look();
  void end(bool fits, const QString& sentence);

  std::unique_ptr<haptic::TcpLink> link_;
  std::optional<haptic::PairingKey> typed_;
  QString host_;
  int port_ = 0;
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace hapticell::app
