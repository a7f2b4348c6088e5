// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/holding/held_model.h"
#include "manipulation/holding/held_pairs.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::manipulation {

/// The data that the parts of a HeldEntity share: what moves, how, its configuration and its pairs.
struct HeldState {
  /// m: least boundary of a pair, an encoder step, so that the exact check has room: 4 kStandOff. Half: blocked motions
  /// stick; twice: a fit of 0.05 mm keeps 0.01 mm a side.
  static constexpr double kSkin = 20e-6;

  HeldModel model;
  std::unique_ptr<const Manipulator> manipulator;
  EntityConfiguration accepted;  ///< The last free configuration, also that of `motion`.
  HeldPairs pairs;
  FreeMotion motion;
  std::vector<Text> notes;  ///< Notes from the taking.
  std::optional<mannequin::Side> hand = {};  ///< Of a mannequin: the one hand that moves it.

  Pose movedFrame() const { return manipulator->movedFrame(accepted); }
  void moveObstacle(std::size_t obstacle, const Pose& X_W) {
    pairs.moveObstacle(obstacle, X_W);
    motion.moveObstacle(static_cast<std::uint32_t>(obstacle), X_W);
  }
};

}  // namespace hapticell::manipulation
