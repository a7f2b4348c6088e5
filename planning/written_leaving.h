// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "planning/written_plan.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning {

/// Of a motion, judged by LeavingRule.
struct Leaving {
  std::vector<TightPair> tight{};
  double least = 0.0, t_least = 0.0;      ///< Least gap (m, up to the look) of all that is not being left or reached.
  double deepest = 0.0, closing = 0.0;    ///< m; see checkWrittenPlan().
  Text where_deepest{}, where_closing{};  ///< The pairs.
  std::vector<std::string> still{};       ///< Parts of a mannequin that stay where they are ("worker/l_hindfoot").
};

struct LeavingLook {
  double clearance = 0.0;  ///< m
  double look = 0.05;      ///< m: larger gaps are not measured.
  bool with_axes = false;  ///< `fine` has the joints of the robot's external axes too (motionOfAll()).
};

/// Measures the gaps of all pairs of a robot's (columns: its joints), a mannequin's or a solid's parts with the cell at
/// all frames. What of a mannequin does not move by a millimetre on the whole motion (its feet) is left out.
/// Shares the rule's numbers with the code that plans, and nothing else. Errors: those of JointCheck and HeldEntity.
Expected<Leaving> measuredLeaving(const trajectory::Trajectory& fine, const std::vector<std::size_t>& columns,
                                  const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                  const workcell::Entity& entity, const LeavingLook& look,
                                  const config::Configuration& configuration);

}  // namespace hapticell::planning
