// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic/transport/message_stream.h"
#include "haptic/protocol/codec.h"
#include "haptic/protocol/heartbeat.h"
#include "haptic/server/beat_watch.h"
#include "haptic/server/network_server.h"
#include "haptic/server/peer_process.h"
#include "haptic/server/report_budget.h"

namespace hapticell::haptic {

/// The connections of a NetworkServer and the rules that they are held to: who may control, what each may send, how
/// long it may be silent. Used by the network thread only.
class ClientTable {
 public:
  /// All must outlive the table.
  ClientTable(ForceLoop& loop, const Clock& clock, const DeviceDescription& device, const NetworkOptions& options);
  ~ClientTable();  ///< Closes everything.

  /// Takes a connection that has just been made. False: another had to make room for it, take the next one later.
  bool add(std::unique_ptr<ByteStream> connection);

  /// Sends the loop's newest state and, about ten times a second, its statistics to all who were welcomed. A stylus
  /// that lies still without forces is told of 20 times a second only, so that the clients can rest too.
  void broadcast();

  /// Ends what has been silent for too long and forgets what is closed.
  void sweep();

  bool empty() const { return clients_.empty(); }

 private:
  struct Client {
    std::shared_ptr<MessageStream> stream;
    std::string name;                ///< For messages: program and address.
    std::string network;             ///< MessageStream::peerNetwork().
    bool has_key = false;            ///< It has shown it.
    std::optional<ClientKind> kind;  ///< Once welcomed.
    std::int64_t since_ns = 0;       ///< Connected, or told to go.
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
  void tellOfStall(bool stalled);
  void tellCondition();
  bool overdue(const Client& client, std::int64_t now) const;
  bool controllerIsSilent() const;

  ForceLoop& loop_;
  const Clock& clock_;
  const DeviceDescription& device_;
  const NetworkOptions& options_;
  ReportBudget reports_;
  std::string controllers_network_;  // Of who controls, or did last: its way back is kept free.
  Encoder encoder_;
  ConstraintSet stamped_;  // A set on its way to the loop, with its stamp in the loop's clock.
  std::vector<std::unique_ptr<Client>> clients_;
  Client* controller_ = nullptr;
  std::optional<PeerProcess> controllers_process_;  // Where it is on this machine and may be seen.
  HapticState told_state_;
  std::int64_t told_ns_ = 0;          // When it was sent; 0: whatever is next is news.
  std::uint64_t told_condition_ = 0;  // DeviceCare::changes() that was sent.
  bool stalled_ = false;              // As it was reported last.
};

}  // namespace hapticell::haptic
