// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::ergonomics {

/// One limit of a hand's force, and where it holds.
struct ForceTableRow {
  int hand = -1;  ///< 0 left, 1 right, -1 either.
  /// m, of the grip above the floor, and level from the shoulder: from the first (included) to the second (not).
  std::array<double, 2> height = {0.0, std::numeric_limits<double>::infinity()};
  std::array<double, 2> reach = {0.0, std::numeric_limits<double>::infinity()};
  double limit_n = 0.0;
};

/// The user's own limits of what a hand may exert, of a source that the user answers for (a standard that was bought,
/// measurements): none are shipped.
struct ForceTable {
  std::string source;  ///< As the file says it, else the file's name.
  std::vector<ForceTableRow> rows;

  /// The least limit of all rows that hold there; nothing where none does.
  std::optional<double> limitAt(int hand, double height_m, double reach_m) const;
  bool isEmpty() const { return rows.empty(); }
};

/// Reads comma-separated values with a line of names: `limit_n`, and as wanted `hand` (left, right, any),
/// `height_from_m`, `height_to_m`, `reach_from_m`, `reach_to_m`; an empty field does not limit. Lines that begin with #
/// are notes; "# source: ..." names the source. Refused by line and name: unknown names, invalid numbers, a limit
/// outside 0 to 5000 N (0 not included), a range that ends before it begins, a table without a row.
Expected<ForceTable> readForceTable(const std::filesystem::path& file);

}  // namespace hapticell::ergonomics
