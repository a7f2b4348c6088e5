// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "manipulation/engine/manipulation_engine.h"
#include "tests/manipulation/session/hand_link.h"

namespace hapticell::manipulation::test {

/// An engine whose stylus stands where the test puts it, with axes as the cell's; 2 ms a step.
struct MovedByHand {
  /// Takes `entity` with the hand at the origin of the device.
  MovedByHand(std::vector<workcell::Entity> entities, workcell::EntityId entity, workcell::PairPolicy pairs = {}) {
    engine.apply(command::SetAxes{{AxesMode::kCell, {}}});
    engine.apply(command::SetDocument{std::move(entities), std::move(pairs)});
    engine.apply(command::Grab{entity});
    moveTo({0, 0, 0});
  }
  void moveTo(const dvec3& p_D) {
    link.state.X_DS.p = link.state.X_DP.p = p_D;
    now += 2'000'000;
    engine.step(now);
  }
  double time() const { return 1e-9 * static_cast<double>(now); }

  HandLink link;
  ManipulationEngine engine{link, {}};
  std::int64_t now = 0;
};

}  // namespace hapticell::manipulation::test
