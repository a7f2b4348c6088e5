// SPDX-License-Identifier: Apache-2.0
// Which haptic server is used, what it says of the device, starting one of our own, and taking the newest scene.
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/settings/configuration_page.h"
#include "app/style/library_text.h"
#include "app/virtual_desktop/devices/station_pairing.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"

namespace hapticell::app {
namespace {

constexpr int kServerPatience = 700;  // Milliseconds without an answer until a server is started.
constexpr int kIdlePeriod = 100;      // Milliseconds between two looks at a scene in which nothing moves.

}  // namespace

QString VirtualDesktopController::deviceLine() const {
  if (!link_) return tr("Not connected");
  if (isWatching()) return tr("Watching: another window has the stylus");
  if (isConnected()) {
    if (!device_) return tr("Connected");
    return device_->simulated ? tr("Connected, simulated") : tr("Connected");
  }
  const QString problem = shownText(link_->problem());
  return problem.isEmpty() ? tr("Connecting") : problem;
}

QString VirtualDesktopController::serverAddress() const {
  return QStringLiteral("%1:%2").arg(server_host_).arg(server_port_);
}

void VirtualDesktopController::useServer(const QString& host, int port) {
  if (host == server_host_ && port == server_port_) return;
  const bool was_started = isStarted();
  disconnectDevice();
  server_.stop();
  server_host_ = host;
  server_port_ = port;
  auto kept = writeSetting(userConfigurationFile(), QStringLiteral("server.host"), host);
  if (kept) kept = writeSetting(userConfigurationFile(), QStringLiteral("server.port"), QString::number(port));
  if (!kept)
    host_.messages().tell(Severity::kWarning,
                          tr("%1 is used, but only until the end of the program.").arg(serverAddress()),
                          QString::fromStdString(kept.error().message()));
  if (was_started) connectDevice();
  emit connectionChanged();
}

ForceFacts VirtualDesktopController::forceFacts() const {
  ForceFacts facts;
  facts.started = isStarted();
  facts.connected = isConnected();
  facts.watching = isWatching();
  facts.lost = forces_lost_;
  facts.forceless = device_ && device_->driven_axes == 0;
  facts.wanted = forces_wanted_;
  facts.on = facts.connected && snapshot_.forces_on;
  facts.ramp = snapshot_.force_ramp;
  facts.device_fault = facts.connected && snapshot_.device_fault;
  // A loop that hangs brings no snapshot that could say so.
  constexpr qint64 kStalled = 2000;  // ms
  facts.stalled = facts.connected && forces_wanted_ &&
                  (snapshot_.loop_stalled || (since_snapshot_.isValid() && since_snapshot_.elapsed() > kStalled));
  facts.cut = forces_cut_;
  constexpr double kEdge = 1e-3;  // m
  facts.at_edge = device_ && snapshot_.device_edge_m < kEdge;
  facts.held = snapshot_.held != 0;
  if (const workcell::Entity* held = host_.documentModel().document().find(snapshot_.held)) {
    facts.checked = held->checked;
    facts.passes = settings_.on_contact == workcell::OnContact::kPass;
  }
  if (link_ && !facts.connected) facts.problem = shownText(link_->problem());
  return facts;
}

void VirtualDesktopController::takeSnapshot() {
  manipulation::SceneSnapshot fresh;
  if (!loop_ || !loop_->latest(fresh) || !isOfCell(fresh)) return;
  sound_.play(soundCue(fresh, snapshot_));
  const bool connected = isConnected();
  const bool cut = connected && snapshot_.forces_on && !fresh.forces_on && forces_wanted_;
  snapshot_ = std::move(fresh);
  since_snapshot_.start();
  if (!connected) {  // What the server said last is not so any more.
    snapshot_.server = {};
    snapshot_.forces_on = false;
    snapshot_.force_n = 0.0;
  }
  if (snapshot_.forces_on) forces_cut_ = false;
  if (cut) tellOfCut();
  const int period = snapshot_.idle ? std::max(kIdlePeriod, busyPeriod()) : busyPeriod();
  if (timer_.interval() != period) timer_.setInterval(period);
  // The pen is drawn as the hand holds it, whatever frame of the entity it moves.
  const dquat q_WD = axes_W();
  snapshot_.X_WStylus.q = glm::normalize(q_WD * snapshot_.X_DS.q);
  updateMouse();
  updateSecondMouse();
  host_.setGuiRate(guiRate());
  host_.setSnapshot(snapshot_);
}

void VirtualDesktopController::showDevice() {
  if (!device_) return host_.setDeviceText(deviceLine(), false);
  const QString forces = forces_lost_          ? tr(" · forces lost")
                         : snapshot_.forces_on ? tr(" · forces on")
                                               : tr(" · forces off");
  host_.setDeviceText(QString::fromStdString(device_->name) + forces, !forces_lost_);
}

void VirtualDesktopController::tellOfCut() {
  forces_cut_ = true;
  sound_.strike(SoundEvent::kFault);
  host_.messages().tell(Severity::kWarning, tr("The forces went off"), forceReason(forceFacts()).why);
}

void VirtualDesktopController::tellOfLoss() {
  sound_.strike(SoundEvent::kFault);
  if (isWatching() || link_->linkState() == haptic::LinkState::kRefused) {
    host_.messages().tell(Severity::kProblem, tr("The forces went off: another window took the stylus"),
                          tr("Take the stylus in the panel Virtual Desktop takes it back."));
    return;
  }
  forces_lost_ = true;
  host_.messages().tell(
      Severity::kProblem, tr("The forces went off: the haptic server is gone"),
      shownText(link_->problem()) + QLatin1Char(' ') +
          tr("What is held stays where it is. Once a server answers again, Ctrl+Space turns the forces on."));
}

void VirtualDesktopController::startServer() {
  server_tried_ = true;
  server_.start(profile_, server_port_);
}

void VirtualDesktopController::chooseDevice(const QString& profile) {
  if (profile == profile_) return;
  if (isConnected() && !server_.isRunning()) {
    host_.messages().tell(
        Severity::kInformation, tr("The stylus is as it was"),
        tr("Another program started the server at %1; the device is chosen there.").arg(serverAddress()));
    emit connectionChanged();
    return;
  }
  profile_ = profile;
  const bool was_started = isStarted();
  disconnectDevice();
  server_.stop();
  if (was_started) connectDevice();
  emit connectionChanged();
}

void VirtualDesktopController::helpServer() {
  // Refused: there is one.
  if (isConnected() || isWatching() || link_->linkState() == haptic::LinkState::kRefused) return;
  if (server_tried_ || !isThisStation(server_host_) || connecting_.elapsed() < kServerPatience) return;
  server_tried_ = true;
  startServer();
}

}  // namespace hapticell::app
