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
  double least = 0.0;                                  ///< For an angle, degrees: the values that a person can take.
  double greatest = 0.0;
  bool good_value = false;  ///< For a flag: the value that never scores higher.
  /// False for changes that do not correct a posture: sitting instead of standing, the way of measuring.
  bool is_correctable = true;
};

/// All members, in the order of PostureAngles.
const std::vector<PostureField>& postureFields();

/// Score of a posture; empty if it cannot be scored.
using PostureScore = std::function<std::optional<int>(const PostureAngles&)>;

/// The score of angles by RULA or REBA, with the other inputs (loads, activity) from `values`; empty inputs count as
/// the least value. `method` must outlive it.
PostureScore scoreOfAngles(const ScoredMethod& method, std::span<const std::optional<int>> values);

/// Changes of single fields that lower the score, largest decrease first, then smallest change.
std::vector<PostureDriver> postureDrivers(const PostureAngles& angles, const PostureScore& score);

/// The smallest change (10 degrees count as much as one flag; at most four fields) that lowers `level_of(score)`; empty
/// if no change does. Takes up to tens of milliseconds: not for the loops.
std::optional<PostureGoal> nextLevelPosture(const PostureAngles& angles, const PostureScore& score,
                                            const std::function<int(int)>& level_of);

}  // namespace hapticell::ergonomics
