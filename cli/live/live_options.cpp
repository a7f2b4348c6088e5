// SPDX-License-Identifier: Apache-2.0
#include "cli/live/live_options.h"

#include "cli/kit/result_writer.h"
#include "haptic/transport/pairing_key.h"

namespace hapticell::cli {

Expected<LiveView> LiveView::open(const LiveOptions& options) {
  bridge::ViewerAddress address{options.listen, static_cast<std::uint16_t>(options.port), {}};
  if (!bridge::isThisMachine(options.listen)) {
    const auto key = haptic::PairingKey::make();
    HAPTICELL_TRY(key);
    address.code = key->code();
  }
  auto server = bridge::ViewerServer::listen(address);
  HAPTICELL_TRY(server);
  LiveView live;
  live.server_ = std::move(*server);
  live.view_ = std::make_unique<bridge::CellView>(*live.server_);
  const bool is_v6 = options.listen.find(':') != std::string::npos;
  live.address_ = "ws://" + (is_v6 ? "[" + options.listen + "]" : options.listen) + ":" + std::to_string(live.server_->port());
  if (!address.code.empty()) live.address_ += "/" + address.code;
  warn(Text("open %1 in Foxglove or Lichtblick ('Foxglove WebSocket')", live.address_));
  if (!address.code.empty())
    warn("the connection is not encrypted: whoever can listen to this network can watch");
  return live;
}

void LiveView::show(const workcell::DocumentState& cell) {
  view_->showCell(cell, bridge::nowForViewers());
}

void LiveView::show(const manipulation::SessionOptions& session) {
  workcell::DocumentState cell;
  for (const workcell::Entity& entity : session.entities)
    cell.entities.push_back(std::make_shared<const workcell::Entity>(entity));
  show(cell);
}

void LiveView::update(const manipulation::SceneSnapshot& picture) {
  view_->update(picture, bridge::nowForViewers());
}

}  // namespace hapticell::cli
