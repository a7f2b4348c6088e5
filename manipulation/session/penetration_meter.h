// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"

namespace hapticell::manipulation {

/// Measures how deep the shown entity penetrates others, by its own exact distance queries, which share only the meshes
/// with the engine. Between two measurements it keeps a list of what is near, by the parts' spheres: the cost is that of
/// what is near.
class PenetrationMeter {
 public:
  /// Present depth of the held entity, m: 0 if it is free; else an upper bound (the shortest translation found that
  /// frees it).
  double measure(const ManipulationEngine& engine);
  double worst() const { return worst_; }
  /// For pairs that must not pass through each other.
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
  std::vector<std::uint32_t> near_;  ///< Pairs that may touch before the list is rebuilt.
  double worst_ = 0.0, worst_blocked_ = 0.0, last_ = 0.0;
  workcell::EntityId measured_id_ = 0;
  EntityConfiguration measured_;
};

}  // namespace hapticell::manipulation
