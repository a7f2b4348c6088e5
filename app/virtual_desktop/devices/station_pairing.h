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

/// Tries a haptic server with its code, and keeps the code if it is correct: does for the window what `hapticell-cli
/// pair` does. Connects as an observer, so no client loses the stylus. GUI thread; never waits.
class StationPairing : public QObject {
  Q_OBJECT
 public:
  explicit StationPairing(QObject* parent = nullptr);

  /// Starts a trial; tried() follows in any case, at the latest after kPatience. An empty `code` means the stored one,
  /// or none (this machine). Cancels a running trial.
  void start(const QString& host, int port, const QString& code);
  void cancel();
  bool isRunning() const { return link_ != nullptr; }

  /// Whether this user has a code for that server.
  static bool knows(const QString& host, int port);

  /// ms that a station may take to answer, in a network with losses. Half: slow ones fail; twice: the user waits long
  /// for a wrong address.
  static constexpr int kPatience = 5000;

 signals:
  /// `sentence` names the device, or the problem and its remedy.
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
