// SPDX-License-Identifier: Apache-2.0
#include "bridge/foxglove/cell_feed.h"

namespace hapticell::bridge {

CellFeed::CellFeed(ViewerServer& server) : view_(server), thread_([this] { run(); }) {}

CellFeed::~CellFeed() {
  {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
  }
  came_.notify_one();
  thread_.join();
}

void CellFeed::showCell(const workcell::DocumentState& cell) {
  {
    const std::scoped_lock lock(mutex_);
    cell_ = cell;
  }
  came_.notify_one();
}

void CellFeed::update(const manipulation::SceneSnapshot& now) {
  {
    const std::scoped_lock lock(mutex_);
    picture_ = now;
  }
  came_.notify_one();
}

void CellFeed::run() {
  while (true) {
    std::optional<workcell::DocumentState> cell;
    std::optional<manipulation::SceneSnapshot> picture;
    {
      std::unique_lock lock(mutex_);
      came_.wait(lock, [this] { return is_ending_ || cell_ || picture_; });
      if (is_ending_) return;
      cell.swap(cell_);
      picture.swap(picture_);
    }
    if (cell) view_.showCell(*cell, nowForViewers());
    if (picture) view_.update(*picture, nowForViewers());
  }
}

}  // namespace hapticell::bridge
