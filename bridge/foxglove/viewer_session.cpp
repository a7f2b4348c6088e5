// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/viewer_session.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "geometry/system/nesting_limit.h"

namespace hapticell::bridge {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::system::error_code;
using nlohmann::ordered_json;

constexpr std::string_view kProtocol = "foxglove.websocket.v1";
/// Bytes of a viewer's message; its subscriptions take a few thousand. Half and twice only bound memory.
constexpr std::size_t kMostMessage = 1 << 20;
/// Subscriptions of a viewer; HaptiCell has some twelve topics. Half and twice only bound memory.
constexpr std::size_t kMostSubscriptions = 1000;
/// For the request and its answer. Half: still long for a slow network; twice: a silent peer takes a place longer.
constexpr auto kPatience = std::chrono::seconds(10);

/// Pages whose scripts may watch: those of this machine and of the known viewers. A page of any other site could read
/// the cell of whoever visits it.
bool isWelcomeOrigin(std::string_view origin) {
  static constexpr std::array<std::string_view, 6> kViewers = {
      "https://app.foxglove.dev", "https://studio.foxglove.dev", "https://lichtblick-suite.github.io",
      "http://localhost",         "http://127.0.0.1",            "file://"};
  if (origin.empty() || origin == "null") return origin.empty();
  return std::ranges::any_of(kViewers, [&](std::string_view viewer) {
    if (!origin.starts_with(viewer)) return false;
    const std::string_view rest = origin.substr(viewer.size());
    const bool is_local = viewer.starts_with("http://") || viewer == "file://";
    return rest.empty() || (is_local && rest.starts_with(':') &&
                            rest.find_first_not_of("0123456789", 1) == std::string_view::npos);
  });
}

/// True if one of the protocols that the viewer offers, separated by commas, is ours.
bool offersProtocol(std::string_view offered) {
  while (!offered.empty()) {
    const std::size_t comma = std::min(offered.find(','), offered.size());
    std::string_view name = offered.substr(0, comma);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    if (name == kProtocol) return true;
    offered.remove_prefix(std::min(comma + 1, offered.size()));
  }
  return false;
}

ordered_json jsonOf(const ViewerBoard::Topic& topic) {
  return {{"id", topic.id},
          {"topic", topic.topic.name},
          {"encoding", topic.topic.encoding},
          {"schemaName", topic.topic.schema_name},
          {"schema", topic.topic.schema},
          {"schemaEncoding", topic.topic.schema_encoding}};
}

template <typename Number>
void appendRaw(std::string& bytes, Number number) {
  for (std::size_t k = 0; k < sizeof number; ++k) bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * k));
}

constexpr std::string_view kPage =
    "HaptiCell serves a live view here.\n\n"
    "Open it with Foxglove (https://app.foxglove.dev) or Lichtblick: choose 'Open connection', 'Foxglove WebSocket', and\n"
    "this address with ws:// in place of http://\n";

}  // namespace

void ViewerBoard::keep(const ViewerMessage& message) {
  for (Topic& topic : topics) {
    if (topic.id != message.topic) continue;
    const auto known = std::ranges::find(topic.kept, message.key, &ViewerMessage::key);
    if (known == topic.kept.end()) {
      topic.kept.push_back(message);
    } else {
      *known = message;
    }
  }
}

ViewerSession::ViewerSession(asio::ip::tcp::socket socket, const std::string& code, const ViewerBoard& board,
                             ViewerCounts& counts)
    : socket_(std::move(socket)), code_(code), board_(board), counts_(counts) {}

ViewerSession::~ViewerSession() {
  if (is_open_) --counts_.viewers;
}

void ViewerSession::start() {
  error_code ignored;
  beast::get_lowest_layer(socket_).socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  beast::get_lowest_layer(socket_).expires_after(kPatience);
  http::async_read(socket_.next_layer(), buffer_, request_, [self = shared_from_this()](error_code failed, std::size_t) {
    if (failed) return self->close();
    self->answer();
  });
}

void ViewerSession::close() {
  if (is_closed_) return;
  is_closed_ = true;
  beast::get_lowest_layer(socket_).close();
}

void ViewerSession::answer() {
  const auto& request = request_.get();
  const std::string_view target(request.target().data(), request.target().size());
  const auto origin = request[http::field::origin];
  if (!isWelcomeOrigin({origin.data(), origin.size()}))
    return refuse(http::status::forbidden, "Pages of this site may not watch.\n");
  if (!code_.empty() && target != "/" + code_)
    return refuse(http::status::forbidden, "The address must end with the code that HaptiCell shows.\n");
  if (!websocket::is_upgrade(request)) return refuse(http::status::ok, std::string(kPage));
  const auto offered = request[http::field::sec_websocket_protocol];
  if (!offersProtocol({offered.data(), offered.size()}))
    return refuse(http::status::bad_request, "The viewer does not speak foxglove.websocket.v1.\n");
  open();
}

void ViewerSession::refuse(http::status status, const std::string& why) {
  page_ = {status, 11};
  page_.set(http::field::content_type, "text/plain; charset=utf-8");
  page_.body() = why;
  page_.keep_alive(false);
  page_.prepare_payload();
  http::async_write(socket_.next_layer(), page_, [self = shared_from_this()](error_code, std::size_t) { self->close(); });
}

