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
  std::string link = {};      ///< The link, if fixed to a robot; else empty.
  bool operator==(const FrameCarrier&) const = default;
};

/// The world, then everything that `frame` can be fixed to: solids, other frames, and robots link by link. `frame`
/// itself and what is attached to it are left out.
std::vector<FrameCarrier> frameCarriers(const workcell::DocumentState& state, workcell::EntityId frame);

/// Field for what a frame of the cell is fixed to: the world, an entity, or a link of a robot. The frame keeps its pose
/// when this changes. Hidden for other entities. Each choice is one undo step. GUI thread.
class FrameFields : public QWidget {
  Q_OBJECT
 public:
  explicit FrameFields(Host& host, QWidget* parent = nullptr);
  /// Shows the present state of the chosen entity.
  void showFrame(const workcell::Entity& entity);

 private:
  void choose(int index);
  Host& host_;
  workcell::EntityId id_ = 0;
  QComboBox* carrier_;
  std::vector<FrameCarrier> carriers_;
  int now_ = 0;  ///< Index of what the frame is fixed to.
};

}  // namespace hapticell::app
