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

/// How close the entered loads are to the next heavier class of a method.
struct ForceLimit {
  std::string_view method;          ///< "RULA", "REBA", "OWAS", "own" (the user's table).
  int hand = -1;                    ///< 0 left, 1 right, -1 both together.
  double force_n = 0.0;             ///< The weight of the load that was entered.
  std::optional<double> limit_n{};  ///< Where the next class begins, empty in the heaviest; of "own" the limit.
  int band = 0;                     ///< 0 to 3, of its class.
  std::optional<double>
      lower_n{};  ///< Below this (own limits: up to this) the next lower class begins; empty in the lowest.
};

/// The loads on the hands in a static posture.
struct HandForces {
  std::array<std::optional<double>, 2> force_n;     ///< Weight in the left and right hand; empty where not entered.
  std::array<double, 2> elbow_nm{}, shoulder_nm{};  ///< Moments there, the arm's own weight included.
  double lumbar_nm = 0.0;  ///< About L5/S1 (the lowest joint of the spine), all above it and both loads.
  std::vector<ForceLimit> limits;
  /// Missing inputs: "load_left", "load_right", "force_limits" (no table, or no row that applies here). If not empty,
  /// the result is partial.
  std::vector<std::string_view> missing;
};

/// From the loads of the task and the user's own limits: no table of human strength is shipped, because none with a
/// suitable licence was found. Classes are those of the methods (RULA 2 and 10 kg per hand, REBA 5 and 10, OWAS 10 and
/// 20 kg together); moments are static, with the masses of de Leva. A load that was not entered counts as 0 in the
/// moments, has no limit and is named in `missing`. Own limits are divided into bands at 50 %, 70 % and 100 % (our
/// choice).
HandForces handForces(const mannequin::Figure& figure, const mannequin::FigurePose& pose, const WorkTask& task,
                      const ForceTable& own = {});

}  // namespace hapticell::ergonomics
