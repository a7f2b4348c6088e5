// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::studies {

class SectionReader;

/// A value of what varies: a number, or a word (the name of a robot, a body, a tool, a file).
using Value = std::variant<double, std::string>;
/// As tables and messages show it: "0.25", "library:ur5e". Numbers with all digits that they need.
std::string textOf(const Value& value);

/// The values that one thing takes: a list of words, a list of numbers, a range, or a normal distribution.
class ValueRange {
 public:
  /// Reads `values`, or `from`, `to` and `steps`, or `middle` and `sigma`, as numbers; each times `unit`.
  static Expected<ValueRange> numbers(SectionReader& reader, double unit = 1.0);
  /// Reads `values` as words.
  static Expected<ValueRange> words(SectionReader& reader);
  static ValueRange ofWords(std::vector<std::string> words);

  /// Of a list or a range with steps; 0: every value between is possible.
  std::size_t count() const { return values_.size(); }
  const Value& at(std::size_t index) const { return values_[index]; }
  /// The value at a share of the range, 0 <= share < 1: of lists each has an equal part; a normal distribution has
  /// its quantile.
  Value atShare(double share) const;
  /// Numbers that a search may change between two ends.
  bool isContinuous() const { return values_.empty() && !is_normal_; }
  bool isNormal() const { return is_normal_; }
  double from() const { return from_; }
  double to() const { return to_; }
  bool isWords() const { return is_words_; }

 private:
  std::vector<Value> values_;
  bool is_words_ = false;
  bool is_normal_ = false;
  double from_ = 0.0, to_ = 0.0;  ///< Ends; of a normal distribution its middle and its standard deviation.
};

}  // namespace hapticell::studies
