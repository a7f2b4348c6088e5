// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::trajectory {

/// Numbers read from a CSV file: one row per line, only the requested columns, in the requested order.
struct CsvTable {
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;  ///< The line of the file of each row, from 1.
  std::vector<bool> has_optional;  ///< For each optional column, whether the file has it (otherwise its numbers are 0).
};

/// Reads the columns `wanted`, which are required, and then `optional`. See pose_csv.h for the format.
Expected<CsvTable> readCsvTable(const std::filesystem::path& file, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& optional = {});

/// A finite number with `.` as decimal point in any locale, surrounded by blanks only.
std::optional<double> parseNumber(std::string_view text);

}  // namespace hapticell::trajectory
