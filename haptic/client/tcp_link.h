// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "haptic/client/haptic_link.h"

namespace hapticell::haptic {

/// Which server to connect to, and as what. Times in seconds.
struct TcpLinkOptions {
  std::string host = "127.0.0.1";  ///< An IP address or a name.
  std::uint16_t port = 4747;
  ClientKind kind = ClientKind::kController;
  bool accept_watching = false;       ///< Watch where another program controls the stylus already.
  std::string program = "HaptiCell";  ///< How the server names this client to others.
  double retry_time = 0.5;            ///< Between two attempts to connect.
  double silence_time = 1.0;          ///< A server silent for so long is given up and connected to anew.
};

/// A HapticLink over TCP.
///
/// Its own network thread connects, connects again within a second when the connection breaks, sends heart-beats and
/// what is newest. What was sent while there was no connection is dropped, and after a new connection forces are off
/// until sendControl() enables them again. Calls never wait for the network.
class TcpLink final : public HapticLink {
 public:
  /// Starts connecting.
  explicit TcpLink(const TcpLinkOptions& options = {});
  ~TcpLink() override;

  LinkState linkState() const override;
  std::string problem() const override;
  std::optional<DeviceDescription> device() const override;
  /// What the server took this client as; kController before the first connection.
  ClientKind grantedKind() const;
  /// How often a connection was made so far; counts up at each new one.
  std::uint64_t connections() const;

  std::optional<HapticState> latestState() override;
  std::optional<ServerStatistics> latestStatistics() override;
  void sendSet(const ConstraintSet& set) override;
  void sendControl(const HapticControl& control) override;
  void sendHandTarget(const HandTarget& target) override;

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace hapticell::haptic
