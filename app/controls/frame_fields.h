// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "workcell/document/document_state.h"

class QComboBox;

namespace hapticell::app {

class Host;

/// Something that a frame can be fixed to.
struct FrameCarrier {
  QString name;               ///< "fixture", "robot · link_3".
  workcell::EntityId to = 0;  ///< 0: the world.
  std::string link = {};      ///< A robot's link; else empty.
  bool operator==(const FrameCarrier&) const = default;
};

/// The world, then all that the frame may be fixed to: solids, other frames, and robots link by link. Without the frame
/// and what is attached to it.
std::vector<FrameCarrier> frameCarriers(const workcell::DocumentState& state, workcell::EntityId frame);

/// What a frame of the cell goes with, to be chosen: the world, an entity, or a link of a robot. It keeps its place
/// when that is changed. Hidden for all else. Each choice is one step of undo. GUI thread.
class FrameFields : public QWidget {
  Q_OBJECT
 public:
  explicit FrameFields(Host& host, QWidget* parent = nullptr);
  /// Takes the newest of the chosen entity.
  void showFrame(const workcell::Entity& entity);

 private:
  void choose(int index);
  Host& host_;
  workcell::EntityId id_ = 0;
  QComboBox* carrier_;
  std::vector<FrameCarrier> carriers_;
  int now_ = 0;  ///< The one that it is fixed to.
};

}  // namespace hapticell::app
