// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "access/grasp_places.h"
#include "access/hand_sweep.h"
#include "manipulation/checks/mannequin_sight.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/posture.h"

namespace hapticell::access {

/// Persons and what they work with.
struct BodyQuestion {
  std::vector<mannequin::NamedFigure> bodies;  ///< Names unique.
  double glove = 0.002;  ///< m of room around the bare hand. Half: a thin glove; twice: a thick one.
  Tool tool;
  ergonomics::WorkTask task;  ///< Its loads are those of the part, in the hand that takes it.
  double load_kg = 1.0;       ///< Of the part.
};

/// How one person gets at the part. Fields after `reached` describe the best place to take it.
struct BodyAccess {
  std::string name;  ///< "P5F"
  mannequin::Figure figure;
  bool reached = false;   ///< A hand is at the part, all limits and balance kept, the body in nothing, the hand fits.
  std::string why{};      ///< Why it is not: "80 mm short", "touches Bench", "the hand meets Housing".
  double short_m = 0.0;   ///< m that the hand lacks.
  std::string touched{};  ///< What the body (not the hand) would enter.
  mannequin::Side hand = mannequin::Side::kRight;
  GraspPlace place;
  std::string grasp{};             ///< "pinch", "power", "flat".
  HandSweep sweep;                 ///< Of the gloved hand and the tool along the way.
  double along = 0.0;              ///< Share of the way on which this hand can stay with the part.
  mannequin::Posture posture;      ///< At the part as it stands.
  mannequin::Posture posture_end;  ///< At the end of what it can follow.
  manipulation::TargetSight sight;
  ergonomics::PostureScores scores;      ///< At the part as it stands.
  ergonomics::PostureScores scores_end;  ///< At the end of what it can follow.
};

/// Tries all places to take the unit with both hands and, for each person, the place of the cell's mannequin (which may
/// step) and free places on the floor around the part. Places are ordered by: reached, then the lowest RULA score, then
/// the best sight. The parts that are `gone`, and the cell's own persons, are not there. A second or some a person, in
/// this thread; `cancel` ends early and returns the persons done. Any thread.
std::vector<BodyAccess> bodyAccess(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way,
                                   const BodyQuestion& question, const std::atomic<bool>& cancel);

}  // namespace hapticell::access