void ViewerSession::open() {
  beast::get_lowest_layer(socket_).expires_never();  // The WebSocket has its own limits of time.
  socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  socket_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(http::field::sec_websocket_protocol, beast::string_view(kProtocol.data(), kProtocol.size()));
  }));
  socket_.read_message_max(kMostMessage);
  socket_.auto_fragment(false);  // Messages arrive whole.
  socket_.async_accept(request_.get(), [self = shared_from_this()](error_code failed) {
    if (failed) return self->close();
    self->is_open_ = true;
    ++self->counts_.viewers;
    self->queueText(ordered_json{{"op", "serverInfo"},
                                 {"name", "HaptiCell"},
                                 {"capabilities", ordered_json::array()},
                                 {"metadata", ordered_json::object()}}
                        .dump());
    ordered_json channels = ordered_json::array();
    for (const ViewerBoard::Topic& topic : self->board_.topics) channels.push_back(jsonOf(topic));
    self->queueText(ordered_json{{"op", "advertise"}, {"channels", channels}}.dump());
    self->read();
  });
}

void ViewerSession::advertise(const ViewerBoard::Topic& topic) {
  if (is_open_) queueText(ordered_json{{"op", "advertise"}, {"channels", ordered_json::array({jsonOf(topic)})}}.dump());
}

void ViewerSession::read() {
  buffer_.clear();
  socket_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t) {
    if (failed) return self->close();
    if (self->socket_.got_text()) self->hear(beast::buffers_to_string(self->buffer_.data()));
    self->read();
  });
}

void ViewerSession::hear(const std::string& text) {
  if (!geometry::checkNesting(text, geometry::NestedText::kJson, "viewer")) return close();
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("op") || !json["op"].is_string()) return close();
  const auto listed = [&](const char* name) { return json.contains(name) && json[name].is_array() ? json[name] : nlohmann::json::array(); };
  if (json["op"] == "subscribe") {
    for (const auto& wish : listed("subscriptions")) {
      if (!wish.is_object() || !wish.contains("id") || !wish.contains("channelId")) continue;
      if (!wish["id"].is_number_unsigned() || !wish["channelId"].is_number_unsigned()) continue;
      subscribe(wish["id"].get<std::uint32_t>(), wish["channelId"].get<std::uint32_t>());
    }
  } else if (json["op"] == "unsubscribe") {
    for (const auto& id : listed("subscriptionIds")) {
      if (!id.is_number_unsigned()) continue;
      const auto subscription = id.get<std::uint32_t>();
      std::erase_if(subscriptions_, [&](const auto& entry) { return entry.second == subscription; });
      std::erase_if(queue_, [&](const Outgoing& waits) { return waits.message.bytes && waits.subscription == subscription; });
    }
  }
}

void ViewerSession::subscribe(std::uint32_t subscription, std::uint32_t topic) {
  const auto known = std::ranges::find(board_.topics, topic, &ViewerBoard::Topic::id);
  const bool is_taken = std::ranges::any_of(subscriptions_, [&](const auto& entry) { return entry.second == subscription; });
  if (known == board_.topics.end() || is_taken || subscriptions_.contains(topic) ||
      subscriptions_.size() >= kMostSubscriptions) {
    queueText(ordered_json{{"op", "status"}, {"level", 2}, {"message", "This subscription is refused: no such channel, or subscribed already."}}.dump());
    return;
  }
  subscriptions_[topic] = subscription;
  for (const ViewerMessage& message : known->kept) send(message);
}

void ViewerSession::send(const ViewerMessage& message) {
  const auto subscription = subscriptions_.find(message.topic);
  if (!is_open_ || is_closed_ || subscription == subscriptions_.end()) return;
  const auto older = std::ranges::find_if(queue_, [&](const Outgoing& waits) {
    return waits.message.bytes && waits.message.topic == message.topic && waits.message.key == message.key;
  });
  if (older != queue_.end()) {
    queue_.erase(older);
    ++counts_.dropped;
  }
  queue({{}, subscription->second, message});
}

void ViewerSession::queueText(std::string text) {
  queue({std::move(text), 0, {}});
}

void ViewerSession::queue(Outgoing outgoing) {
  queue_.push_back(std::move(outgoing));
  writeNext();
}

void ViewerSession::writeNext() {
  if (is_writing_ || is_closed_ || queue_.empty()) return;
  is_writing_ = true;
  const Outgoing next = std::move(queue_.front());
  queue_.pop_front();
  socket_.text(!next.message.bytes);
  if (next.message.bytes) {
    frame_.assign(1, '\x01');  // Message data.
    appendRaw(frame_, next.subscription);
    appendRaw(frame_, next.message.stamp_ns);
    frame_ += *next.message.bytes;
    ++counts_.sent;
  } else {
    frame_ = next.text;
  }
  socket_.async_write(asio::buffer(frame_), [self = shared_from_this()](error_code failed, std::size_t) {
    self->is_writing_ = false;
    if (failed) return self->close();
    self->writeNext();
  });
}

}  // namespace hapticell::bridge
