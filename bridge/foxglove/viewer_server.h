// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::bridge {

/// A kind of message that viewers can subscribe to, as Foxglove's WebSocket protocol describes it.
struct ViewerTopic {
  std::string name;             ///< "/tf"
  std::string encoding;         ///< "cdr" or "json"
  std::string schema_name;      ///< "tf2_msgs/msg/TFMessage", "foxglove.SceneUpdate"
  std::string schema_encoding;  ///< "ros2msg" or "jsonschema"
  std::string schema;           ///< The definition in that encoding.
};

/// Where to listen.
struct ViewerAddress {
  std::string host = "127.0.0.1";  ///< An IP address of this machine; "0.0.0.0": all of them.
  std::uint16_t port = 8765;       ///< Foxglove's usual port; 0: any that is free.
  /// Viewers have to name this in the address ("ws://HOST:PORT/CODE"). Empty: they need not. Letters, digits and '-'.
  std::string code;
};

/// Is it an address that only programs of this machine reach: 127.0.0.0/8 or ::1? False for what is no IP address.
bool isThisMachine(const std::string& host);
/// IPv4 addresses at which other machines may reach this one; empty without a network.
std::vector<std::string> addressesForOthers();

/// Serves messages to viewers over WebSocket (foxglove.websocket.v1), in a thread of its own. Viewers only watch: what
/// they send beyond subscriptions is ignored.
///
/// A web page of another site is refused: of browsers, only pages of this machine and of the viewers' own sites may
/// connect (the header Origin). At most 16 viewers. One that does not read fast enough gets fewer messages, the newest;
/// kept messages (keep()) it gets all.
class ViewerServer {
 public:
  /// Errors: the address is no IP address or is not this machine's, the port is taken, no code for an address that
  /// other machines reach.
  static Expected<std::unique_ptr<ViewerServer>> listen(const ViewerAddress& address);
  /// Ends all connections.
  ~ViewerServer();
  ViewerServer(const ViewerServer&) = delete;
  ViewerServer& operator=(const ViewerServer&) = delete;

  // Any thread; no call waits for a viewer.

  /// Announces a topic to all viewers. Returns its number. @pre the name is new
  std::uint32_t addTopic(const ViewerTopic& topic);
  /// Sends a message to all that subscribed to the topic. `stamp_ns`: nanoseconds since 1970.
  void publish(std::uint32_t topic, std::int64_t stamp_ns, std::string message);
  /// The same, and to all that subscribe later: the newest message for each `key`, in the order of their first use.
  /// @pre the key is not empty
  void keep(std::uint32_t topic, const std::string& key, std::int64_t stamp_ns, std::string message);

  std::uint16_t port() const;
  std::size_t viewers() const;
  /// Messages sent to viewers so far, and those that slow viewers did not get.
  std::uint64_t sent() const;
  std::uint64_t dropped() const;

 private:
  class Impl;
  explicit ViewerServer(std::shared_ptr<Impl> impl);
  std::shared_ptr<Impl> impl_;
};

}  // namespace hapticell::bridge
