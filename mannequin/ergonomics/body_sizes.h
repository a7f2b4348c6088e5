// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/ergonomics/posture_scores.h"
#include "mannequin/posture_solver.h"

namespace hapticell::ergonomics {

/// One body at the place and at the targets of another.
struct BodyAtTask {
  std::string name;  ///< "P5F" ...
  mannequin::Figure figure;
  mannequin::Posture posture;
  bool is_reached = false;
  double short_m = 0.0;       ///< What the worse hand lacks.
  double reach_left_m = 0.0;  ///< What the arm's length has left, of the arm that has less.
  PostureScores scores;
};

/// Which hands do something: raised, or bent; where neither is, the right one.
std::array<bool, 2> activeHands(const mannequin::FigurePose& pose, const mannequin::Posture& posture);

/// The same work done by other bodies: their feet where `posture`'s stand, their grips where its active hands' grips
/// are (turned alike), all limits and balance kept; the body that is of the figure's own sex and stature as it stands.
/// Well under a millisecond a body; any thread.
std::vector<BodyAtTask> atSameTask(const std::vector<mannequin::NamedFigure>& bodies, const mannequin::Figure& figure,
                                   const mannequin::Posture& posture, const WorkTask& task);

/// RULA of each body with the targets moved up by each of `rises` (m); 0 where the body does not reach them there.
std::vector<std::vector<int>> scoresByHeight(const std::vector<mannequin::NamedFigure>& bodies,
                                             const mannequin::Figure& figure, const mannequin::Posture& posture,
                                             const WorkTask& task, const std::vector<double>& rises);

/// How the work would have to be moved for a lower action level.
struct BetterPlace {
  dvec3 shift_W{0.0};  ///< m, of all active hands' targets.
  int score = 0;       ///< RULA there.
  mannequin::Posture posture;
};

/// The smallest shift of the targets (down, up, nearer, further, to a side; up to 0.6 m in steps of 10 mm) with which
/// the figure's RULA falls to a lower level; nothing where none does. Some tens of milliseconds: not for Qt's thread.
std::optional<BetterPlace> betterPlace(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                       const WorkTask& task);

/// The targets of the active hands, moved by `shift_W`, as a task for the solver; for `figure` in a posture that
/// stands as it shall.
mannequin::PostureTask taskAt(const mannequin::Figure& from, const mannequin::Posture& posture,
                              const mannequin::Figure& figure, const dvec3& shift_W);

/// `posture`'s angles on another body that stands (or sits) on the same place.
mannequin::Posture standingAt(const mannequin::Figure& from, const mannequin::Posture& posture,
                              const mannequin::Figure& figure);

}  // namespace hapticell::ergonomics
