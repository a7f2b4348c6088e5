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

/// One limit of a hand force, and its range.
struct ForceTableRow {
  int hand = -1;  ///< 0 left, 1 right, -1 either.
  /// m, of the grip above the floor, and level from the shoulder: from the first (included) to the second (not).
  std::array<double, 2> height = {0.0, std::numeric_limits<double>::infinity()};
  std::array<double, 2> reach = {0.0, std::numeric_limits<double>::infinity()};
  double limit_n = 0.0;
};

/// The user's own limits of hand force, from a source that the user is responsible for (a purchased standard,
/// measurements): none are shipped.
struct ForceTable {
  std::string source;  ///< As stated in the file, otherwise the file name.
  std::vector<ForceTableRow> rows;

  /// The least limit of all rows that apply; empty if no row applies.
  std::optional<double> limitAt(int hand, double height_m, double reach_m) const;
  bool isEmpty() const { return rows.empty(); }
};

/// Reads comma-separated values with a header line: `limit_n`, and optionally `hand` (left, right, any),
/// `height_from_m`, `height_to_m`, `reach_from_m`, `reach_to_m`; an empty field means no restriction. Lines that begin
/// with # are comments; "# source: ..." names the source. Refused by line and name: unknown names, invalid numbers, a
/// limit outside 0 to 5000 N (0 excluded), a range that ends before it begins, a table without a row.
Expected<ForceTable> readForceTable(const std::filesystem::path& file);

}  // namespace hapticell::ergonomics
