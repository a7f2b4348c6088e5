// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace hapticell::ergonomics {

/// Something about a posture that could be otherwise: an angle in degrees, a flag (0 or 1) or a count.
struct ChangeField {
  std::string_view name;  ///< As in files, e.g. "trunk_flexion".
  bool is_flag = false;
  double unit = 10.0;  ///< How much of it is as great a change as one flag.
  double from = 0.0;
  std::vector<double> values{};  ///< Others that are worth trying, nearest first.
};

/// A change of one field; for flags 0 and 1.
struct FieldChange {
  std::string_view field;
  bool is_flag = false;
  double from = 0.0;
  double to = 0.0;
};

/// What one change alone would make of the score.
struct PostureDriver {
  FieldChange change;
  double score = 0.0;
};

/// The smallest change found that reaches a lower level.
struct PostureGoal {
  std::vector<FieldChange> changes{};
  double score = 0.0;
};

/// Score of the fields' values (one each, in their order); empty where they cannot be scored.
using ValuesScore = std::function<std::optional<double>(std::span<const double>)>;
using LevelOf = std::function<int(double)>;

/// Changes of single fields that lower the score: of each the one that lowers it most (of equal ones the nearest);
/// largest fall first, then smallest change.
std::vector<PostureDriver> singleChanges(const std::vector<ChangeField>& fields, const ValuesScore& score);

/// The changes of fewest fields (at most `most`), and among those the smallest in sum, that bring the level down; empty
/// where none do. All combinations of up to five values a field are tried.
std::optional<PostureGoal> nearestLowerLevel(const std::vector<ChangeField>& fields, const ValuesScore& score,
                                             const LevelOf& level_of, std::size_t most = 4);

/// `values` but `from`, nearest to it first.
std::vector<double> nearestFirst(std::vector<double> values, double from);

}  // namespace hapticell::ergonomics
