// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "trajectory/programs/reading/program_tokens.h"
#include "trajectory/programs/reading/program_value.h"

namespace hapticell::trajectory {

/// One argument of a call; named in RAPID (\Rx:=5, or a switch \Off) and URScript (a=1.2).
struct Argument {
  std::string name;
  Value value;
};

/// A step into a variable: a field, or an index as written in the text.
struct AccessStep {
  std::string field;  ///< Empty for an index.
  double index = 0.0;
  bool is_known = true;
};

/// The meaning of names in expressions, defined by the language.
struct ExpressionMeaning {
  /// A variable's value; null if the file gives none (then `variable` is called). It must stay valid while an
  /// expression is read.
  std::function<const Value*(const std::string& name)> find;
  /// A built-in name of the language, or the reason why it is unknown.
  std::function<Value(const std::string& name)> variable;
  std::function<Value(const std::string& name, const std::vector<Argument>& arguments)> call;
  /// A field of a value that is not a record.
  std::function<Value(const Value& whole, const std::string& field)> field;
  std::function<Value(const Value& a, const Value& b)> compose;  ///< KRL's ':'; may be empty.
};

/// Reads expressions of KRL, RAPID and URScript from tokens and evaluates them immediately.
///
/// Stops before the first token that cannot belong to the expression. Invalid expressions give an unknown value.
class ExpressionReader {
 public:
  ExpressionReader(const Tokens& tokens, std::size_t at, const Dialect& dialect, const ExpressionMeaning& meaning)
      : tokens_(tokens), at_(at), dialect_(dialect), meaning_(meaning) {}

  Value expression();
  /// The target of a KRL motion: without comparison and sum, so that what follows the target is not read as part of it.
  Value term() { return composed(); }
  /// "name", "name.field", "name[2].x": for assignments. An empty name if there is no path.
  std::string path(std::vector<AccessStep>& steps);
  /// Arguments up to a closing bracket (which is consumed) or the end of the statement.
  std::vector<Argument> arguments();

  std::size_t at() const { return at_; }
  bool isAtEnd() const { return at_ >= tokens_.size() || tokens_[at_].kind == Token::Kind::kLineEnd; }
  const Token& next() const;
  bool take(std::string_view sign);

 private:
  /// Operands joined by one of the operators, from left to right: a - b + c.
  Value chain(Value (ExpressionReader::*operand)(), std::initializer_list<const char*> signs);
  Value either();
  Value both();
  Value negated();
  Value compared();
  Value sum();
  Value product();
  Value composed();
  Value signedValue();
  Value postfixed();
  Value primary();
  Value named(const std::string& name);
  Value record();
  Value listUntil(const char* closing, std::string type);
  bool takeIndex(AccessStep& step);
  const Value* element(const Value& whole, const AccessStep& step) const;

  const Tokens& tokens_;
  std::size_t at_;
  const Dialect& dialect_;
  const ExpressionMeaning& meaning_;
  int depth_ = 0;
};

}  // namespace hapticell::trajectory
