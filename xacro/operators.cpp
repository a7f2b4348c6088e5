// SPDX-License-Identifier: Apache-2.0
#include "xacro/operators.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>

#include "geometry/system/utf8.h"

namespace hapticell::xacro {

namespace {

[[noreturn]] void tooLarge() {
  throw Fault{
      .found = "a whole number beyond 64 bits", .expected = "a smaller one", .fix = "Write it with a decimal point."};
}

[[noreturn]] void mismatched(const std::string& sign, const Value& a, const Value& b) {
  throw Fault{
      .found = Text("%1 %2 %3", kindOf(a), sign, kindOf(b)),
      .expected = "two numbers",
      .fix = a.text() || b.text() ? Text("If a property is a text here, check it for a mistyped number.") : Text()};
}

std::int64_t wholePower(std::int64_t base, std::int64_t exponent) {
  std::int64_t result = 1;
  if (exponent == 0 || (base == -1 && exponent % 2 == 0)) return 1;
  if (base == 1 || base == 0 || base == -1) return base;
  for (std::int64_t i = 0; i < exponent; ++i) {  // Overflows after 63 steps.
    if (__builtin_mul_overflow(result, base, &result)) tooLarge();
  }
  return result;
}

std::int64_t floorDivision(std::int64_t a, std::int64_t b) {
  if (b == 0) throw Fault{.found = "a division by zero", .expected = "a divisor other than 0"};
  if (b == -1) {
    if (a == std::numeric_limits<std::int64_t>::min()) tooLarge();
    return -a;
  }
  const std::int64_t quotient = a / b;
  return quotient - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

std::optional<Value> wholeOperation(const std::string& sign, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  bool fits = true;
  if (sign == "+") {
    fits = !__builtin_add_overflow(a, b, &result);
  } else if (sign == "-") {
    fits = !__builtin_sub_overflow(a, b, &result);
  } else if (sign == "*") {
    fits = !__builtin_mul_overflow(a, b, &result);
  } else if (sign == "//") {
    result = floorDivision(a, b);
  } else if (sign == "%") {
    if (b == 0) throw Fault{.found = "a division by zero", .expected = "a divisor other than 0"};
    result = b == -1 ? 0 : a - b * floorDivision(a, b);
  } else if (sign == "**" && b >= 0) {
    result = wholePower(a, b);
  } else if (sign == "|") {
    result = a | b;
  } else if (sign == "&") {
    result = a & b;
  } else if (sign == "^") {
    result = a ^ b;
  } else if (sign == "<<" || sign == ">>") {
    if (b < 0 || b > 62) throw Fault{.found = Text("a bit shift by %1", b), .expected = "0 to 62"};
    if (sign == ">>") return Value(a >> b);
    fits = !__builtin_mul_overflow(a, std::int64_t{1} << b, &result);
  } else {
    return std::nullopt;
  }
  if (!fits) tooLarge();
  return Value(result);
}

Value numberOperation(const std::string& sign, double a, double b, const Value& left, const Value& right) {
  if (sign == "+") return a + b;
  if (sign == "-") return a - b;
  if (sign == "*") return a * b;
  if (sign == "/" || sign == "//" || sign == "%") {
    if (b == 0.0) throw Fault{.found = "a division by zero", .expected = "a divisor other than 0"};
    if (sign == "/") return a / b;
    double rest = std::fmod(a, b);
    if (rest != 0.0 && (rest < 0.0) != (b < 0.0)) rest += b;
    if (sign == "%") return rest == 0.0 ? std::copysign(0.0, b) : rest;
    const double quotient = (a - rest) / b;
    return quotient == 0.0 ? std::copysign(0.0, a / b) : std::round(quotient);
  }
  if (sign == "**") {
    const double result = std::pow(a, b);
    if ((a == 0.0 && b < 0.0) || (std::isnan(result) && !std::isnan(a) && !std::isnan(b)))
      throw Fault{.found = Text("a power that is not a number (%1 ** %2)", numberText(a), numberText(b)),
                  .expected = "a number"};
    if (std::isinf(result) && std::isfinite(a) && std::isfinite(b))
      throw Fault{.found = "a power that is too large", .expected = "a number"};
    return result;
  }
  mismatched(sign, left, right);
}

Value repeated(const Value& value, std::int64_t count, Budget& budget) {
  const std::size_t times = static_cast<std::size_t>(std::clamp<std::int64_t>(count, 0, 1 << 30));
  if (const std::string* text = value.text()) {
    Budget::checkText(text->size() * times);
    std::string result;
    for (std::size_t i = 0; i < (text->empty() ? 0 : times); ++i) result += *text;
    return budget.text(result);
  }
  const ListValue& list = *value.list();
  Budget::checkList(list.items.size() * times);
  std::vector<Value> items;
  for (std::size_t i = 0; i < (list.items.empty() ? 0 : times); ++i)
    items.insert(items.end(), list.items.begin(), list.items.end());
  budget.step(items.size());
  return makeList(std::move(items), budget, list.tuple);
}

/// One "%…" of a text that is filled; `spec` without its letter, at most eight signs.
std::string filled(const std::string& spec, char letter, const Value& value, Budget& budget) {
  if (letter == 's') return textOf(value, budget);
  if (letter == 'r') return reprOf(value, budget);
  char buffer[512];
  if (letter == 'd' || letter == 'i' || letter == 'x') {
    const std::int64_t whole =
        value.isWhole() ? wholeOf(value) : static_cast<std::int64_t>(std::clamp(numberOf(value), -9e18, 9e18));
    std::snprintf(buffer, sizeof buffer, ("%" + spec + "ll" + letter).c_str(), static_cast<long long>(whole));
  } else {
    std::snprintf(buffer, sizeof buffer, ("%" + spec + letter).c_str(), numberOf(value));
  }
  return buffer;
}

Value filledText(const std::string& pattern, const Value& values, Budget& budget) {
  std::vector<Value> rest = values.list() && values.list()->tuple ? values.list()->items : std::vector<Value>{values};
  std::reverse(rest.begin(), rest.end());
  std::string result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      result += pattern[i];
      continue;
    }
    const std::size_t end = pattern.find_first_not_of("0123456789.+- #", i + 1);
    if (end == std::string::npos || end - i > 8)
      throw Fault{.found = "an invalid '%' in a format text", .expected = "%d, %s, %.3f"};
    const std::string spec = pattern.substr(i + 1, end - i - 1);
    const char letter = pattern[i = end];
    if (letter == '%') {
      result += '%';
      continue;
    }
    if (std::string("dixsrfFeEgG").find(letter) == std::string::npos)
      throw Fault{.found = Text("'%1' in a format text", std::string{'%', letter}), .expected = "%d, %s, %.3f"};
    const std::size_t digit = spec.find_first_of("123456789");
    const unsigned long width = digit == std::string::npos ? 0 : std::strtoul(spec.c_str() + digit, nullptr, 10);
    const std::size_t point = spec.find('.');
    if (width > 99 || (point != std::string::npos && spec.size() - point > 3))
      throw Fault{.found = "a '%' with more than two digits", .expected = "%.3f"};
    if (rest.empty())
      throw Fault{.found = "a format text with more % places than values", .expected = "one value for each %"};
    result += filled(spec, letter, rest.back(), budget);
    rest.pop_back();
    Budget::checkText(result.size());
  }
  return budget.text(result);
}

std::size_t placeOf(const Value& index, std::size_t size) {
  const std::int64_t given = wholeOf(index);
  const std::int64_t place = given < 0 ? given + static_cast<std::int64_t>(size) : given;
  if (place < 0 || place >= static_cast<std::int64_t>(size))
    throw Fault{.found = Text("the index %1 of %2 items", given, size), .expected = "an index within the range"};
  return static_cast<std::size_t>(place);
}

std::vector<std::size_t> placesOf(const Value& first, const Value& last, const Value& step, std::size_t size) {
  const auto given = [](const Value& value) { return value.as<std::monostate>() == nullptr; };
  const std::int64_t by = given(step) ? wholeOf(step) : 1, count = static_cast<std::int64_t>(size);
  if (by == 0) throw Fault{.found = "a slice with a step of 0", .expected = "a step other than 0"};
  const std::int64_t low = by > 0 ? 0 : -1, high = by > 0 ? count : count - 1;
  const auto place = [&](const Value& value, std::int64_t otherwise) {
    if (!given(value)) return otherwise;
    const std::int64_t at = wholeOf(value);
    return std::clamp(at < 0 ? std::max<std::int64_t>(at, -count - 1) + count : at, low, high);
  };
  std::vector<std::size_t> places;
  const std::int64_t begin = place(first, by > 0 ? low : high), end = place(last, by > 0 ? high : low);
  for (std::int64_t at = begin; by > 0 ? at < end : at > end;) {
    places.push_back(static_cast<std::size_t>(at));
    if (by > count || by < -count) break;
    at += by;
  }
  return places;
}

}  // namespace

