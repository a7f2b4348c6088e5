// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_value.h"

#include <cmath>

namespace hapticell::trajectory {

namespace {

Value arithmetic(std::string_view sign, double a, double b) {
  if (sign == "+") return Value::of(a + b);
  if (sign == "-") return Value::of(a - b);
  if (sign == "*") return Value::of(a * b);
  if (b == 0.0) return Value::unknown(Text("a division by 0"));
  if (sign == "/") return Value::of(a / b);
  if (sign == "div") return Value::of(std::trunc(a / b));
  return Value::of(std::fmod(a, b));  // mod, %
}

std::optional<bool> comparison(std::string_view sign, double a, double b) {
  if (sign == "==") return a == b;
  if (sign == "<>" || sign == "!=") return a != b;
  if (sign == "<") return a < b;
  if (sign == "<=") return a <= b;
  if (sign == ">") return a > b;
  if (sign == ">=") return a >= b;
  if (sign == "and" || sign == "b_and") return a != 0.0 && b != 0.0;
  if (sign == "or" || sign == "b_or") return a != 0.0 || b != 0.0;
  if (sign == "xor" || sign == "exor" || sign == "b_exor") return (a != 0.0) != (b != 0.0);
  return std::nullopt;
}

/// Sums of vectors, and a vector times a number (RAPID's pos).
Value ofLists(std::string_view sign, const Value& a, const Value& b) {
  const bool is_sum = sign == "+" || sign == "-";
  if (a.kind == Value::Kind::kList && b.kind == Value::Kind::kList) {
    if (is_sum && a.items.size() == b.items.size()) {
      Value result = a;
      for (std::size_t i = 0; i < a.items.size(); ++i) result.items[i] = binary(sign, a.items[i], b.items[i]);
      return result;
    }
    const auto p = a.numbers(4), q = b.numbers(4);
    if (sign == "*" && p && q) {
      const dquat product = dquat((*p)[0], (*p)[1], (*p)[2], (*p)[3]) * dquat((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
      return Value::list("orient", {product.w, product.x, product.y, product.z});
    }
    return Value::unknown(Text("operator '%1' between lists", sign));
  }
  const Value& list = a.kind == Value::Kind::kList ? a : b;
  const Value& number = a.kind == Value::Kind::kList ? b : a;
  if (!number.isNumber() || (sign != "*" && !(sign == "/" && &list == &a))) {
    return Value::unknown(Text("operator '%1' on a list", sign));
  }
  Value result = list;
  for (Value& item : result.items) item = binary(sign, item, number);
  return result;
}

}  // namespace

Value Value::list(std::string type, const std::vector<double>& numbers) {
  Value result{Kind::kList, 0.0, std::move(type), {}, {}};
  for (const double number : numbers) result.items.push_back(of(number));
  return result;
}

const Value* Value::find(std::string_view field) const {
  for (std::size_t i = 0; i < fields.size() && i < items.size(); ++i)
    if (fields[i] == field) return &items[i];
  return nullptr;
}

std::optional<double> Value::numberOf(std::string_view field) const {
  const Value* value = find(field);
  return value && value->isNumber() ? std::optional(value->number) : std::nullopt;
}

std::optional<std::vector<double>> Value::numbers(std::size_t count) const {
  if (kind != Kind::kList || items.size() != count) return std::nullopt;
  std::vector<double> result;
  for (const Value& item : items) {
    if (!item.isNumber()) return std::nullopt;
    result.push_back(item.number);
  }
  return result;
}

Text Value::whyUnknown() const {
  if (kind == Kind::kUnknown) return why.empty() ? Text("a value that the file does not define") : why;
  for (const Value& item : items)
    if (Text of_item = item.whyUnknown(); !of_item.empty()) return of_item;
  return {};
}

Value binary(std::string_view sign, const Value& a, const Value& b) {
  if (!a.isKnown()) return a;
  if (!b.isKnown()) return b;
  if (a.kind == Value::Kind::kList || b.kind == Value::Kind::kList) return ofLists(sign, a, b);
  if (a.kind == Value::Kind::kText && b.kind == Value::Kind::kText) {
    if (sign == "==") return Value::truth(a.text == b.text);
    if (sign == "<>" || sign == "!=") return Value::truth(a.text != b.text);
  }
  if (!a.isNumber() || !b.isNumber()) return Value::unknown(Text("operator '%1', which is not supported", sign));
  if (const auto truth = comparison(sign, a.number, b.number)) return Value::truth(*truth);
  return arithmetic(sign, a.number, b.number);
}

}  // namespace hapticell::trajectory
