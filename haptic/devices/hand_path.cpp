// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/hand_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "geometry/system/assertion.h"
#include "geometry/system/regular_file.h"
#include "haptic/devices/hand_path_units.h"

namespace hapticell::haptic {

namespace {

constexpr std::array<std::string_view, 9> kColumns{"t", "x", "y", "z", "qw", "qx", "qy", "qz", "button"};
constexpr std::size_t kRequired = 4;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t begin = 0;;) {
    const auto end = line.find(',', begin);
    result.push_back(trimmed(line.substr(begin, end - begin)));
    if (end == std::string_view::npos) return result;
    begin = end + 1;
  }
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Where each known column stands in the file, if it does.
using Layout = std::array<std::optional<std::size_t>, kColumns.size()>;

class Parser {
 public:
  explicit Parser(std::string name) : name_(std::move(name)) {}

  Expected<HandPath> parse(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (std::size_t begin = 0; begin <= text.size();) {
      const auto end = std::min(text.find('\n', begin), text.size());
      ++line_;
      const std::string_view line = trimmed(text.substr(begin, end - begin));
      begin = end + 1;
      if (line.empty() || line.starts_with('#')) continue;
      const auto done = has_header_ ? readRow(cells(line)) : readHeader(cells(line));
      HAPTICELL_TRY(done);
    }
    if (samples_.empty())
      return makeError({.file = name_,
                        .found = "no line after the header",
                        .expected = "a header line and at least one line of values"});
    auto assumed = recogniseHandUnits(samples_, name_);
    HAPTICELL_TRY(assumed);
    return HandPath(std::move(samples_), std::move(*assumed));
  }

 private:
  Error error(std::string_view column, Text found, Text expected) const {
    return {.file = name_,
            .place = Text("line %1, column '%2'", line_, column),
            .found = std::move(found),
            .expected = std::move(expected)};
  }

  Expected<void> readHeader(const std::vector<std::string_view>& names) {
    has_header_ = true;
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const auto found = std::find(names.begin(), names.end(), kColumns[i]);
      if (found != names.end()) layout_[i] = static_cast<std::size_t>(found - names.begin());
    }
    const bool turns = layout_[4] || layout_[5] || layout_[6] || layout_[7];
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const bool wanted = i < kRequired || (turns && i >= 4 && i < 8);
      if (!wanted || layout_[i]) continue;
      return makeError(error(kColumns[i], Text("the column is missing"), "t,x,y,z,qw,qx,qy,qz,button"));
    }
    return {};
  }

  Expected<void> readRow(const std::vector<std::string_view>& row) {
    std::array<double, kColumns.size()> value{0, 0, 0, 0, 1, 0, 0, 0, 0};
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      if (!layout_[i]) continue;
      const std::string_view cell = *layout_[i] < row.size() ? row[*layout_[i]] : std::string_view();
      const auto read = number(cell);
      if (!read) return makeError(error(kColumns[i], '"' + std::string(cell) + '"', Text("a number")));
      value[i] = *read;
    }
    return add(value);
  }

  Expected<void> add(const std::array<double, kColumns.size()>& value) {
    const dquat q(value[4], value[5], value[6], value[7]);
    const double length = glm::length(q);
    if (std::abs(length - 1.0) > 0.01) {
      return makeError(
          error("qw", Text("a quaternion of length %1", std::to_string(length)), Text("a length of 1 within 1 %")));
    }
    if (!samples_.empty() && value[0] < samples_.back().t) {
      return makeError(error("t", std::to_string(value[0]), Text("at least the time of the line before")));
    }
    if (value[8] != 0.0 && value[8] != 1.0 && value[8] != 2.0 && value[8] != 3.0) {
      return makeError(error("button", std::to_string(value[8]),
                             Text("0 (not pressed), 1 (first button), 2 (second button) or 3 (both)")));
    }
    samples_.push_back({value[0], {{value[1], value[2], value[3]}, q / length}, static_cast<std::uint32_t>(value[8])});
    return {};
  }

  std::string name_;
  std::size_t line_ = 0;
  bool has_header_ = false;
  Layout layout_{};
  std::vector<HandSample> samples_;
};

}  // namespace

HandPath::HandPath(std::vector<HandSample> samples, std::vector<Text> assumptions)
    : samples_(std::move(samples)), assumptions_(std::move(assumptions)) {
  HAPTICELL_DEMAND(!samples_.empty());
  HAPTICELL_DEMAND(std::is_sorted(samples_.begin(), samples_.end(),
                                  [](const HandSample& a, const HandSample& b) { return a.t < b.t; }));
}

HandSample HandPath::at(double t) const {
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), t,
                                      [](double time, const HandSample& s) { return time < s.t; });
  if (after == samples_.begin()) return samples_.front();
  const HandSample& before = *(after - 1);
  if (after == samples_.end()) return before;
  const double part = (t - before.t) / (after->t - before.t);
  return {t, interpolate(before.X_DH, after->X_DH, part), before.buttons};
}

Expected<HandPath> parseHandPath(std::string_view text, const std::string& name) {
  return Parser(name).parse(text);
}

Expected<HandPath> readHandPath(const std::filesystem::path& file) {
  const auto text = geometry::readRegularFile(file);
  HAPTICELL_TRY(text);
  return parseHandPath(*text, file.string());
}

}  // namespace hapticell::haptic
