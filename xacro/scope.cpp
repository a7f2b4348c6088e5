// SPDX-License-Identifier: Apache-2.0
#include "xacro/scope.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include "geometry/system/text_case.h"
#include "xacro/interpreter.h"

namespace hapticell::xacro {

namespace {

std::string trimmed(const std::string& text) {
  const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
  const auto begin = std::find_if_not(text.begin(), text.end(), blank);
  const auto end = std::find_if_not(text.rbegin(), std::make_reverse_iterator(begin), blank).base();
  return {begin, end};
}

/// Without its sign, which from_chars() does not take in front of a plus.
std::pair<std::string, bool> unsignedText(const std::string& text) {
  std::string rest = trimmed(text);
  const bool negative = !rest.empty() && rest[0] == '-';
  if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.erase(0, 1);
  return {rest, negative};
}

/// A property that is being evaluated.
class InWork {
 public:
  InWork(std::vector<std::string>& names, const std::string& name) : names_(names) { names_.push_back(name); }
  ~InWork() { names_.pop_back(); }
  InWork(const InWork&) = delete;
  InWork& operator=(const InWork&) = delete;

 private:
  std::vector<std::string>& names_;
};

}  // namespace

std::optional<std::int64_t> wholeFromText(const std::string& text) {
  const auto [digits, negative] = unsignedText(text);
  if (digits.empty() || digits[0] < '0' || digits[0] > '9') return std::nullopt;
  const std::string whole_text = (negative ? "-" : "") + digits;
  std::int64_t whole = 0;
  const auto [end, problem] = std::from_chars(whole_text.data(), whole_text.data() + whole_text.size(), whole);
  return problem == std::errc() && end == whole_text.data() + whole_text.size() ? std::optional(whole) : std::nullopt;
}

std::optional<double> numberFromText(const std::string& text) {
  auto [digits, negative] = unsignedText(text);
  digits = lowerCase(digits);
  const double sign = negative ? -1.0 : 1.0;
  if (digits == "inf" || digits == "infinity") return sign * std::numeric_limits<double>::infinity();
  if (digits == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (digits.empty() || (digits[0] != '.' && (digits[0] < '0' || digits[0] > '9'))) return std::nullopt;
  double value = 0.0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size()) return std::nullopt;
  if (problem == std::errc::result_out_of_range)
    value = digits.find("e-") == std::string::npos ? std::numeric_limits<double>::infinity() : 0.0;
  return problem == std::errc::invalid_argument ? std::nullopt : std::optional(sign * value);
}

Value literalOf(const std::string& text) {
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') return text.substr(1, text.size() - 2);
  if (text.find('_') != std::string::npos) return text;
  if (const auto whole = wholeFromText(text)) return *whole;
  if (const auto number = numberFromText(text)) return *number;
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  return text;
}

bool conditionOf(const Value& value, const std::string& written) {
  const std::string* text = value.text();
  if (!text) return truthOf(value);
  if (*text == "true" || *text == "True") return true;
  if (*text == "false" || *text == "False") return false;
  if (const auto whole = wholeFromText(*text)) return *whole != 0;
  throw Fault{.found = Text("the condition \"%1\", which gives \"%2\"", written.substr(0, 100), text->substr(0, 100)),
              .expected = "true, false, or a number"};
}

bool Scope::holds(const std::string& name) const {
  for (const Scope* scope = this; scope; scope = scope->parent_) {
    if (scope->values_.count(name)) return true;
  }
  return false;
}

const Value* Scope::find(const std::string& name, Interpreter& interpreter) {
  for (Scope* scope = this; scope; scope = scope->parent_) {
    const auto found = scope->values_.find(name);
    if (found == scope->values_.end()) continue;
    if (!scope->unevaluated_.count(name)) return &found->second;
    if (std::find(scope->in_work_.begin(), scope->in_work_.end(), name) != scope->in_work_.end()) {
      std::string circle;
      for (const std::string& step : scope->in_work_) circle += step + " -> ";
      throw Fault{.found = Text("the property '%1' depends on itself (%2)", name, circle.substr(0, 300) + name),
                  .expected = "properties that do not depend on themselves",
                  .fix = "Correct it, or set lazy_eval=\"false\" to evaluate it where it is defined."};
    }
    const InWork mark(scope->in_work_, name);
    const std::string text = *found->second.text();
    Value value = interpreter.evaluateText(text, *scope);
    if (const std::string* result = value.text()) value = literalOf(*result);
    scope->unevaluated_.erase(name);
    return &(scope->values_[name] = std::move(value));
  }
  return nullptr;
}

void Scope::set(const std::string& name, Value value, bool text_is_expression) {
  if (const std::string* text = value.text()) value = literalOf(std::string(*text));
  if (text_is_expression && value.text())
    unevaluated_.insert(name);
  else
    unevaluated_.erase(name);
  values_[name] = std::move(value);
}

void Scope::remove(const std::string& name) {
  for (Scope* scope = this; scope->parent_; scope = scope->parent_) {
    scope->values_.erase(name);
    scope->unevaluated_.erase(name);
  }
}

Scope& Scope::top() {
  Scope* scope = this;
  while (scope->parent_ && scope->parent_->parent_) scope = scope->parent_;
  return *scope;
}

}  // namespace hapticell::xacro
