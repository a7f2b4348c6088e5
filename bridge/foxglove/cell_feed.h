// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "bridge/foxglove/cell_view.h"

namespace hapticell::bridge {

/// A CellView with a thread of its own, for a caller that must not wait while shapes are written. The newest cell and
/// the newest picture win; none is sent twice.
class CellFeed {
 public:
  /// @pre the server lives longer
  explicit CellFeed(ViewerServer& server);
  ~CellFeed();
  CellFeed(const CellFeed&) = delete;
  CellFeed& operator=(const CellFeed&) = delete;

  // Any thread; never waits for a viewer.
  void showCell(const workcell::DocumentState& cell);
  void update(const manipulation::SceneSnapshot& now);

 private:
  void run();

  CellView view_;
  std::mutex mutex_;  // Guards what follows.
  std::condition_variable came_;
  std::optional<workcell::DocumentState> cell_;
  std::optional<manipulation::SceneSnapshot> picture_;
  bool is_ending_ = false;
  std::thread thread_;  // The last: it uses all above.
};

}  // namespace hapticell::bridge
