// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "xacro/value.h"

namespace hapticell::xacro {

/// a + b and so on, as Python has them: / of whole numbers is a number, // and % go down, + joins texts and lists,
/// * repeats them, % fills "%d" and the like. Fault for kinds that do not go together, division by zero, whole numbers
/// beyond 64 bits and what the budget does not allow.
Value binaryOperation(const std::string& sign, const Value& a, const Value& b, Budget& budget);

/// value[index] and value[first:last:step]; None where left out.
Value itemAt(const Value& value, const Value& index, Budget& budget);
Value sliceOf(const Value& value, const Value& first, const Value& last, const Value& step, Budget& budget);

/// Letters of UTF-8.
std::vector<std::string> lettersOf(const std::string& text);

}  // namespace hapticell::xacro
