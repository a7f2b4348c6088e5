// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/ergonomics/scores/work_task.h"
#include "mannequin/posture/posture.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// What of a workplace may be moved, and what is done there.
struct WorkplaceQuestion {
  std::vector<workcell::Entity> entities;  ///< The cell.
  workcell::EntityId mannequin = 0;        ///< Who shows the task: the active hands' places are the targets.
  std::vector<workcell::EntityId>
      station;  ///< What goes up, down, to and fro with the targets: a table and what is on it.
  ergonomics::WorkTask task;
  double rise_from = -0.20, rise_to = 0.20, rise_step = 0.04;  ///< m
  double away_from = -0.12, away_to = 0.20, away_step = 0.04;  ///< m, along where the mannequin faces.
  bool may_stand = true, may_sit = false;
};

/// One placement of the station.
struct WorkplaceCell {
  double rise = 0.0, away = 0.0;  ///< m
  bool is_seated = false;
  int worst = 0;              ///< Highest RULA of the four bodies; 0: one of them cannot do it.
  std::array<int, 4> rula{};  ///< P5F, P50F, P50M, P95M; 0 where that body cannot.
  std::string why{};          ///< Where it cannot: "P95M would touch Bench", "P5F is 42 mm short".
  std::vector<mannequin::Posture> postures{};  ///< Of the four bodies; empty where one of them cannot.
};

struct WorkplaceMap {
  std::vector<double> rises, aways;
  std::vector<WorkplaceCell> cells;  ///< By stance, then rise, then away.
  int best = -1;                     ///< Least worst RULA, then least sum, then nearest to now; -1: nowhere.
  bool is_complete = true;           ///< False: cancelled.
};

/// The station with what is attached to its parts, directly or through others: all that the placements move, in the
/// order of `entities`. Never the mannequin, nor what it carries.
std::vector<workcell::EntityId> movedWith(const WorkplaceQuestion& question);

/// Tries every placement with the four boundary figures: each is solved with all limits, feet and balance, must reach
/// and must not enter anything of the cell with its body (hands and what they hold aside), and is scored by RULA with
/// the task. Runs on all cores; `progress` (0 to 1) is called from any of them, and `cancel` ends it soon. Errors: no
/// such mannequin or station, an empty or huge (over 10 000) grid.
Expected<WorkplaceMap> searchWorkplace(const WorkplaceQuestion& question, const std::function<void(double)>& progress,
                                       const std::atomic<bool>& cancel);

}  // namespace hapticell::manipulation
