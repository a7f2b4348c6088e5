// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "xacro/value.h"

namespace hapticell::xacro {

/// Names and values of properties, and the enclosing scope. A text is evaluated when it is first asked for, in the
/// scope that holds it. Scopes belong to a Scopes.
class Scope {
 public:
  Scope(Scope* parent, bool name_space) : parent_(parent), name_space_(name_space) {}

  /// Looks here and in the enclosing scopes; empty: not known. Fault where its text cannot be evaluated or needs
  /// itself.
  const Value* find(const std::string& name, Interpreter& interpreter);
  bool holds(const std::string& name) const;
  /// `text_is_expression`: a text is evaluated later, at its first use, else it is one.
  void set(const std::string& name, Value value, bool text_is_expression);
  /// Here and in all scopes around but the outermost.
  void remove(const std::string& name);

  Scope* parent() const { return parent_; }
  bool isNameSpace() const { return name_space_; }
  /// The outermost scope of the file: below the one with the functions.
  Scope& top();

 private:
  Scope* parent_;
  bool name_space_;
  std::map<std::string, Value> values_;
  std::set<std::string> unevaluated_;
  std::vector<std::string> in_work_;
};

/// Owns all scopes of one expansion: values refer to them.
class Scopes {
 public:
  Scope& make(Scope* parent, bool name_space = false) { return scopes_.emplace_back(parent, name_space); }

 private:
  std::deque<Scope> scopes_;
};

/// A text as a property has it: a whole number, a number or a truth where it reads as one (with a _ in it: never), the
/// inside of 'a text in quotes', else the text.
Value literalOf(const std::string& text);

/// The truth value of a condition: the texts true and false, and whole numbers; other kinds as in Python. Fault for
/// other texts.
bool conditionOf(const Value& value, const std::string& written);

/// Reads numbers like Python's int() and float(), with blanks around them; empty if the text is not a number.
std::optional<std::int64_t> wholeFromText(const std::string& text);
std::optional<double> numberFromText(const std::string& text);

}  // namespace hapticell::xacro
