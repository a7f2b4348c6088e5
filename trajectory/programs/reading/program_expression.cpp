// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_expression.h"

#include <cmath>

namespace hapticell::trajectory {

namespace {

// Brackets within each other: guards the stack; programs have a few. Half: still enough; twice: twice the stack.
constexpr int kDeepest = 100;
// Items of a list: guards the memory; as kLongestList of program_run.cpp. Half, twice: longer arrays are read as
// unknown, or more memory is used.
constexpr std::size_t kMostItems = 200000;

/// Counts how deep expressions lie in each other.
class Depth {
 public:
  explicit Depth(int& depth) : depth_(++depth) {}
  ~Depth() { --depth_; }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;

 private:
  int& depth_;
};

}  // namespace

const Token& ExpressionReader::next() const {
  static const Token kEnd{};
  return at_ < tokens_.size() ? tokens_[at_] : kEnd;
}

bool ExpressionReader::take(std::string_view sign) {
  if (isAtEnd() || !next().is(sign)) return false;
  ++at_;
  return true;
}

Value ExpressionReader::expression() {
  const Depth depth(depth_);
  if (depth_ > kDeepest) {
    at_ = tokens_.size();
    return Value::unknown(Text("an expression with too many brackets"));
  }
  return either();
}

Value ExpressionReader::chain(Value (ExpressionReader::*operand)(), std::initializer_list<const char*> signs) {
  Value value = (this->*operand)();
  while (std::any_of(signs.begin(), signs.end(), [this](const char* sign) { return next().is(sign); })) {
    const std::string sign = tokens_[at_++].text;
    value = binary(sign, value, (this->*operand)());
  }
  return value;
}

Value ExpressionReader::either() {
  return chain(&ExpressionReader::both, {"or", "xor", "exor", "b_or", "b_exor"});
}

Value ExpressionReader::both() {
  Value value = negated();
  while (next().is("and") || next().is("b_and")) {
    ++at_;
    value = binary("and", value, negated());
  }
  return value;
}

Value ExpressionReader::negated() {
  bool is_negated = false;
  while (take("not")) is_negated = !is_negated;
  Value value = compared();
  if (!is_negated || !value.isKnown()) return value;
  return value.isNumber() ? Value::truth(value.number == 0.0)
                          : Value::unknown(Text("'not' of a value that is not true or false"));
}

Value ExpressionReader::compared() {
  Value value = sum();
  for (;;) {
    const std::string sign = next().kind == Token::Kind::kSign ? next().text : "";
    const bool is_equality = dialect_.has_equals_test ? sign == "==" : sign == "=";
    if (!is_equality && sign != "<>" && sign != "!=" && sign != "<" && sign != "<=" && sign != ">" && sign != ">=")
      return value;
    ++at_;
    value = binary(is_equality ? "==" : sign, value, sum());
  }
}

Value ExpressionReader::sum() {
  return chain(&ExpressionReader::product, {"+", "-"});
}

Value ExpressionReader::product() {
  return chain(&ExpressionReader::composed, {"*", "/", "%", "div", "mod"});
}

Value ExpressionReader::composed() {
  Value value = signedValue();
  while (meaning_.compose && take(":")) value = meaning_.compose(value, signedValue());
  return value;
}

Value ExpressionReader::signedValue() {
  bool is_negative = false;
  while (next().is("-") || next().is("+")) is_negative = (tokens_[at_++].text == "-") != is_negative;
  Value value = postfixed();
  return is_negative ? binary("*", value, Value::of(-1.0)) : value;
}

bool ExpressionReader::takeIndex(AccessStep& step) {
  if (!take(dialect_.has_braces_index ? "{" : "[")) return false;
  const char* closing = dialect_.has_braces_index ? "}" : "]";
  // KRL's name[] is the whole text.
  const Value index = next().is(closing) ? Value::unknown(Text("a text")) : expression();
  step.is_known = index.isNumber();
  step.index = index.number;
  if (!take(closing)) step.is_known = false;
  return true;
}

const Value* ExpressionReader::element(const Value& whole, const AccessStep& step) const {
  if (!step.field.empty()) return whole.find(step.field);
  const double place = step.index - static_cast<double>(dialect_.first_index);
  if (!step.is_known || whole.kind != Value::Kind::kList || !(place >= 0.0) ||
      !(place < static_cast<double>(whole.items.size()))) {
    return nullptr;
  }
  return &whole.items[static_cast<std::size_t>(place)];
}

/// A variable's parts are found without copying the whole: lists may have many thousand targets.
Value ExpressionReader::postfixed() {
  Value owned;
  const bool is_call = at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("(");
  const Value* value = next().isWord() && !is_call ? meaning_.find(next().text) : nullptr;
  if (value) {
    ++at_;
  } else {
    owned = primary();
    value = &owned;
  }
  for (;;) {
    AccessStep step;
    if (next().is(".") && at_ + 1 < tokens_.size() && tokens_[at_ + 1].isWord()) {
      step.field = tokens_[at_ + 1].text;
      at_ += 2;
    } else if (!takeIndex(step)) {
      return *value;
    }
    if (!value->isKnown()) continue;
    Value part;
    if (const Value* found = element(*value, step)) {
      if (value != &owned && found->isKnown()) {
        value = found;
        continue;
      }
      part = *found;
    } else {
      part = step.field.empty() ? Value::unknown(Text("an element beyond the end of the list"))
                                : meaning_.field(*value, step.field);
    }
    owned = std::move(part);
    value = &owned;
  }
}

Value ExpressionReader::primary() {
  if (isAtEnd()) return Value::unknown(Text("an expression that ends too early"));
  const Token token = tokens_[at_];
  if (token.kind == Token::Kind::kNumber) return ++at_, Value::of(token.number);
  if (token.kind == Token::Kind::kText) return ++at_, Value::word(token.text);
  if (token.isWord()) return ++at_, named(token.text);
  if (take("(")) {
    Value value = expression();
    take(")");
    return value;
  }
  if (take("[")) return listUntil("]", "");
  if (!dialect_.has_braces_index && take("{")) return record();
  ++at_;  // So that whoever asks again comes to an end.
  return Value::unknown(Text("'%1', which is not supported", token.text));
}

Value ExpressionReader::named(const std::string& name) {
  if (name == "true" || name == "True") return Value::truth(true);
  if (name == "false" || name == "False") return Value::truth(false);
  if (name.starts_with('#')) return Value::word(name);
  if (dialect_.has_poses && name == "p" && take("[")) return listUntil("]", "p");
  if (take("(")) {
    const Depth depth(depth_);
    if (depth_ > kDeepest) return at_ = tokens_.size(), Value::unknown(Text("too many brackets"));
    const auto given = arguments();
    return meaning_.call(name, given);
  }
  return meaning_.variable(name);
}

Value ExpressionReader::listUntil(const char* closing, std::string type) {
  Value list = Value::list(std::move(type), std::vector<Value>{});
  while (!isAtEnd() && !take(closing)) {
    if (take(",")) continue;
    if (list.items.size() >= kMostItems) return Value::unknown(Text("a list that is too long"));
    list.items.push_back(expression());
  }
  return list;
}

/// KRL: {X 1.0,Y 2.0}, {E6POS: X 1.0}, {POINT2[] "text"}.
Value ExpressionReader::record() {
  const Depth depth(depth_);
  if (depth_ > kDeepest) return at_ = tokens_.size(), Value::unknown(Text("too many brackets"));
  Value result{Value::Kind::kRecord, 0.0, {}, {}, {}};
  if (next().isWord() && at_ + 1 < tokens_.size() && tokens_[at_ + 1].is(":")) {
    result.text = next().text;
    at_ += 2;
  }
  while (!isAtEnd() && !take("}")) {
    if (take(",")) continue;
    if (!next().isWord() || result.items.size() >= kMostItems) {
      ++at_;
      continue;
    }
    const std::string field = tokens_[at_++].text;
    AccessStep index;
    takeIndex(index);
    result.fields.push_back(field);
    result.items.push_back(signedValue());
  }
  return result;
}

std::string ExpressionReader::path(std::vector<AccessStep>& steps) {
  if (isAtEnd() || !next().isWord()) return {};
  const std::string name = tokens_[at_++].text;
  for (;;) {
    AccessStep step;
    if (next().is(".") && at_ + 1 < tokens_.size() && tokens_[at_ + 1].isWord()) {
      step.field = tokens_[at_ + 1].text;
      at_ += 2;
    } else if (!takeIndex(step)) {
      return name;
    }
    steps.push_back(std::move(step));
  }
}

std::vector<Argument> ExpressionReader::arguments() {
  std::vector<Argument> given;
  bool is_expected = true;  // "f(a,,b)" has an argument that is left out
  while (!isAtEnd() && !take(")") && !next().is("@pose") && given.size() < kMostItems) {
    if (take(",")) {
      if (is_expected) given.push_back({"", Value::unknown(Text("a missing argument"))});
      is_expected = true;
      continue;
    }
    is_expected = false;
    const bool is_next_known = at_ + 1 < tokens_.size();
    if (take("\\")) {
      Argument argument{isAtEnd() ? "" : next().text, Value::truth(true)};
      if (!isAtEnd()) ++at_;
      if (take(":=")) argument.value = expression();
      // "Move\Conc,p1": the comma behind a switch stands for nothing.
      given.push_back(std::move(argument));
    } else if (dialect_.has_poses && is_next_known && next().isWord() && tokens_[at_ + 1].is("=")) {
      const std::string name = next().text;
      at_ += 2;
      given.push_back({name, expression()});
    } else {
      given.push_back({"", expression()});
    }
  }
  return given;
}

}  // namespace hapticell::trajectory
