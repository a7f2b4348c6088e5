// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/engine/grasp_keeper.h"
#include "mannequin/motion/glove_mapping.h"
#include "workcell/document/document.h"

namespace hapticell::app {

/// What a glove controls: a hand of a mannequin, or a free hand.
struct GlovedHand {
  workcell::EntityId entity = 0;  ///< 0: there is no hand.
  mannequin::Side side = mannequin::Side::kRight;
  std::vector<double> joints;                     ///< Of all variables: those of the fingers as measured by the glove.
  std::vector<std::vector<std::size_t>> fingers;  ///< Variables that move together, from the palm outwards.
  manipulation::GraspKeeper::Bend bend{};         ///< As measured by the glove, rad.
};

/// The hand that the glove of that side controls: of the chosen entity if that is a mannequin or a free hand, else a
/// free hand of that side, else of the first mannequin. Locked entities are skipped. Fingers stay within their limits.
GlovedHand glovedHand(const workcell::Document& document, workcell::EntityId chosen, mannequin::Side side,
                      const mannequin::GloveReadings& angles);

}  // namespace hapticell::app
