// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptic/transport/haptic_link.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::haptic {

/// Which server to connect to, and as what. Times in seconds.
struct TcpLinkOptions {
  std::string host = "127.0.0.1";  ///< An IP address or a name.
  std::uint16_t port = 4747;
  std::optional<PairingKey>
      key{};  ///< What this station and the server have in common; none: plain, this machine only.
  ClientKind kind = ClientKind::kController;
  /// Watch where another program controls the stylus already; the stylus's buttons are then not heard.
  bool accept_watching = false;
  std::string program = "HaptiCell";  ///< How the server names this client to others.
  double retry_time = 0.5;            ///< Between two attempts to connect.
  double silence_time = 1.0;          ///< A server silent for so long is given up and connected to anew.
};

/// Options for the server at host:port with the key that this user has for it (knownServerKeyFile()), if any. Error:
/// there is a key file that cannot be used.
Expected<TcpLinkOptions> linkOptionsFor(const std::string& host, std::uint16_t port);

/// A HapticLink over TCP; over TLS 1.3 where a key is given. A server on another machine is not talked to without one.
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
  LinkProblem problem() const override;
  std::optional<DeviceDescription> device() const override;
  /// What the server took this client as; kController before the first connection.
  ClientKind grantedKind() const;
  /// How often a connection was made so far; counts up at each new one.
  std::uint64_t connections() const;
  /// How the device is, once the server has told; nothing while not connected. Any thread.
  std::optional<DeviceCondition> condition() const;
  /// Connects anew and takes the stylus from whoever controls it: the user's word. Any thread.
  void takeOver();
  /// The user has done step `step` of its calibration. Any thread; nothing happens while not connected.
  void calibrate(std::uint32_t step);

  std::optional<HapticState> latestState() override;
  std::optional<ServerStatistics> latestStatistics() override;
  void sendSet(const ConstraintSet& set) override;
  void sendControl(const HapticControl& control) override;
  void sendHandTarget(const HandTarget& target) override;

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
  bool watches_;
};

}  // namespace hapticell::haptic
