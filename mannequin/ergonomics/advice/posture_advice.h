// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mannequin/ergonomics/advice/change_search.h"
#include "mannequin/ergonomics/methods/posture_angles.h"
#include "mannequin/ergonomics/methods/scored_method.h"

namespace hapticell::ergonomics {

/// One named member of PostureAngles: an angle (degrees) or a flag.
struct PostureField {
  std::string_view name;  ///< As in files, e.g. "upper_arm_flexion".
  std::optional<double> PostureAngles::*angle = nullptr;
  std::optional<bool> PostureAngles::*flag = nullptr;  ///< Exactly one of the two is set.
  double least = 0.0;                                  ///< Of an angle that a person can have, degrees.
  double greatest = 0.0;
  bool good_value = false;     ///< Of a flag: the one that never scores higher.
  bool is_correctable = true;  ///< False for changes that do not correct a posture: to sit instead, how it was
                               ///< measured.
};

/// All members, in the order of PostureAngles.
const std::vector<PostureField>& postureFields();

/// Score of a posture; empty where it cannot be scored.
using PostureScore = std::function<std::optional<int>(const PostureAngles&)>;

/// The score of angles by RULA or REBA, with the other inputs (loads, activity) from `values`; empty inputs count as
/// the least value. `method` must outlive it.
PostureScore scoreOfAngles(const ScoredMethod& method, std::span<const std::optional<int>> values);

/// Changes of single fields that lower the score, largest fall first, then smallest change.
std::vector<PostureDriver> postureDrivers(const PostureAngles& angles, const PostureScore& score);

/// The smallest change (10 degrees count as much as one flag; at most four fields) that brings `level_of(score)` down;
/// empty where none does. Runs for tens of milliseconds at most: not for the loops.
std::optional<PostureGoal> nextLevelPosture(const PostureAngles& angles, const PostureScore& score,
                                            const std::function<int(int)>& level_of);

}  // namespace hapticell::ergonomics