std::vector<std::string> lettersOf(const std::string& text) {
  std::vector<std::string> letters;
  for (const char c : text) {
    if (continuesCharacter(c) && !letters.empty())
      letters.back() += c;
    else
      letters.emplace_back(1, c);
  }
  return letters;
}

Value binaryOperation(const std::string& sign, const Value& a, const Value& b, Budget& budget) {
  if (a.isWhole() && b.isWhole()) {
    if (a.as<bool>() && b.as<bool>()) {
      const bool left = *a.as<bool>(), right = *b.as<bool>();
      if (sign == "|") return left || right;
      if (sign == "&") return left && right;
      if (sign == "^") return left != right;
    }
    if (auto whole = wholeOperation(sign, wholeOf(a), wholeOf(b))) return *whole;
  }
  if (a.isNumber() && b.isNumber()) return numberOperation(sign, numberOf(a), numberOf(b), a, b);
  if (sign == "%" && a.text()) return filledText(*a.text(), b, budget);
  if (sign == "+" && a.text() && b.text()) {
    Budget::checkText(a.text()->size() + b.text()->size());
    return budget.text(*a.text() + *b.text());
  }
  if (sign == "+" && a.list() && b.list() && a.list()->tuple == b.list()->tuple) {
    std::vector<Value> items = a.list()->items;
    items.insert(items.end(), b.list()->items.begin(), b.list()->items.end());
    budget.step(items.size());
    return makeList(std::move(items), budget, a.list()->tuple);
  }
  if (sign == "*" && (a.text() || a.list()) && b.isWhole()) return repeated(a, wholeOf(b), budget);
  if (sign == "*" && (b.text() || b.list()) && a.isWhole()) return repeated(b, wholeOf(a), budget);
  mismatched(sign, a, b);
}

