// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/force_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "geometry/system/regular_file.h"

namespace hapticell::ergonomics {
namespace {

constexpr std::array<std::string_view, 6> kForceNames{"hand",         "height_from_m", "height_to_m",
                                                      "reach_from_m", "reach_to_m",    "limit_n"};
/// N: some times what a person can do, against numbers in other units. Half, twice: other typing errors are refused.
constexpr double kMostForce = 5000.0;
// Guards memory and time. Half, twice: other tables are refused with a message.
constexpr std::size_t kMostRows = 10000;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t start = 0;;) {
    const auto comma = line.find(',', start);
    fields.push_back(trimmed(line.substr(start, comma - start)));
    if (comma == std::string_view::npos) return fields;
    start = comma + 1;
  }
}

/// Reads one table, line by line.
class TableReader {
 public:
  explicit TableReader(std::string file) : file_(std::move(file)) {}

  Expected<void> take(std::string_view line) {
    ++line_;
    line = trimmed(line);
    if (line.empty()) return {};
    if (line.front() == '#') {
      const std::string_view note = trimmed(line.substr(1));
      constexpr std::string_view kSource = "source:";
      if (note.substr(0, kSource.size()) == kSource) table_.source = trimmed(note.substr(kSource.size()));
      return {};
    }
    return columns_.empty() ? names(line) : row(line);
  }

  Expected<ForceTable> finish() && {
    if (columns_.empty())
      return refused("", Text("no header line"), Text("limit_n, and optionally hand, height_from_m ..."));
    if (table_.rows.empty())
      return refused("", Text("no line of values"), Text("at least one limit after the header line"));
    if (table_.source.empty()) table_.source = std::filesystem::path(file_).filename().string();
    return std::move(table_);
  }

 private:
  tl::unexpected<Error> refused(std::string_view name, const Text& found, const Text& expected) const {
    return makeError({.file = file_,
                      .place = name.empty() ? Text("line %1", line_) : Text("line %1, %2", line_, name),
                      .found = found,
                      .expected = expected});
  }

  Expected<void> names(std::string_view line) {
    for (const std::string_view name : fieldsOf(line)) {
      const auto known = std::find(kForceNames.begin(), kForceNames.end(), name);
      if (known == kForceNames.end())
        return refused(name, Text("no column has this name"),
                       Text::plain("hand, height_from_m, height_to_m, reach_from_m, reach_to_m, limit_n"));
      const auto column = static_cast<std::size_t>(known - kForceNames.begin());
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end())
        return refused(name, Text("it is there twice"), Text("each column once"));
      columns_.push_back(column);
    }
    if (std::find(columns_.begin(), columns_.end(), kForceNames.size() - 1) == columns_.end())
      return refused("limit_n", Text("it is missing"), Text("a column limit_n in newtons"));
    return {};
  }

  Expected<void> row(std::string_view line) {
    const auto fields = fieldsOf(line);
    if (fields.size() != columns_.size())
      return refused("", Text("%1 fields", fields.size()), Text("%1", columns_.size()));
    if (table_.rows.size() == kMostRows) return refused("", Text("too many rows"), Text("at most %1", kMostRows));
    ForceTableRow row;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (auto taken = field(columns_[i], fields[i], row); !taken) return taken;
    }
    if (row.limit_n <= 0.0) return refused("limit_n", Text("it is empty"), Text("a force in newtons"));
    if (row.height[1] <= row.height[0])
      return refused("height_to_m", Text("the end of the range is below its start"), Text("more than height_from_m"));
    if (row.reach[1] <= row.reach[0])
      return refused("reach_to_m", Text("the end of the range is below its start"), Text("more than reach_from_m"));
    table_.rows.push_back(row);
    return {};
  }

  Expected<void> field(std::size_t column, std::string_view text, ForceTableRow& row) const {
    if (text.empty()) return {};
    if (column == 0) {
      if (text != "left" && text != "right" && text != "any")
        return refused("hand", Text("'%1'", text), Text("left, right or any"));
      row.hand = -1;
      if (text != "any") row.hand = text == "left" ? 0 : 1;
      return {};
    }
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size() && std::isfinite(value);
    const bool force = column == kForceNames.size() - 1;
    if (!whole || value < 0.0 || (force && (value == 0.0 || value > kMostForce)))
      return refused(kForceNames[column], Text("'%1'", text),
                     force ? Text("a force above 0, at most 5000 N") : Text("metres, 0 or more"));
    double* const targets[] = {&row.height[0], &row.height[1], &row.reach[0], &row.reach[1], &row.limit_n};
    *targets[column - 1] = value;
    return {};
  }

  std::string file_;
  ForceTable table_;
  std::vector<std::size_t> columns_;
  std::size_t line_ = 0;
};

bool isWithin(const std::array<double, 2>& range, double value) {
  return value >= range[0] && value < range[1];
}

}  // namespace

std::optional<double> ForceTable::limitAt(int hand, double height_m, double reach_m) const {
  std::optional<double> least;
  for (const ForceTableRow& row : rows) {
    if (row.hand >= 0 && row.hand != hand) continue;
    if (!isWithin(row.height, height_m) || !isWithin(row.reach, reach_m)) continue;
    least = std::min(least.value_or(row.limit_n), row.limit_n);
  }
  return least;
}

Expected<ForceTable> readForceTable(const std::filesystem::path& file) {
  geometry::RegularFileStream in(file);
  HAPTICELL_TRY(in);
  TableReader reader(file.string());
  for (std::string line; std::getline(in, line);) {
    HAPTICELL_TRY(reader.take(line));
  }
  return std::move(reader).finish();
}

}  // namespace hapticell::ergonomics
