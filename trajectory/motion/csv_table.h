// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::trajectory {

/// Numbers read from a CSV file, a row a line, only the wanted columns and in their order.
struct CsvTable {
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;  ///< The line of the file of each row, from 1.
  std::vector<bool> has_optional;  ///< For each optional column whether the file has it (its numbers are 0 else).
};

/// Reads the columns `wanted`, which must be there, and then `optional`. See pose_csv.h for the format.
Expected<CsvTable> readCsvTable(const std::filesystem::path& file, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& optional = {});

/// A finite number with `.` as decimal point, whatever the locale, and nothing else but blanks about it.
std::optional<double> parseNumber(std::string_view text);

}  // namespace hapticell::trajectory
