// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic/protocol/codec.h"
#include "haptic/protocol/heartbeat.h"
#include "haptic/server/beat_watch.h"
#include "haptic/server/network_server.h"
#include "haptic/server/peer_process.h"
#include "haptic/server/report_budget.h"
#include "haptic/transport/message_stream.h"

namespace hapticell::haptic {

/// The connections of a NetworkServer and their rules: who may control, what each may send, how long it may be silent.
/// Used by the network thread only.
class ClientTable {
 public:
  /// All must outlive the table.
  ClientTable(ForceLoop& loop, const Clock& clock, const DeviceDescription& device, const NetworkOptions& options);
  ~ClientTable();  ///< Closes everything.

  /// Adds a new connection. False: another one had to be closed for it; accept the next one later.
  bool add(std::unique_ptr<ByteStream> connection);

  /// Sends the loop's newest state and, about ten times a second, its statistics to all welcomed clients. If the stylus
  /// does not move and there are no forces, the state is sent only 20 times a second, so that the clients can be idle
  /// too.
  void broadcast();

  /// Ends connections that were silent for too long and removes closed ones.
  void sweep();

  bool empty() const { return clients_.empty(); }

 private:
  struct Client {
    std::shared_ptr<MessageStream> stream;
    std::string name;                ///< For messages: program and address.
    std::string network;             ///< MessageStream::peerNetwork().
    bool has_key = false;            ///< The client has proven that it has the key.
    std::optional<ClientKind> kind;  ///< Once welcomed.
    std::int64_t since_ns = 0;       ///< Time of the connection, or of the refusal.
    std::int64_t heard_ns = 0;
    HeartbeatExchange heartbeat;
    BeatWatch beats;
    bool wants_condition = false;
    bool gone = false;
  };

  static bool waits(const Client& client);
  bool makeRoom(const std::string& network);
  void dropOldest(const std::string& network);
  void limitFarewells();
  std::optional<Refusal> crowded(const Client& client) const;
  void opened(Client& client);
  void hear(Client& client, const Message& message);
  void hearHello(Client& client, const Hello& hello);
  bool grantControl(Client& client, const Hello& hello);
  void hearController(Client& client, const Message& message);
  void welcome(Client& client, ClientKind kind);
  void submitSet(const Client& client, const ConstraintSet& set);
  void refuse(Client& client, const std::string& sentence);
  void refuse(Client& client, Refusal refusal);
  void drop(Client& client, const std::string& why);
  void report(ReportBudget::Kind kind, const std::string& sentence);
  void report(const Client& client, const std::string& sentence);
  bool isNews(const HapticState& state) const;
  void reportStall(bool stalled);
  void sendCondition();
  bool overdue(const Client& client, std::int64_t now) const;
  bool controllerIsSilent() const;

  ForceLoop& loop_;
  const Clock& clock_;
  const DeviceDescription& device_;
  const NetworkOptions& options_;
  ReportBudget reports_;
  std::string controllers_network_;  // Network of the current or last controller; a place is kept free for its return.
  Encoder encoder_;
  ConstraintSet stamped_;  // A set on its way to the loop, with its stamp in the loop's clock.
  std::vector<std::unique_ptr<Client>> clients_;
  Client* controller_ = nullptr;
  std::optional<PeerProcess> controllers_process_;  // If the controller is on this machine and visible.
  HapticState told_state_;
  std::int64_t told_ns_ = 0;          // When the state was sent; 0: send the next one in any case.
  std::uint64_t told_condition_ = 0;  // DeviceCare::changes() that was sent.
  bool stalled_ = false;              // The value in the last report.
};

}  // namespace hapticell::haptic
