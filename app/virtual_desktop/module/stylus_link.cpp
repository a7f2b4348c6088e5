// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/stylus_link.h"

#include <QObject>

#include "app/style/library_text.h"

namespace hapticell::app {

void StylusLink::set(haptic::TcpLink* link) {
  link_ = link;
  if (link_) return;
  device_.reset();
  was_connected_ = was_watching_ = false;
}

bool StylusLink::isConnected() const {
  return link_ && link_->linkState() == haptic::LinkState::kConnected &&
         link_->grantedKind() == haptic::ClientKind::kController;
}

bool StylusLink::isWatching() const {
  return link_ && link_->linkState() == haptic::LinkState::kConnected &&
         link_->grantedKind() == haptic::ClientKind::kWatcher;
}

bool StylusLink::isRefused() const {
  return link_ && link_->linkState() == haptic::LinkState::kRefused;
}

void StylusLink::takeOver() {
  if (isWatching()) link_->takeOver();
}

haptic::LinkProblem StylusLink::problem() const {
  return link_ ? link_->problem() : haptic::LinkProblem();
}

QString StylusLink::line() const {
  if (!link_) return QObject::tr("Not connected");
  if (isWatching()) return QObject::tr("Observing: another window controls the stylus");
  if (isConnected()) {
    if (!device_) return QObject::tr("Connected");
    return device_->simulated ? QObject::tr("Connected, simulated") : QObject::tr("Connected");
  }
  const QString why = shownText(problem());
  return why.isEmpty() ? QObject::tr("Connecting") : why;
}

bool StylusLink::takeConnectionChange() {
  const bool connected = isConnected();
  if (connected == was_connected_) return false;
  was_connected_ = connected;
  device_ = connected ? link_->device() : std::nullopt;
  return true;
}

bool StylusLink::takeWatchingChange() {
  if (isWatching() == was_watching_) return false;
  was_watching_ = !was_watching_;
  return true;
}

std::string StylusLink::takeSentence() {
  const auto condition = link_ ? link_->condition() : std::nullopt;
  if (!condition || condition->sentence == told_sentence_) return {};
  told_sentence_ = condition->sentence;
  return told_sentence_;
}

}  // namespace hapticell::app
