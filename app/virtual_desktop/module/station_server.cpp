// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/station_server.h"

#include <utility>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/settings/configuration_page.h"
#include "app/virtual_desktop/devices/station_pairing.h"

namespace hapticell::app {
namespace {

// ms without an answer until a server is started: one that runs answers sooner. Half: a busy one gets a rival that ends
// at once; twice: one waits.
constexpr int kServerPatience = 700;

}  // namespace

StationServer::StationServer(Host& host)
    : host_(host),
      server_host_(QString::fromStdString(host.configuration().server.host)),
      server_port_(host.configuration().server.port),
      profile_(QString::fromStdString(host.configuration().haptic.device)) {
  connect(&server_, &ServerProcess::warned, this,
          [this](const QString& sentence) { host_.messages().tell(Severity::kWarning, sentence); });
  connect(&server_, &ServerProcess::ended, this, [this](const QString& sentence) {
    // One that has worked is started again; one that cannot start is not tried for ever.
    const bool worked = std::exchange(worked_, false);
    if (worked) tried_ = false;
    host_.messages().tell(Severity::kProblem, sentence,
                          worked
                              ? tr("Forces are off. The server is restarting. Then press Ctrl+Space to turn them on.")
                              : tr("Forces are off. Connect again to restart it."));
  });
}

QString StationServer::address() const {
  return QStringLiteral("%1:%2").arg(server_host_).arg(server_port_);
}

void StationServer::use(const QString& host, int port) {
  server_.stop();
  server_host_ = host;
  server_port_ = port;
  auto kept = writeSetting(userConfigurationFile(), QStringLiteral("server.host"), host);
  if (kept) kept = writeSetting(userConfigurationFile(), QStringLiteral("server.port"), QString::number(port));
  if (!kept)
    host_.messages().reportCause(Severity::kWarning, tr("%1 is used, but only until you quit.").arg(address()),
                                 kept.error());
}

void StationServer::setProfile(const QString& profile) {
  profile_ = profile;
  server_.stop();
}

void StationServer::start() {
  tried_ = true;
  server_.start(profile_, server_port_);
}

void StationServer::beginLooking() {
  connecting_.start();
  tried_ = false;
}

void StationServer::setAnswered(bool answers) {
  if (answers) {
    worked_ = server_.isRunning();
  } else {
    connecting_.restart();
    tried_ = server_.isRunning();
  }
}

void StationServer::help() {
  if (tried_ || !isThisStation(server_host_) || connecting_.elapsed() < kServerPatience) return;
  start();
}

}  // namespace hapticell::app
