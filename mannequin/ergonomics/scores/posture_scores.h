// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/methods/eaws.h"
#include "mannequin/ergonomics/methods/niosh.h"
#include "mannequin/ergonomics/methods/owas.h"
#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/reba.h"
#include "mannequin/ergonomics/methods/rula.h"
#include "mannequin/ergonomics/methods/static_posture.h"
#include "mannequin/ergonomics/scores/work_task.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"

namespace hapticell::ergonomics {

/// RULA and REBA for the arm of one side, with their sub-scores.
struct SideScores {
  MeasuredPosture measured;
  PostureAngles angles;
  Rula::Values rula{};  ///< Empty if the task does not give it (muscle use, force): then scored as least, and partial.
  Reba::Values reba{};
  int rula_score = 0, rula_level = 0;
  int reba_score = 0, reba_level = 0;
  PartVerdicts en1005, iso11226;
};

/// The results of all methods for one posture of a figure at its task.
struct PostureScores {
  std::array<SideScores, 2> sides;  ///< Left, right.
  OwasPosture owas_posture;         ///< Input of OWAS.
  Owas::Values owas{};
  int owas_category = 0;
  EawsObservation eaws_observation;
  EawsPosture eaws = EawsPosture::kStandNoSupport;
  double eaws_points = 0.0;  ///< For this posture held all the time; an outline, not a complete EAWS score.
  double comfort = 1.0;      ///< Share of the 56 joints within their comfort range (our own choice of ranges).
  double head_inclination = 0.0, gaze_below_horizontal = 0.0;  ///< Degrees.
  bool is_seated = false;
  /// Task inputs that nobody entered; the scores that need them are partial.
  std::vector<std::string_view> missing{};

  /// The arm's side with the higher score (if equal, the right).
  mannequin::Side worseSide() const;
  const SideScores& worse() const { return sides[static_cast<std::size_t>(worseSide())]; }
  int rula() const { return worse().rula_score; }
  int reba() const { return std::max(sides[0].reba_score, sides[1].reba_score); }
  /// The four digits, "2121".
  int owasCode() const;
};

/// All methods at once, fast enough for each frame of a drag: some microseconds. `pose` is that of the posture. An
/// unknown load counts as no load for OWAS and REBA; `missing` lists it.
PostureScores scorePosture(const mannequin::Figure& figure, const mannequin::Posture& posture,
                           const mannequin::FigurePose& pose, const WorkTask& task);

/// Pace and support of the arm of one side and of the trunk, from the task; values that nobody entered count as none.
PostureUse postureUse(const WorkTask& task, mannequin::Side side);

/// The inputs of EN 1005-4 and ISO 11226 for one side, settledZones().
ZonePosture zonePosture(const PostureScores& scores, mannequin::Side side, const WorkTask& task);

/// Degrees by which a figure differs from seated: thighs within 35 deg of level, knees bent over 45 deg, shanks within
/// 60 deg of upright, the weight 30 mm or more off the soles (10 mm count as a degree); 0 or less if seated.
double offSeat(const mannequin::Figure& figure, const mannequin::FigurePose& pose);
/// True if offSeat() is 0 or less.
bool looksSeated(const mannequin::Figure& figure, const mannequin::FigurePose& pose);

/// The lift of a load between the hands at their present place, for the lifting equation; refused with the reason
/// outside its validity (one hand, seated or kneeling, inputs that are missing or out of range).
Expected<LiftingTask> liftOf(const mannequin::Figure& figure, const mannequin::FigurePose& pose,
                             const PostureScores& scores, const WorkTask& task);
/// The result of the equation.
Expected<LiftingResult> scoreLift(const mannequin::Figure& figure, const mannequin::FigurePose& pose,
                                  const PostureScores& scores, const WorkTask& task);

/// 0 to 3: the position of a sub-score in its range, for colours (0: the least; then the lower half, up to three
/// quarters, the rest).
int bandOfSubScore(const SubScore& sub_score, int value);
/// 0 to 3 for final scores: RULA 1-2, 3-4, 5-6, 7; REBA and OWAS by their levels.
int bandOfRula(int score);
int bandOfReba(int score);
int bandOfOwas(int category);
int bandOf(Zone zone);

enum class ColourMethod { kRula, kReba, kOwas, kEn1005 };

/// Band 0 to 3 of each segment of the body by a method, for its colour.
std::array<int, mannequin::kSegmentCount> segmentBands(const PostureScores& scores, ColourMethod method);

}  // namespace hapticell::ergonomics
