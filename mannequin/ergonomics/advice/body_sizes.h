// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/posture_solver.h"

namespace hapticell::ergonomics {

/// One body at the place and the targets of another.
struct BodyAtTask {
  std::string name;  ///< "P5F" ...
  mannequin::Figure figure;
  mannequin::Posture posture;
  bool is_reached = false;
  double short_m = 0.0;       ///< Distance of the worse hand to its target.
  double reach_left_m = 0.0;  ///< Remaining reach of the arm that has less.
  PostureScores scores;
};

/// The hands that work: raised or bent; if neither is, the right one.
std::array<bool, 2> activeHands(const mannequin::FigurePose& pose, const mannequin::Posture& posture);

/// Remaining reach (m) of the active arm that has less, to its grip; 0 if it is straight.
double reachLeft(const mannequin::Figure& figure, const mannequin::FigurePose& pose, const std::array<bool, 2>& active);

/// The same work done by other bodies: feet and active grips at the same places as in `posture` (grips turned alike),
/// with all limits and balance kept; the figure's own sex and stature is unchanged. Well under a millisecond per body;
/// any thread.
std::vector<BodyAtTask> atSameTask(const std::vector<mannequin::NamedFigure>& bodies, const mannequin::Figure& figure,
                                   const mannequin::Posture& posture, const WorkTask& task);

/// RULA of each body with the targets moved up by each of `rises` (m); 0 if the body does not reach them there.
std::vector<std::vector<int>> scoresByHeight(const std::vector<mannequin::NamedFigure>& bodies,
                                             const mannequin::Figure& figure, const mannequin::Posture& posture,
                                             const WorkTask& task, const std::vector<double>& rises);

/// The targets of the active hands, moved by `shift_W`, as a task for the solver; for `figure` in its posture.
mannequin::PostureTask taskAt(const mannequin::Figure& from, const mannequin::Posture& posture,
                              const mannequin::Figure& figure, const dvec3& shift_W);

/// The angles of `posture` on another body that stands (or sits) at the same place.
mannequin::Posture standingAt(const mannequin::Figure& from, const mannequin::Posture& posture,
                              const mannequin::Figure& figure);

/// The posture "seated" of the library for another body, its pelvis above the same place of the floor and facing as in
/// `posture`; the seat has the height that the library gives this body.
mannequin::Posture seatedAt(const mannequin::Posture& posture, const mannequin::Figure& figure);

}  // namespace hapticell::ergonomics
