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
class SceneService;
}

namespace hapticell::studies {

/// What may be moved in a workplace, and the task done there.
struct WorkplaceQuestion {
  std::vector<workcell::Entity> entities;  ///< The cell; names are unique.
  workcell::EntityId mannequin = 0;        ///< Shows the task: the poses of its active hands are the targets.
  std::vector<workcell::EntityId>
      station;  ///< Moves with the targets, vertically and horizontally: a table and what is on it.
  ergonomics::WorkTask task;
  double rise_from = -0.20, rise_to = 0.20, rise_step = 0.04;  ///< m
  double away_from = -0.12, away_to = 0.20, away_step = 0.04;  ///< m, in the direction that the mannequin faces.
  bool may_stand = true, may_sit = false;
};

/// One placement of the station.
struct WorkplaceCell {
  double rise = 0.0, away = 0.0;  ///< m
  bool is_seated = false;
  int worst = 0;              ///< Highest RULA of the four bodies; 0: one of them cannot do the task.
  std::array<int, 4> rula{};  ///< P5F, P50F, P50M, P95M; 0 from the first body on that cannot do the task.
  std::string why{};          ///< Why one cannot: "P95M would touch Bench", "P5F is 42 mm short".
  std::vector<mannequin::Posture> postures{};  ///< Of the four bodies; empty if one of them cannot do the task.
};

struct WorkplaceMap {
  std::vector<double> rises, aways;
  std::vector<WorkplaceCell> cells;  ///< By stance, then rise, then away.
  int best = -1;                     ///< Index of the best cell: least worst RULA, then least sum, then nearest to the
                                     ///< present placement; -1: no placement works.
  bool is_complete = true;           ///< False: cancelled.
};

/// The station and everything attached to its parts or below them in the tree, directly or through others: all that the
/// placements move, in the order of `entities`. Never the mannequin or what it carries.
std::vector<workcell::EntityId> movedWith(const WorkplaceQuestion& question);

/// The search as a study (*.hstudy) of the cell file `cell`, as its text names it; it says of the four bodies together
/// what the map says of each. Hidden parts count in it if they are in the cell. Errors: those of searchWorkplace().
Expected<std::string> workplaceStudy(const WorkplaceQuestion& question, const std::string& cell);

/// Tries every placement with the four boundary bodies, as a study in memory: each is solved with all limits, feet and
/// balance. Each must reach, and its body (except the hands and what they hold) must not penetrate anything visible in
/// the cell. RULA scores it with the task. Runs on all cores; `scenes` prepares the cell; `progress` (0 to 1) is called
/// from any of the threads, one at a time; `cancel` ends the search early. Errors: no such mannequin or station, an
/// empty or huge (over 10 000) grid.
Expected<WorkplaceMap> searchWorkplace(const WorkplaceQuestion& question, manipulation::SceneService& scenes,
                                       const std::function<void(double)>& progress, const std::atomic<bool>& cancel);

}  // namespace hapticell::studies
