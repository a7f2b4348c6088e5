// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/system/text.h"

namespace hapticell::mannequin {

/// Words of a text with their line numbers. Lines end as on Unix, Windows or an old Mac; a byte order mark before the
/// first word is skipped.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  /// The next word; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && isBlank(text_[at_])) step();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// The next word without taking it.
  std::string_view peek() const {
    WordReader copy = *this;
    return copy.next();
  }
  /// The rest of this line.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !endsLine(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// The next line that has a word in it, from its first word on; empty at the end.
  std::string_view nextLine() {
    while (at_ < text_.size() && isBlank(text_[at_])) step();
    return restOfLine();
  }
  /// The text from the next word up to `mark` or the line's end, without trailing blanks.
  std::string_view nextBefore(char mark) {
    while (at_ < text_.size() && isBlank(text_[at_])) step();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !endsLine(text_[at_]) && text_[at_] != mark) ++at_;
    std::size_t end = at_;
    while (end > begin && isBlank(text_[end - 1])) --end;
    return text_.substr(begin, end - begin);
  }
  /// Consumes `mark` if it comes next, after blanks; otherwise returns false.
  bool take(char mark) {
    while (at_ < text_.size() && isBlank(text_[at_])) step();
    if (at_ >= text_.size() || text_[at_] != mark) return false;
    ++at_;
    return true;
  }
  /// A finite number of plausible size, or empty.
  std::optional<double> number() { return numberOf(next()); }
  static std::optional<double> numberOf(std::string_view word) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && end == word.data() + word.size() && !word.empty();
    // A denormal is taken as zero: some programs write rounded angles as 1e-310.
    if (error == std::errc::result_out_of_range && end == word.data() + word.size() && isTiny(word)) return 0.0;
    if (!whole || !std::isfinite(value) || std::abs(value) > 1e9) return std::nullopt;
    return value;
  }
  bool atEnd() const { return peek().empty(); }
  Text place() const { return Text("line %1", line_); }

 private:
  /// For a number that no double can represent: true if it is too small, false if too large.
  static bool isTiny(std::string_view word) {
    const std::size_t exponent = word.find_first_of("eE");
    if (exponent != std::string_view::npos) return word.substr(exponent + 1).starts_with('-');
    return word.find_first_not_of("-0") == word.find('.');
  }
  static bool endsLine(char c) { return c == '\n' || c == '\r'; }
  static bool isBlank(char c) { return c == ' ' || c == '\t' || endsLine(c); }
  void step() {
    const bool windows = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    line_ += endsLine(text_[at_]) && !windows ? 1 : 0;
    ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// The reason why a text is not readable as text: two bytes per letter, or zeros in it. Empty if it is readable.
inline Text whyNoText(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return Text("UTF-16 text");
  if (text.substr(0, 4096).find('\0') != std::string_view::npos) return Text("bytes that are not text");
  return {};
}

}  // namespace hapticell::mannequin
