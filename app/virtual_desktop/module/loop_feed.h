// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/shapes/pose.h"
#include "manipulation/engine/scene_snapshot.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class VirtualDesktopController;

/// Passes the document and the view to the loop as commands, and recognises results for a closed cell. Does nothing
/// without a loop. GUI thread.
class LoopFeed {
 public:
  /// The owner must outlive it.
  explicit LoopFeed(VirtualDesktopController& owner) : owner_(owner) {}

  void postDocument() const;
  void postGuides() const;
  void postCamera() const;
  Pose cameraPose_W() const;
  /// Orientation of the device's axes in the cell, as in the settings.
  dquat axes_W() const;
  /// Another document is about to be opened.
  void closeCell();
  /// False if the loop still used an earlier cell.
  bool isOfCell(const manipulation::SceneSnapshot& snapshot) const;

 private:
  VirtualDesktopController& owner_;
  workcell::EntityId closed_ids_ = 0;  // Ids up to this one belong to closed cells.
};

}  // namespace hapticell::app
