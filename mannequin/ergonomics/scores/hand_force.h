// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/scores/force_table.h"
#include "mannequin/ergonomics/scores/work_task.h"
#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::ergonomics {

/// How near the loads that were entered are to where a method counts them as heavier.
struct ForceLimit {
  std::string_view method;          ///< "RULA", "REBA", "OWAS", "own" (the user's table).
  int hand = -1;                    ///< 0 left, 1 right, -1 both together.
  double force_n = 0.0;             ///< The weight of the load that was entered.
  std::optional<double> limit_n{};  ///< Where the next class begins, empty in the heaviest; of "own" the limit.
  int band = 0;                     ///< 0 to 3, of the class that it is in.
  std::optional<double>
      lower_n{};  ///< Under this (own limits: up to this) the next lower class begins; empty in the lowest.
};

/// What the hands bear in a posture that is held still.
struct HandForces {
  std::array<std::optional<double>, 2> force_n;     ///< Weight in the left and right hand; empty where not entered.
  std::array<double, 2> elbow_nm{}, shoulder_nm{};  ///< Moments there, the arm's own weight included.
  double lumbar_nm = 0.0;  ///< About L5/S1 (the lowest joint of the spine), all above it and both loads.
  std::vector<ForceLimit> limits;
  /// What was not entered and is needed: "load_left", "load_right", "force_limits" (no table, or none that holds here).
  /// Not empty: the result is partial.
  std::vector<std::string_view> missing;
};

/// From the task's loads and the user's own limits: no table of human strength is shipped, since none with a licence
/// was at hand. Classes are the methods' own (RULA 2 and 10 kg a hand, REBA 5 and 10, OWAS 10 and 20 kg together);
/// moments are those of a body at rest with de Leva's masses. A load that was not entered counts as none in the
/// moments, has no limit and is named in `missing`. Of the own limits the half, 70 % and the whole part the bands (our
/// choice).
HandForces handForces(const mannequin::Figure& figure, const mannequin::FigurePose& pose, const WorkTask& task,
                      const ForceTable& own = {});

}  // namespace hapticell::ergonomics
