// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "manipulation/engine/grasp_keeper.h"
#include "mannequin/motion/glove_mapping.h"
#include "workcell/document/document.h"

namespace hapticell::app {

/// What a glove poses: a hand of a mannequin, or a free hand.
struct GlovedHand {
  workcell::EntityId entity = 0;  ///< 0: there is nothing to pose.
  mannequin::Side side = mannequin::Side::kRight;
  std::vector<double> joints;                     ///< Of all variables: the fingers' as the glove has them.
  std::vector<std::vector<std::size_t>> fingers;  ///< Variables that move together, from the palm outwards.
  manipulation::GraspKeeper::Bend bend{};         ///< As the glove has it, rad.
};

/// The hand that the glove of that side poses: of the chosen entity where that is a mannequin or a free hand, else a
/// free hand of that side, else of the first mannequin; what is locked is left alone. Fingers stand within its limits.
GlovedHand glovedHand(const workcell::Document& document, workcell::EntityId chosen, mannequin::Side side,
                      const mannequin::GloveReadings& angles);

}  // namespace hapticell::app
