// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "geometry/system/regular_file.h"

namespace hapticell::trajectory {

namespace {

// Bytes: a guard against binary files; 64 KiB are some thousand columns. Half, twice: no table is so wide.
constexpr std::size_t kLongestLine = 1u << 16;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

void splitInto(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  while (true) {
    const auto end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string result = "'";
  result.append(text.substr(0, kShown));
  return result.append(text.size() <= kShown ? "'" : "…'");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// Reads one file; the members are what an error has to tell.
class Reader {
 public:
  Reader(const std::filesystem::path& file, const std::vector<std::string>& wanted,
         const std::vector<std::string>& optional)
      : name_(file.string()), stream_(file), wanted_(wanted), optional_(optional) {}

  Expected<CsvTable> read() {
    if (!stream_) return makeError({.file = name_, .found = stream_.error().found, .expected = "a readable CSV file"});
    HAPTICELL_TRY(readHeader());
    while (nextLine()) {
      HAPTICELL_TRY(readRow());
    }
    if (too_long_)
      return makeError({.file = name_,
                        .place = place(),
                        .found = "a line of more than 65 536 characters",
                        .expected = "a CSV file"});
    if (table_.rows.empty())
      return makeError(
          {.file = name_, .place = place(), .found = "no line after the header", .expected = "at least one"});
    return std::move(table_);
  }

 private:
  Text place() const { return Text("line %1", line_number_); }

  /// The next line that is neither empty nor a comment.
  bool nextLine() {
    while (std::getline(stream_, line_)) {
      ++line_number_;
      if (line_.size() > kLongestLine) {
        too_long_ = true;
        return false;
      }
      if (line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      const std::string_view text = trimmed(line_);
      if (!text.empty() && text.front() != '#') return true;
    }
    return false;
  }

  tl::expected<void, Error> readHeader() {
    const Text columns("a header line with the columns %1", listed(wanted_));
    if (!nextLine())
      return makeError({.file = name_,
                        .found = too_long_ ? Text("a first line that is too long") : Text("an empty file"),
                        .expected = columns});
    separator_ = line_.find(';') != std::string::npos ? ';' : ',';
    splitInto(line_, separator_, fields_);
    field_count_ = fields_.size();
    for (const auto* names : {&wanted_, &optional_}) {
      for (const std::string& name : *names) {
        const auto found = std::find(fields_.begin(), fields_.end(), name);
        const bool is_there = found != fields_.end();
        if (!is_there && names == &wanted_) {
          return makeError({.file = name_,
                            .place = place(),
                            .found = Text("no column '%1' in %2", name, excerpt(line_)),
                            .expected = columns});
        }
        if (is_there && std::find(found + 1, fields_.end(), name) != fields_.end()) {
          return makeError(
              {.file = name_, .place = place(), .found = Text("two columns '%1'", name), .expected = "one"});
        }
        columns_.push_back(is_there ? found - fields_.begin() : -1);
        if (names == &optional_) table_.has_optional.push_back(is_there);
      }
    }
    return {};
  }

  tl::expected<void, Error> readRow() {
    splitInto(line_, separator_, fields_);
    if (fields_.size() != field_count_) {
      return makeError({.file = name_,
                        .place = place(),
                        .found = Text("%1 fields", fields_.size()),
                        .expected = Text("%1, as in the header", field_count_)});
    }
    std::vector<double> row;
    row.reserve(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i] < 0) {
        row.push_back(0.0);
        continue;
      }
      const std::string_view field = fields_[static_cast<std::size_t>(columns_[i])];
      const auto number = parseNumber(field);
      const std::string& name = i < wanted_.size() ? wanted_[i] : optional_[i - wanted_.size()];
      if (!number) {
        return makeError({.file = name_,
                          .place = Text("line %1, column '%2'", line_number_, name),
                          .found = field.empty() ? Text("nothing") : Text(excerpt(field)),
                          .expected = "a finite number with '.' as decimal point"});
      }
      row.push_back(*number);
    }
    table_.rows.push_back(std::move(row));
    table_.lines.push_back(line_number_);
    return {};
  }

  std::string name_;
  geometry::RegularFileStream stream_;
  const std::vector<std::string>& wanted_;
  const std::vector<std::string>& optional_;
  std::string line_;
  std::size_t line_number_ = 0;
  bool too_long_ = false;
  char separator_ = ',';
  std::size_t field_count_ = 0;
  std::vector<std::string_view> fields_;
  std::vector<std::ptrdiff_t> columns_;
  CsvTable table_;
};

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

Expected<CsvTable> readCsvTable(const std::filesystem::path& file, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& optional) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    return makeError({.file = file.string(), .found = "a folder", .expected = "a CSV file"});
  }
  return Reader(file, wanted, optional).read();
}

}  // namespace hapticell::trajectory
