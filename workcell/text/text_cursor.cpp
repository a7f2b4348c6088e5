// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/text_cursor.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace hapticell::workcell {

namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string numberText(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

}  // namespace

TextCursor::TextCursor(std::string_view text, Continuation continuation) : text_(text), continuation_(continuation) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

bool TextCursor::nextLine() {
  if (next_ >= text_.size()) {
    line_ = {};
    return false;
  }
  const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
  line_ = text_.substr(next_, end - next_);
  next_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  next_ = std::min(next_, text_.size());
  ++line_number_;
  return true;
}

std::string_view TextCursor::nextWord() {
  while (true) {
    line_.remove_prefix(std::min(line_.find_first_not_of(kBlanks), line_.size()));
    std::string_view word = line_.substr(0, line_.find_first_of(kBlanks));
    line_.remove_prefix(word.size());
    const bool goes_on = continuation_ == Continuation::kBackslash && word.ends_with('\\') && !word.starts_with('#') &&
                         line_.find_first_not_of(kBlanks) == std::string_view::npos;
    if (!goes_on) return word;
    word.remove_suffix(1);
    if (!nextLine() || !word.empty()) return word;
  }
}

std::string_view TextCursor::nextWordOfText() {
  while (true) {
    const std::string_view word = nextWord();
    if (!word.empty() || !nextLine()) return word;
  }
}

std::string_view TextCursor::restOfLine() {
  std::string_view rest = line_;
  line_ = {};
  rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
  rest = rest.substr(0, rest.find_last_not_of(kBlanks) + 1);
  return rest;
}

std::optional<double> parseNumber(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || fault == std::errc::invalid_argument) return std::nullopt;
  if (fault == std::errc::result_out_of_range) {
    // Too small is zero for our purpose; too large is infinite.
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    const double sign = word.starts_with('-') ? -1.0 : 1.0;
    return tiny ? 0.0 : sign * std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || fault != std::errc()) return std::nullopt;
  return value;
}

std::string inQuotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (char c : word.substr(0, kLongest)) text += (c >= ' ' && c < 127) ? c : '?';
  return text + (word.size() > kLongest ? "...'" : "'");
}

bool isUsable(double coordinate) {
  // As kFarthest of geometry/shapes/pose.cpp: what is squared on the way is finite then.
  constexpr double kLargest = 1e12;
  return std::abs(coordinate) <= kLargest;  // False for NaN too.
}

bool isUsable(const dvec3& point) {
  return isUsable(point.x) && isUsable(point.y) && isUsable(point.z);
}

Error unusableCoordinate(Text place, const dvec3& point) {
  double bad = point.x;
  if (isUsable(bad)) bad = point.y;
  if (isUsable(bad)) bad = point.z;
  return {.place = std::move(place),
          .found = Text("a vertex with the coordinate %1", numberText(bad)),
          .expected = "finite numbers of a plausible size",
          .fix = "The file is damaged: export it again."};
}

Expected<dvec3> readPoint(TextCursor& cursor) {
  dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = cursor.nextWordOfText();
    const std::optional<double> value = parseNumber(word);
    if (word.empty()) {
      return makeError({.place = cursor.place(),
                        .found = "the file ends inside a vertex",
                        .expected = "three coordinates",
                        .fix = "The file is truncated: export it again."});
    }
    if (!value) {
      return makeError({.place = cursor.place(),
                        .found = Text("a vertex with %1", inQuotes(word)),
                        .expected = "a finite number with '.' as decimal point"});
    }
    point[axis] = *value;
  }
  if (!isUsable(point)) return makeError(unusableCoordinate(cursor.place(), point));
  return point;
}

}  // namespace hapticell::workcell
