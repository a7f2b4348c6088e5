// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/text.h"

namespace hapticell::trajectory {

/// The value of an expression in a robot program, as far as the files define it.
///
/// A value that depends on something outside (an input, a sensor, data of another file) is unknown, with the reason in
/// `why`; so is every value computed from it.
struct Value {
  enum class Kind { kUnknown, kNumber, kTruth, kText, kList, kRecord };
  Kind kind = Kind::kUnknown;
  double number = 0.0;              ///< Also of a boolean: 1 or 0.
  std::string text;                 ///< Of a text or enumeration; the type of a list.
  std::vector<Value> items;         ///< Of a list or record.
  std::vector<std::string> fields;  ///< Of a record, one per item.
  Text why{};                       ///< The reason, if the value is unknown.

  static Value unknown(Text why) { return {Kind::kUnknown, 0.0, {}, {}, {}, std::move(why)}; }
  static Value of(double number) { return {Kind::kNumber, number, {}, {}, {}}; }
  static Value truth(bool is_true) { return {Kind::kTruth, is_true ? 1.0 : 0.0, {}, {}, {}}; }
  static Value word(std::string text) { return {Kind::kText, 0.0, std::move(text), {}, {}}; }
  static Value list(std::string type, const std::vector<double>& numbers);
  static Value list(std::string type, std::vector<Value> items) {
    return {Kind::kList, 0.0, std::move(type), std::move(items), {}};
  }

  bool isKnown() const { return kind != Kind::kUnknown; }
  bool isNumber() const { return kind == Kind::kNumber || kind == Kind::kTruth; }
  /// The field of a record; empty if it has no such field.
  const Value* find(std::string_view field) const;
  std::optional<double> numberOf(std::string_view field) const;
  /// All numbers of a list; empty if an item is not a number, or the count differs from `count`.
  std::optional<std::vector<double>> numbers(std::size_t count) const;
  /// The reason why this value or a part of it is unknown; empty if all is known.
  Text whyUnknown() const;
};

/// The result of an operator ("+", "==", "and", ...). Unknown if an operand is unknown, or if the operands do not have
/// this operator.
Value binary(std::string_view sign, const Value& a, const Value& b);

}  // namespace hapticell::trajectory
