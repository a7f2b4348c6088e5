// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bridge/foxglove/viewer_server.h"

namespace hapticell::bridge {

/// A message for all viewers; the bytes are shared.
struct ViewerMessage {
  std::uint32_t topic = 0;
  std::int64_t stamp_ns = 0;
  std::shared_ptr<const std::string> bytes;
  /// While it waits, it is replaced by a newer one of the same topic and key. Empty: it is not kept for viewers who come
  /// later.
  std::string key;
};

/// What a new viewer is sent: the topics, and the messages kept for them.
struct ViewerBoard {
  struct Topic {
    std::uint32_t id = 0;
    ViewerTopic topic;
    std::vector<ViewerMessage> kept;  ///< One a key, in the order of their first use.
  };
  std::vector<Topic> topics;

  void keep(const ViewerMessage& message);
};

/// Read by any thread.
struct ViewerCounts {
  std::atomic<std::size_t> viewers{0};
  std::atomic<std::uint64_t> sent{0}, dropped{0};
};

/// The connection of one viewer. Used by the server's network thread only; lives as long as one of its operations.
class ViewerSession : public std::enable_shared_from_this<ViewerSession> {
 public:
  ViewerSession(boost::asio::ip::tcp::socket socket, const std::string& code, const ViewerBoard& board,
                ViewerCounts& counts);
  ~ViewerSession();

  /// Reads the request and answers it: a WebSocket, a page that says how to watch, or a refusal.
  void start();
  void close();
  bool isClosed() const { return is_closed_; }
  void advertise(const ViewerBoard::Topic& topic);
  /// If the viewer has subscribed to the topic.
  void send(const ViewerMessage& message);

 private:
  /// A text of the protocol, or a message of a topic.
  struct Outgoing {
    std::string text;
    std::uint32_t subscription = 0;
    ViewerMessage message;
  };

  void answer();
  void refuse(boost::beast::http::status status, const std::string& why);
  void open();
  void read();
  void hear(const std::string& text);
  void subscribe(std::uint32_t subscription, std::uint32_t topic);
  void queue(Outgoing outgoing);
  void queueText(std::string text);
  void writeNext();

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  const std::string code_;
  const ViewerBoard& board_;
  ViewerCounts& counts_;
  boost::beast::flat_buffer buffer_;
  boost::beast::http::request_parser<boost::beast::http::empty_body> request_;
  boost::beast::http::response<boost::beast::http::string_body> page_;
  std::map<std::uint32_t, std::uint32_t> subscriptions_;  // Topic: subscription.
  std::deque<Outgoing> queue_;
  std::string frame_;  // Being written.
  bool is_open_ = false, is_writing_ = false, is_closed_ = false;
};

}  // namespace hapticell::bridge
