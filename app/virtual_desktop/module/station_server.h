// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include "app/virtual_desktop/devices/server_process.h"

namespace hapticell::app {

class Host;

/// The haptic server that the window looks for: its address, its device, and the process if the window started it. GUI
/// thread.
class StationServer : public QObject {
  Q_OBJECT
 public:
  /// Starts with the configured server. The host must outlive it.
  explicit StationServer(Host& host);

  const QString& host() const { return server_host_; }
  int port() const { return server_port_; }
  QString address() const;
  /// Uses another server from now on, stored in the user's configuration; ends the window's own process.
  void use(const QString& host, int port);
  /// The device of the window's own server.
  const QString& profile() const { return profile_; }
  /// Sets another device for it; ends the own process.
  void setProfile(const QString& profile);

  /// True while the own process runs.
  bool isRunning() const { return server_.isRunning(); }
  /// Starts the own server now, instead of waiting for another one.
  void start();
  void stop() { server_.stop(); }
  /// The window starts to look for a server.
  void beginLooking();
  /// A server answers, or stopped answering.
  void setAnswered(bool answers);
  /// No server answers: starts one, once, if this machine is the station and none answered within 0.7 s.
  void help();

 private:
  Host& host_;
  ServerProcess server_;
  QString server_host_;
  int server_port_ = 0;
  QString profile_;
  QElapsedTimer connecting_;
  bool tried_ = false, worked_ = false;
};

}  // namespace hapticell::app
