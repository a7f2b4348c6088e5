// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "bridge/foxglove/viewer_server.h"
#include "manipulation/engine/scene_snapshot.h"
#include "workcell/document/document_state.h"

namespace hapticell::bridge {

/// Shows a cell to viewers: its shapes once, and what moves in it as often as update() is called.
///
/// Topics: `/scene` (shapes, foxglove.SceneUpdate with a glTF model an entity or link), `/tf` (frames: an entity's has
/// its name, a link's "ENTITY/LINK"), `/joint_states`, `/stylus/pose` and `/stylus/wrench`, `/force` (N, and the number
/// of contacts), `/contacts` (the pairs near each other), `/contact_points` (to be drawn), `/log` (the state of what is
/// held, in words). Everything is in the frame "world", metres and newtons. One thread.
class CellView {
 public:
  /// @pre the server lives longer
  explicit CellView(ViewerServer& server);

  /// Sends the shapes of what can be seen; called again, only those that changed since.
  void showCell(const workcell::DocumentState& cell, std::int64_t stamp_ns);
  /// Sends what moved since the last call, and, once a second, everything. Entities of `now` that the cell does not have
  /// are left out.
  void update(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns);

 private:
  struct Shown {
    std::shared_ptr<const workcell::Entity> entity;
    Pose X_WE;
    std::vector<double> joints;
    bool has_changed = true;
  };

  void showShapes(const workcell::Entity& entity, std::int64_t stamp_ns);
  void hideShapes(const workcell::Entity& entity, std::int64_t stamp_ns);
  void place(const manipulation::SceneSnapshot& now);
  void sendFrames(std::int64_t stamp_ns);
  void sendJoints(std::int64_t stamp_ns);
  void sendStylus(const manipulation::StylusState& stylus, std::int64_t stamp_ns);
  void sendContacts(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns);
  void sendWords(const manipulation::SceneSnapshot& now, std::int64_t stamp_ns);

  ViewerServer& server_;
  std::uint32_t scene_, frames_, joints_, stylus_, wrench_, force_, contacts_, points_, log_;
  std::unordered_map<workcell::EntityId, Shown> shown_;
  std::vector<workcell::EntityId> order_;  // That of the document.
  std::int64_t all_sent_ns_ = 0;
  std::string last_words_;
};

/// Nanoseconds since 1970, for the stamps of messages.
std::int64_t nowForViewers();

}  // namespace hapticell::bridge
