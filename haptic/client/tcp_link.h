// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "haptic/transport/haptic_link.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::haptic {

class ServerConnection;

/// Which server to connect to, and in which role. Times in seconds.
struct TcpLinkOptions {
  std::string host = "127.0.0.1";  ///< An IP address or a name.
  std::uint16_t port = 4747;
  std::optional<PairingKey>
      key{};  ///< The pairing key of this station and the server; unset: unencrypted, this machine only.
  ClientKind kind = ClientKind::kController;
  /// If another program already controls the stylus, connect as a watcher; the stylus's buttons are then ignored.
  bool accept_watching = false;
  std::string program = "HaptiCell";  ///< How the server names this client to others.
  double retry_time = 0.5;            ///< Between two attempts to connect.
  double silence_time = 1.0;          ///< After this much silence the link reconnects.
};

/// Options for the server at host:port with this user's key for it (knownServerKeyFile()), if there is one. Error: the
/// key file cannot be used.
Expected<TcpLinkOptions> linkOptionsFor(const std::string& host, std::uint16_t port);

/// A HapticLink over TCP, or over TLS 1.3 if a key is given. Without a key it connects only to this machine.
///
/// Its own network thread connects, reconnects within a second if the connection breaks, and sends heart-beats and the
/// newest messages. Messages sent without a connection are dropped. After a reconnection forces are off until
/// sendControl() enables them again. Calls never wait for the network.
class TcpLink final : public HapticLink {
 public:
  /// Starts connecting.
  explicit TcpLink(const TcpLinkOptions& options = {});
  ~TcpLink() override;

  LinkState linkState() const override;
  LinkProblem problem() const override;
  std::optional<DeviceDescription> device() const override;
  /// The role that the server granted; kController before the first connection.
  ClientKind grantedKind() const;
  /// Number of connections made so far.
  std::uint64_t connections() const;
  /// The device's condition, once the server has sent it; empty if not connected. Any thread.
  std::optional<DeviceCondition> condition() const;
  /// Reconnects and takes control of the stylus from the current controller. Call it only at the user's request. Any
  /// thread.
  void takeOver();
  /// Reports that the user has done calibration step `step`. Any thread; does nothing if not connected.
  void calibrate(std::uint32_t step);

  std::optional<HapticState> latestState() override;
  std::optional<ServerStatistics> latestStatistics() override;
  void sendSet(const ConstraintSet& set) override;
  void sendControl(const HapticControl& control) override;
  void sendHandTarget(const HandTarget& target) override;

 private:
  std::unique_ptr<ServerConnection> connection_;
  bool watches_;
};

}  // namespace hapticell::haptic
