// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/shapes/pose.h"
#include "manipulation/engine/scene_snapshot.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class VirtualDesktopController;

/// Hands the document and the view over to the loop as commands, and knows which answers are of a cell that is closed.
/// Without a loop nothing happens. GUI thread.
class LoopFeed {
 public:
  /// The owner must outlive it.
  explicit LoopFeed(VirtualDesktopController& owner) : owner_(owner) {}

  void postDocument() const;
  void postGuides() const;
  void postCamera() const;
  Pose cameraPose_W() const;
  /// Where the device's axes lie in the cell, as the settings have it.
  dquat axes_W() const;
  /// The document is about to be another one.
  void closeCell();
  /// False where the loop was still at a cell before.
  bool isOfCell(const manipulation::SceneSnapshot& snapshot) const;

 private:
  VirtualDesktopController& owner_;
  workcell::EntityId closed_ids_ = 0;  // Those up to it are of cells that are closed.
};

}  // namespace hapticell::app
