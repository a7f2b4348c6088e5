// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace hapticell::mannequin {

/// Words of a text with the line they stand in.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : text_(text) {}

  /// The next word; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && isBlank(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// The next word without taking it.
  std::string_view peek() const {
    WordReader copy = *this;
    return copy.next();
  }
  /// What is left of this line.
  std::string_view restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// A finite number of believable size, or nothing.
  std::optional<double> number() {
    const std::string_view word = next();
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && end == word.data() + word.size() && !word.empty();
    // A denormal is zero here: rounded-off angles are written as 1e-310 by some programs.
    if (error == std::errc::result_out_of_range && end == word.data() + word.size()) return 0.0;
    if (!whole || !std::isfinite(value) || std::abs(value) > 1e9) return std::nullopt;
    return value;
  }
  bool atEnd() const { return peek().empty(); }
  std::string place() const { return "line " + std::to_string(line_); }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace hapticell::mannequin
