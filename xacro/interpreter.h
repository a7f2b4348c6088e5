// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "xacro/budget.h"
#include "xacro/expression.h"
#include "xacro/scope.h"
#include "xacro/value.h"

namespace hapticell::xacro {

/// Provides $(…) and those functions of xacro that access files: implemented by the expander.
class Surroundings {
 public:
  virtual ~Surroundings() = default;
  /// The value of "find NAME", "arg NAME" and so on. Fault for what is not known.
  virtual Value substitution(const std::string& words, Scope& scope) = 0;
  /// xacro.load_yaml: the text of a file, found as an include is.
  virtual std::string readText(const std::string& reference, std::string& file) = 0;
  virtual std::string absoluteName(const std::string& reference) = 0;
  virtual Value argument(const std::string& name) = 0;
  virtual void warn(const Text& sentence) = 0;
};

/// Evaluates texts with ${…} and $(…), and the expressions in them.
///
/// It runs no code of the file: names lead to properties and to the functions of built_ins.h and to nothing else,
/// attributes to items of dictionaries and to the methods listed in methods.h; no value knows its class, its module or
/// the program. Every evaluation is charged to the budget.
class Interpreter {
 public:
  Interpreter(Budget& budget, Surroundings& surroundings) : budget_(budget), surroundings_(surroundings) {}

  Budget& budget() { return budget_; }
  Surroundings& surroundings() { return surroundings_; }

  /// A text as attributes have it: of one ${…} or $(…) its value, else the whole as a text.
  Value evaluateText(const std::string& text, Scope& scope);
  std::string textOfText(const std::string& text, Scope& scope) { return textOf(evaluateText(text, scope), budget_); }
  Value evaluateExpression(const std::string& text, Scope& scope);
  /// Calls a function value; Fault if the value is not a function.
  Value call(const Value& function, std::vector<Value> arguments, std::map<std::string, Value> named = {});
  /// What a "for" goes through: items of lists, keys of dictionaries, letters of texts.
  std::vector<Value> itemsOf(const Value& value);

 private:
  /// Names bound by comprehensions and lambdas, innermost last.
  using Locals = std::vector<std::pair<std::string, Value>>;

  Value evaluate(const Expression& node, Scope& scope, Locals& locals);
  Value nameOf(const std::string& name, Scope& scope, const Locals& locals);
  Value attributeOf(const Value& value, const std::string& name);
  Value unary(const std::string& sign, const Value& value);
  Value compareAll(const Expression& node, Scope& scope, Locals& locals);
  bool holds(const std::string& sign, const Value& a, const Value& b);
  Value callOf(const Expression& node, Scope& scope, Locals& locals);
  Value comprehensionOf(const Expression& node, Scope& scope, Locals& locals);
  void runClause(const Expression& node, std::size_t clause, Scope& scope, Locals& locals,
                 std::vector<std::pair<Value, Value>>& made);
  Value lambdaOf(const Expression& node, Scope& scope, const Locals& locals);
  Value sequenceOf(const Expression& node, Scope& scope, Locals& locals);
  Value dictOf(const Expression& node, Scope& scope, Locals& locals);

  Budget& budget_;
  Surroundings& surroundings_;
  std::map<std::string, ExpressionPointer> parsed_;
};

}  // namespace hapticell::xacro