Value itemAt(const Value& value, const Value& index, Budget& budget) {
  if (const DictValue* dict = value.dict()) {
    if (const Value* item = dict->find(index)) return *item;
    throw Fault{.found = Text("the dictionary has no key %1", reprOf(index, budget).substr(0, 80)),
                .expected = "a key of the dictionary"};
  }
  if (const ListValue* list = value.list()) return list->items[placeOf(index, list->items.size())];
  if (const std::string* text = value.text()) {
    budget.step(1 + text->size() / 64);
    const std::vector<std::string> letters = lettersOf(*text);
    return letters[placeOf(index, letters.size())];
  }
  throw Fault{.found = Text("an index into %1", kindOf(value)), .expected = "a list, a dictionary or a text"};
}

Value sliceOf(const Value& value, const Value& first, const Value& last, const Value& step, Budget& budget) {
  if (const ListValue* list = value.list()) {
    std::vector<Value> items;
    for (const std::size_t place : placesOf(first, last, step, list->items.size())) items.push_back(list->items[place]);
    budget.step(items.size());
    return makeList(std::move(items), budget, list->tuple);
  }
  const std::string* text = value.text();
  if (!text) throw Fault{.found = Text("a slice of %1", kindOf(value)), .expected = "a list or a text"};
  budget.step(1 + text->size() / 64);
  const std::vector<std::string> letters = lettersOf(*text);
  std::string result;
  for (const std::size_t place : placesOf(first, last, step, letters.size())) result += letters[place];
  return budget.text(result);
}

}  // namespace hapticell::xacro
