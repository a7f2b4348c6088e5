// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace hapticell::ergonomics {

/// A property of a posture that can be changed: an angle in degrees, a flag (0 or 1) or a count.
struct ChangeField {
  std::string_view name;  ///< As in files, e.g. "trunk_flexion".
  bool is_flag = false;
  double unit = 10.0;  ///< The amount that counts as much as a change of one flag.
  double from = 0.0;
  std::vector<double> values{};  ///< Other values worth trying, nearest first.
};

/// A change of one field; for flags 0 and 1.
struct FieldChange {
  std::string_view field;
  bool is_flag = false;
  double from = 0.0;
  double to = 0.0;
};

/// The score with one single change.
struct PostureDriver {
  FieldChange change;
  double score = 0.0;
};

/// The smallest change found that reaches a lower level.
struct PostureGoal {
  std::vector<FieldChange> changes{};
  double score = 0.0;
};

/// Score of the values of the fields (one each, in order); empty if they cannot be scored.
using ValuesScore = std::function<std::optional<double>(std::span<const double>)>;
using LevelOf = std::function<int(double)>;

/// Changes of single fields that lower the score: for each field the change that lowers it most (of equal ones the
/// nearest); largest decrease first, then smallest change.
std::vector<PostureDriver> singleChanges(const std::vector<ChangeField>& fields, const ValuesScore& score);

/// The changes of the fewest fields (at most `most`) and, among those, with the smallest sum, that lower the level;
/// empty if no change does. All combinations of up to five values per field are tried.
std::optional<PostureGoal> nearestLowerLevel(const std::vector<ChangeField>& fields, const ValuesScore& score,
                                             const LevelOf& level_of, std::size_t most = 4);

/// `values` without `from`, nearest to it first.
std::vector<double> nearestFirst(std::vector<double> values, double from);

}  // namespace hapticell::ergonomics
