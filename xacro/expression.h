// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "xacro/value.h"

namespace hapticell::xacro {

/// A node of a parsed expression. The meaning of the fields depends on the kind.
struct Expression {
  enum class Kind {
    kConstant,       ///< value
    kName,           ///< name
    kUnary,          ///< name: - + ~ not; parts[0]
    kBinary,         ///< name: + - * / // % ** << >> & | ^; parts[0], parts[1]
    kAnd,            ///< parts
    kOr,             ///< parts
    kCompare,        ///< parts[0], then for each of names one more
    kChoice,         ///< parts: condition, then, else
    kList,           ///< parts
    kTuple,          ///< parts
    kDict,           ///< parts: key, value, key, value …
    kAttribute,      ///< parts[0] . name
    kIndex,          ///< parts[0] [ parts[1] ]
    kSlice,          ///< parts[0] [ parts[1] : parts[2] : parts[3] ]; null where left out
    kCall,           ///< parts[0] ( parts[1] … ), of which the last names.size() are named by names
    kComprehension,  ///< parts[0] (and for a dictionary parts[1]) for names in parts[…] if parts[…]: see clauses
    kLambda,         ///< names: parameters; parts[0]
  };
  /// One "for names in source if condition …" of a comprehension.
  struct Clause {
    std::vector<std::string> names;
    std::shared_ptr<const Expression> source;
    std::vector<std::shared_ptr<const Expression>> conditions;
  };
  Kind kind = Kind::kConstant;
  std::string name;
  Value value;
  std::vector<std::string> names;
  std::vector<std::shared_ptr<const Expression>> parts;
  std::vector<Clause> clauses;
  bool dict = false;  ///< A comprehension makes a dictionary.
  int depth = 1;      ///< Levels below and with it.
};
using ExpressionPointer = std::shared_ptr<const Expression>;

/// Parses an expression in the part of Python's language that has no statements: literals, lists, tuples, dictionaries,
/// arithmetic, comparisons, and/or/not, a if b else c, indices and slices, attributes, calls, lambda and
/// comprehensions. Fault if it is invalid, uses another part of the language, is over 64 kB, or nests deeper than 100
/// levels.
ExpressionPointer parseExpression(const std::string& text);

/// True for a name that may be given to a property: a word of letters, digits and _ that is no keyword of Python.
bool isIdentifier(const std::string& name);

}  // namespace hapticell::xacro
