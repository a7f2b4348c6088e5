// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// Measures how deep the shown entity is in anything, by exact distance queries of its own that share nothing with the
/// engine but the meshes. Between two measurements a list of what is near, by the parts' spheres, is kept: the cost is
/// that of what is near.
class PenetrationMeter {
 public:
  /// Depth of the held entity now, m: 0 when it is free; else an upper bound (the shortest translation found that frees
  /// it).
  double measure(const ManipulationEngine& engine);
  double worst() const { return worst_; }
  /// Of pairs that must not pass through each other.
  double worstBlocked() const { return worst_blocked_; }

 private:
  /// A part of the cell: where it is, and where it was when the list was made.
  struct Body {
    const ScenePart* part = nullptr;
    bool may_move = false;  ///< Belongs to what is held.
    Pose X_W, X_WListed;
  };
  /// A pair of the held entity: indices into bodies_.
  struct Watched {
    std::uint32_t moved = 0, other = 0;
  };
  void gather(const ManipulationEngine& engine);
  double place(const ManipulationEngine& engine);
  void listNear();

  const HeldEntity* gathered_of_ = nullptr;
  const PreparedScene* scene_ = nullptr;
  std::vector<Body> bodies_;
  std::vector<Watched> watched_;     ///< Of each pair of the held entity.
  std::vector<std::uint32_t> near_;  ///< Pairs that may touch before the list is made anew.
  double worst_ = 0.0, worst_blocked_ = 0.0, last_ = 0.0;
  workcell::EntityId measured_id_ = 0;
  EntityConfiguration measured_;
};

}  // namespace hapticell::manipulation
