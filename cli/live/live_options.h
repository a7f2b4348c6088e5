// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "bridge/foxglove/cell_view.h"
#include "bridge/foxglove/viewer_server.h"
#include "geometry/system/error.h"
#include "manipulation/session/session.h"

namespace hapticell::cli {

/// Where viewers connect.
struct LiveOptions {
  std::string listen = "127.0.0.1";  ///< Another address than this machine's gets a code.
  int port = 8765;
};

/// A cell that viewers watch while a command runs. The address for viewers goes to standard error.
class LiveView {
 public:
  /// Errors: as ViewerServer::listen().
  static Expected<LiveView> open(const LiveOptions& options);
  /// Shows these shapes, at once.
  void show(const workcell::DocumentState& cell);
  void show(const manipulation::SessionOptions& session);
  void update(const manipulation::SceneSnapshot& picture);
  bridge::ViewerServer& server() { return *server_; }
  /// "ws://127.0.0.1:8765"
  const std::string& address() const { return address_; }

 private:
  LiveView() = default;
  std::unique_ptr<bridge::ViewerServer> server_;
  std::unique_ptr<bridge::CellView> view_;
  std::string address_;
};

}  // namespace hapticell::cli
