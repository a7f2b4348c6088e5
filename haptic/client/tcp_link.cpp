// SPDX-License-Identifier: Apache-2.0
#include "haptic/client/tcp_link.h"

#include <filesystem>
#include <system_error>

#include "haptic/client/server_connection.h"

namespace hapticell::haptic {

Expected<TcpLinkOptions> linkOptionsFor(const std::string& host, std::uint16_t port) {
  TcpLinkOptions options;
  options.host = host;
  options.port = port;
  const auto file = knownServerKeyFile(host, port);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return options;
  const auto key = loadKey(file);
  HAPTICELL_TRY(key);
  options.key = *key;
  return options;
}

TcpLink::TcpLink(const TcpLinkOptions& options)
    : connection_(std::make_unique<ServerConnection>(options)), watches_(options.accept_watching) {}

TcpLink::~TcpLink() = default;

LinkState TcpLink::linkState() const {
  return connection_->report.state();
}

LinkProblem TcpLink::problem() const {
  return connection_->report.problem();
}

std::optional<DeviceDescription> TcpLink::device() const {
  return connection_->report.device();
}

void TcpLink::takeOver() {
  connection_->takeOver();
}

ClientKind TcpLink::grantedKind() const {
  return connection_->report.grantedKind();
}

std::optional<DeviceCondition> TcpLink::condition() const {
  return connection_->report.condition();
}

void TcpLink::calibrate(std::uint32_t step) {
  connection_->calibrate(step);
}

std::uint64_t TcpLink::connections() const {
  return connection_->report.connections();
}

std::optional<HapticState> TcpLink::latestState() {
  LinkMailboxes& mailboxes = connection_->mailboxes;
  std::optional<HapticState> newest = LinkMailboxes::newest(mailboxes.states);
  if (newest) newest->buttons = mailboxes.presses.take(newest->buttons);
  if (newest && watches_ && !connection_->report.hasStylus()) newest->buttons = 0;
  return newest;
}

std::optional<ServerStatistics> TcpLink::latestStatistics() {
  return LinkMailboxes::newest(connection_->mailboxes.statistics);
}

void TcpLink::sendSet(const ConstraintSet& set) {
  connection_->submit(connection_->mailboxes.sets, set);
}

void TcpLink::sendControl(const HapticControl& control) {
  connection_->submit(connection_->mailboxes.controls, control);
}

void TcpLink::sendHandTarget(const HandTarget& target) {
  connection_->submit(connection_->mailboxes.targets, target);
}

}  // namespace hapticell::haptic
