// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/cell_feed.h"

#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/shapes/shapes.h"

namespace hapticell::bridge {
namespace {

/// A viewer of Foxglove's protocol: one blocking connection that subscribes to two topics.
class Viewer {
 public:
  explicit Viewer(std::uint16_t port) : stream_(io_) {
    stream_.next_layer().connect({boost::asio::ip::address_v4::loopback(), port});
    stream_.set_option(
        boost::beast::websocket::stream_base::decorator([](boost::beast::websocket::request_type& request) {
          request.set(boost::beast::http::field::sec_websocket_protocol, "foxglove.websocket.v1");
        }));
    stream_.handshake("127.0.0.1", "/");
    while (!channels_.contains("/scene") || !channels_.contains("/tf")) {
      const auto said = nlohmann::json::parse(next());
      if (said["op"] != "advertise") continue;
      for (const auto& channel : said["channels"]) channels_[channel["topic"]] = channel["id"];
    }
    const nlohmann::json subscribe{
        {"op", "subscribe"},
        {"subscriptions",
         {{{"id", 1}, {"channelId", channels_["/scene"]}}, {{"id", 2}, {"channelId", channels_["/tf"]}}}}};
    stream_.write(boost::asio::buffer(subscribe.dump()));
  }

  /// The next message of a subscription: its number and what follows its stamp.
  std::pair<std::uint32_t, std::string> receive() {
    for (;;) {
      const std::string bytes = next();
      if (!stream_.got_binary() || bytes.size() < 13 || bytes[0] != 1) continue;
      std::uint32_t id = 0;
      std::memcpy(&id, bytes.data() + 1, 4);
      return {id, bytes.substr(13)};
    }
  }
  /// The next message of /scene.
  nlohmann::json scene() {
    for (;;) {
      const auto [id, text] = receive();
      if (id == 1) return nlohmann::json::parse(text);
    }
  }

 private:
  std::string next() {
    boost::beast::flat_buffer buffer;
    stream_.read(buffer);
    return boost::beast::buffers_to_string(buffer.data());
  }
  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::asio::ip::tcp::socket> stream_;
  std::map<std::string, std::uint32_t> channels_;
};

workcell::DocumentState cellOf(const std::string& name, workcell::EntityId id, double height) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = name;
  entity.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(dvec3(0.1)))};
  entity.X_WE = Pose::translation({0.0, 0.0, height});
  workcell::DocumentState state;
  state.entities = {std::make_shared<const workcell::Entity>(entity)};
  return state;
}

/// A double as CDR has it on this machine.
std::string bytesOf(double value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

TEST(CellFeed, ShowsTheNewestCellAndWhatMovesInIt) {
  const auto server = ViewerServer::listen({"127.0.0.1", 0, ""});
  ASSERT_TRUE(server);
  CellFeed feed(**server);
  feed.showCell(cellOf("crate", 4, 0.5));
  Viewer viewer((*server)->port());
  auto shown = viewer.scene();
  ASSERT_EQ(shown["entities"].size(), 1u);
  EXPECT_EQ(shown["entities"][0]["id"], "crate");
  EXPECT_EQ(shown["entities"][0]["frame_id"], "crate");

  manipulation::SceneSnapshot moved;
  moved.entities.push_back({.id = 4, .X_WE = Pose::translation({0.0, 0.0, 1.2345}), .joints = {}});
  feed.update(moved);
  for (;;) {
    const auto [id, text] = viewer.receive();
    if (id != 2 || text.find("crate") == std::string::npos) continue;
    if (text.find(bytesOf(1.2345)) != std::string::npos) break;
    EXPECT_NE(text.find(bytesOf(0.5)), std::string::npos) << "before it moved it is where the cell has it";
  }

  // Cells that came while one was written are passed over but for the last.
  for (int k = 0; k < 50; ++k) feed.showCell(cellOf("pallet " + std::to_string(k), 5, 0.0));
  bool is_crate_gone = false, is_last_shown = false;
  int pallets = 0;
  while (!is_crate_gone || !is_last_shown) {
    const auto message = viewer.scene();
    for (const auto& deletion : message["deletions"]) is_crate_gone = is_crate_gone || deletion["id"] == "crate";
    for (const auto& entity : message["entities"]) {
      EXPECT_EQ(entity["id"].get<std::string>().substr(0, 6), "pallet") << "the crate is not shown again";
      EXPECT_FALSE(is_last_shown) << "nothing after the newest";
      ++pallets;
      is_last_shown = entity["id"] == "pallet 49";
    }
  }
  EXPECT_LE(pallets, 50) << "none twice";
}

}  // namespace
}  // namespace hapticell::bridge
