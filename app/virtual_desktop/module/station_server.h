// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include "app/virtual_desktop/devices/server_process.h"

namespace hapticell::app {

class Host;

/// The haptic server that the window looks for: its address, its device, and the process where it is our own. GUI
/// thread.
class StationServer : public QObject {
  Q_OBJECT
 public:
  /// As the configuration has it. The host must outlive it.
  explicit StationServer(Host& host);

  const QString& host() const { return server_host_; }
  int port() const { return server_port_; }
  QString address() const;
  /// Another one from now on, kept in the user's configuration; an own process ends.
  void use(const QString& host, int port);
  /// The device of the own server.
  const QString& profile() const { return profile_; }
  /// Another device for it; an own process ends.
  void setProfile(const QString& profile);

  /// The own process runs.
  bool isRunning() const { return server_.isRunning(); }
  /// Now, instead of waiting for one.
  void start();
  void stop() { server_.stop(); }
  /// The window begins to look for a server.
  void beginLooking();
  /// A server answers, or does so no more.
  void setAnswered(bool answers);
  /// None answers: starts one, once, where this machine is the station and none came within 0.7 s.
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
