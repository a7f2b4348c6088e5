// SPDX-License-Identifier: Apache-2.0
#include "xacro/interpreter.h"

#include <algorithm>
#include <utility>

#include "xacro/methods.h"
#include "xacro/operators.h"

namespace hapticell::xacro {

namespace {

using Kind = Expression::Kind;

constexpr std::size_t kShownExpression = 120;

/// Where "$(" ends: at the first closing parenthesis, of "$(eval" at the one that belongs to it.
std::size_t endOfSubstitution(const std::string& text, std::size_t begin) {
  if (text.compare(begin, 7, "$(eval ") != 0) return text.find(')', begin);
  int open = 0;
  for (std::size_t i = begin + 1; i < text.size(); ++i) {
    if (text[i] == '(') ++open;
    if (text[i] == ')' && --open == 0) return i;
  }
  return std::string::npos;
}

}  // namespace

Value Interpreter::evaluateText(const std::string& text, Scope& scope) {
  budget_.step(1 + text.size() / 256);
  if (text.find('$') == std::string::npos) return text;
  const Budget::Level level(budget_, 4);
  std::vector<Value> parts;
  std::string plain;
  const auto add = [&](Value value) {
    if (!plain.empty()) parts.emplace_back(std::exchange(plain, {}));
    parts.push_back(std::move(value));
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t dollars = 0;
    while (i + dollars < text.size() && text[i + dollars] == '$') ++dollars;
    const char next = i + dollars < text.size() ? text[i + dollars] : '\0';
    if (dollars == 0 || (next != '{' && next != '(')) {
      plain.append(text, i, std::max<std::size_t>(dollars, 1));
      i += std::max<std::size_t>(dollars, 1);
      continue;
    }
    if (dollars > 1) {  // "$$" is how a "$" is written in front of a bracket.
      plain.append(text, i + 1, dollars);
      i += dollars + 1;
      continue;
    }
    const std::size_t end = next == '{' ? text.find('}', i) : endOfSubstitution(text, i);
    if (end == std::string::npos)
      throw Fault{.found = Text("'%1' without its end", text.substr(i, 40)), .expected = next == '{' ? "'}'" : "')'"};
    const std::string inside = text.substr(i + 2, end - i - 2);
    if (next == '{')
      add(evaluateExpression(textOfText(inside, scope), scope));
    else
      add(surroundings_.substitution(inside.starts_with("eval ") ? inside : textOfText(inside, scope), scope));
    i = end + 1;
  }
  if (!plain.empty()) parts.emplace_back(std::move(plain));
  if (parts.size() == 1) return std::move(parts[0]);
  std::string joined;
  for (const Value& part : parts) {
    joined += textOf(part, budget_);
    Budget::checkText(joined.size());
  }
  return budget_.text(joined);
}

Value Interpreter::evaluateExpression(const std::string& text, Scope& scope) {
  const Budget::Level level(budget_, 4);
  try {
    ExpressionPointer& parsed = parsed_[text];
    if (!parsed) {
      budget_.take(text.size() * 40);
      budget_.step(1 + text.size() / 8);
      parsed = parseExpression(text);
    }
    const ExpressionPointer kept = parsed;
    const Budget::Level inside(budget_, 1 + kept->depth / 4);
    Locals locals;
    return evaluate(*kept, scope, locals);
  } catch (Fault& fault) {
    if (!std::exchange(fault.names_expression, true))
      fault.found = Text("%1 in ${%2}", fault.found, text.substr(0, kShownExpression));
    throw;
  }
}

Value Interpreter::evaluate(const Expression& node, Scope& scope, Locals& locals) {
  budget_.step();
  const auto part = [&](std::size_t i) { return evaluate(*node.parts[i], scope, locals); };
  switch (node.kind) {
    case Kind::kConstant:
      return node.value;
    case Kind::kName:
      return nameOf(node.name, scope, locals);
    case Kind::kUnary:
      return unary(node.name, part(0));
    case Kind::kBinary: {
      const Value left = part(0);
      return binaryOperation(node.name, left, part(1), budget_);
    }
    case Kind::kAnd:
    case Kind::kOr: {
      Value value = part(0);
      for (std::size_t i = 1; i < node.parts.size() && truthOf(value) == (node.kind == Kind::kAnd); ++i)
        value = part(i);
      return value;
    }
    case Kind::kCompare:
      return compareAll(node, scope, locals);
    case Kind::kChoice:
      return truthOf(part(0)) ? part(1) : part(2);
    case Kind::kList:
    case Kind::kTuple:
      return sequenceOf(node, scope, locals);
    case Kind::kDict:
      return dictOf(node, scope, locals);
    case Kind::kAttribute:
      return attributeOf(part(0), node.name);
    case Kind::kIndex: {
      const Value value = part(0);
      return itemAt(value, part(1), budget_);
    }
    case Kind::kSlice: {
      Value ends[4];
      for (std::size_t i = 0; i < 4; ++i) ends[i] = node.parts[i] ? part(i) : Value();
      return sliceOf(ends[0], ends[1], ends[2], ends[3], budget_);
    }
    case Kind::kCall:
      return callOf(node, scope, locals);
    case Kind::kComprehension:
      return comprehensionOf(node, scope, locals);
    case Kind::kLambda:
      return lambdaOf(node, scope, locals);
  }
  return {};
}

Value Interpreter::nameOf(const std::string& name, Scope& scope, const Locals& locals) {
  for (auto local = locals.rbegin(); local != locals.rend(); ++local) {
    if (local->first == name) return local->second;
  }
  if (const Value* value = scope.find(name, *this)) return *value;
  throw Fault{.found = Text("name '%1' is not defined", name),
              .expected = "a property, a parameter or a function that xacro knows",
              .fix = "Correct the name, or define the property earlier in the file."};
}

Value Interpreter::attributeOf(const Value& value, const std::string& name) {
  if (Scope* const* name_space = value.as<Scope*>()) {
    if (const Value* inside = (*name_space)->find(name, *this)) return *inside;
    throw Fault{.found = Text("name '%1' is not defined in the namespace", name), .expected = "a defined name"};
  }
  if (auto method = methodOf(value, name)) return *method;
  if (const DictValue* dict = value.dict()) {
    if (const Value* item = dict->find(name)) return *item;
    throw Fault{.found = Text("the dictionary has no key '%1'", name), .expected = "a key of the dictionary"};
  }
  throw Fault{.found = Text("%1 has no function '%2'", kindOf(value), name),
              .expected = "a function that docs/user/formats.md lists"};
}

Value Interpreter::unary(const std::string& sign, const Value& value) {
  if (sign == "not") return !truthOf(value);
  if (sign == "~") return ~wholeOf(value);
  if (value.isWhole()) return sign == "-" ? binaryOperation("-", 0, value, budget_) : Value(wholeOf(value));
  return sign == "-" ? -numberOf(value) : numberOf(value);
}

bool Interpreter::holds(const std::string& sign, const Value& a, const Value& b) {
  if (sign == "==") return equal(a, b, budget_);
  if (sign == "!=") return !equal(a, b, budget_);
  if (sign == "is" || sign == "is not")
    return (a.data.index() == b.data.index() && equal(a, b, budget_)) == (sign == "is");
  if (sign == "in" || sign == "not in") {
    bool found = false;
    if (a.text() && b.text()) {
      budget_.step(1 + b.text()->size() / 64);
      found = b.text()->find(*a.text()) != std::string::npos;
    } else if (b.dict()) {
      found = b.dict()->find(a) != nullptr;
    } else if (b.list()) {
      for (const Value& item : b.list()->items) found = found || equal(a, item, budget_);
    } else {
      throw Fault{.found = Text("%1 in %2", kindOf(a), kindOf(b)),
                  .expected = "a list, a dictionary or a text after 'in'"};
    }
    return found == (sign == "in");
  }
  if (a.isNumber() && b.isNumber() && (numberOf(a) != numberOf(a) || numberOf(b) != numberOf(b))) return false;
  const int order = compare(a, b, budget_);
  if (sign == "<") return order < 0;
  if (sign == ">") return order > 0;
  return sign == "<=" ? order <= 0 : order >= 0;
}

Value Interpreter::compareAll(const Expression& node, Scope& scope, Locals& locals) {
  Value left = evaluate(*node.parts[0], scope, locals);
  for (std::size_t i = 0; i < node.names.size(); ++i) {
    Value right = evaluate(*node.parts[i + 1], scope, locals);
    if (!holds(node.names[i], left, right)) return false;
    left = std::move(right);
  }
  return true;
}

Value Interpreter::sequenceOf(const Expression& node, Scope& scope, Locals& locals) {
  std::vector<Value> items;
  for (const ExpressionPointer& part : node.parts) items.push_back(evaluate(*part, scope, locals));
  return makeList(std::move(items), budget_, node.kind == Kind::kTuple);
}

Value Interpreter::dictOf(const Expression& node, Scope& scope, Locals& locals) {
  std::vector<std::pair<Value, Value>> items;
  for (std::size_t i = 0; i + 1 < node.parts.size(); i += 2) {
    Value key = evaluate(*node.parts[i], scope, locals);
    items.emplace_back(std::move(key), evaluate(*node.parts[i + 1], scope, locals));
  }
  return makeDict(std::move(items), budget_);
}

Value Interpreter::callOf(const Expression& node, Scope& scope, Locals& locals) {
  const Value function = evaluate(*node.parts[0], scope, locals);
  std::vector<Value> arguments;
  std::map<std::string, Value> named;
  const std::size_t plain = node.parts.size() - node.names.size();
  for (std::size_t i = 1; i < node.parts.size(); ++i) {
    Value value = evaluate(*node.parts[i], scope, locals);
    if (i < plain)
      arguments.push_back(std::move(value));
    else
      named[node.names[i - plain]] = std::move(value);
  }
  return call(function, std::move(arguments), std::move(named));
}

Value Interpreter::call(const Value& function, std::vector<Value> arguments, std::map<std::string, Value> named) {
  const FunctionPointer* pointer = function.as<FunctionPointer>();
  if (!pointer) throw Fault{.found = Text("%1 used as a function", kindOf(function)), .expected = "a function"};
  budget_.step();
  const Budget::Level level(budget_, 4);
  const FunctionPointer kept = *pointer;
  Call call{*this, std::move(arguments), std::move(named)};
  return kept->run(call);
}

std::vector<Value> Interpreter::itemsOf(const Value& value) {
  std::vector<Value> items;
  if (const ListValue* list = value.list()) {
    items = list->items;
  } else if (const DictValue* dict = value.dict()) {
    for (const auto& [key, ignored] : dict->items) items.push_back(key);
  } else if (const std::string* text = value.text()) {
    Budget::checkList(text->size());
    for (std::string& letter : lettersOf(*text)) items.emplace_back(std::move(letter));
  } else {
    throw Fault{.found = Text("%1 instead of a list", kindOf(value)), .expected = "a list"};
  }
  budget_.step(items.size());
  return items;
}

Value Interpreter::comprehensionOf(const Expression& node, Scope& scope, Locals& locals) {
  std::vector<std::pair<Value, Value>> made;
  runClause(node, 0, scope, locals, made);
  if (node.dict) return makeDict(std::move(made), budget_);
  std::vector<Value> items;
  for (auto& [item, ignored] : made) items.push_back(std::move(item));
  return makeList(std::move(items), budget_);
}

void Interpreter::runClause(const Expression& node, std::size_t index, Scope& scope, Locals& locals,
                            std::vector<std::pair<Value, Value>>& made) {
  if (index == node.clauses.size()) {
    Value first = evaluate(*node.parts[0], scope, locals);
    made.emplace_back(std::move(first), node.dict ? evaluate(*node.parts[1], scope, locals) : Value());
    Budget::checkList(made.size());
    return;
  }
  const Expression::Clause& clause = node.clauses[index];
  const std::size_t before = locals.size();
  for (const Value& item : itemsOf(evaluate(*clause.source, scope, locals))) {
    const std::vector<Value> fields = clause.names.size() == 1 ? std::vector<Value>{item} : itemsOf(item);
    if (fields.size() != clause.names.size())
      throw Fault{.found = Text("%1 values for %2 names", fields.size(), clause.names.size()),
                  .expected = "the same number"};
    for (std::size_t i = 0; i < fields.size(); ++i) locals.emplace_back(clause.names[i], fields[i]);
    bool wanted = true;
    for (const ExpressionPointer& condition : clause.conditions)
      wanted = wanted && truthOf(evaluate(*condition, scope, locals));
    if (wanted) runClause(node, index + 1, scope, locals, made);
    locals.resize(before);
  }
}

Value Interpreter::lambdaOf(const Expression& node, Scope& scope, const Locals& locals) {
  const std::vector<std::string> names = node.names;
  const ExpressionPointer body = node.parts[0];
  budget_.take(256 + locals.size() * sizeof(Locals::value_type));
  int depth = 0;
  for (const auto& [name, value] : locals) depth = std::max(depth, depthOf(value));
  const auto run = [names, body, &scope, locals](Call& call) -> Value {
    if (call.arguments.size() != names.size() || !call.named.empty())
      throw Fault{.found = Text("a lambda of %1 parameters called with %2", names.size(), call.arguments.size()),
                  .expected = "the same number"};
    Locals inside = locals;
    for (std::size_t i = 0; i < names.size(); ++i) inside.emplace_back(names[i], call.arguments[i]);
    const Budget::Level level(call.interpreter.budget(), 1 + body->depth / 4);
    return call.interpreter.evaluate(*body, scope, inside);
  };
  return makeFunction("lambda", run, depth);
}

}  // namespace hapticell::xacro
