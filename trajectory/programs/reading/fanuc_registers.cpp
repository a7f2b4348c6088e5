// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/fanuc_registers.h"

#include <algorithm>
#include <string_view>

#include "trajectory/motion/csv_table.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

bool compared(double a, std::string_view sign, double b) {
  if (sign == "<>") return a != b;
  if (sign == "<=") return a <= b;
  if (sign == ">=") return a >= b;
  if (sign == "=") return a == b;
  return sign == "<" ? a < b : a > b;
}

/// X, Y, Z, W, P, R are 1 to 6.
bool setElement(FanucPosition& position, int element, double value) {
  if (!position.X || element > 6) return false;
  if (element <= 3) {
    position.X->p[element - 1] = 1e-3 * value;
    return true;
  }
  dvec3 wpr = fanucAngles(position.X->q);
  wpr[element - 4] = value;
  position.X->q = fromFanucAngles(wpr);
  return true;
}

double elementOf(const FanucPosition& position, int element) {
  return element <= 3 ? 1e3 * position.X->p[element - 1] : fanucAngles(position.X->q)[element - 4];
}

/// Where what is done last stands: the last + or - between two values, else the last * or /; 0: none.
std::size_t lastOperator(const std::string& text) {
  for (const std::string_view operators : {std::string_view("+-"), std::string_view("*/")}) {
    for (std::size_t i = text.size(); i-- > 1;) {
      const bool is_sign = std::string_view("+-*/(=<>").find(text[i - 1]) != std::string_view::npos;
      if (!is_sign && operators.find(text[i]) != std::string_view::npos) return i;
    }
  }
  return 0;
}

}  // namespace

std::optional<int> fanucBracketed(const std::string& text, const std::string& opening, std::size_t from) {
  const auto at = text.find(opening, from);
  if (at == std::string::npos) return std::nullopt;
  const auto begin = at + opening.size();
  const auto number = parseNumber(text.substr(begin, text.find_first_of(":]", begin) - begin));
  if (!number || *number < 0 || *number > 1e6) return std::nullopt;
  return static_cast<int>(*number);
}

std::optional<std::pair<int, int>> fanucRegisterIn(const std::string& text) {
  if (!text.starts_with("PR[")) return std::nullopt;
  const auto end = text.find_first_of(",:]", 3);
  if (end == std::string::npos) return std::nullopt;
  const auto first = parseNumber(text.substr(3, end - 3));
  if (!first || *first < 0 || *first > 1e6) return std::nullopt;
  if (text[end] != ',') return std::pair(static_cast<int>(*first), 0);
  const auto second = parseNumber(text.substr(end + 1, text.find_first_of(":]", end) - end - 1));
  if (!second || *second < 1 || *second > 9) return std::nullopt;
  return std::pair(static_cast<int>(*first), static_cast<int>(*second));
}

std::string fanucWithoutBlanks(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  for (std::size_t at = text.find(':'); at != std::string::npos; at = text.find(':', at)) {
    const std::size_t end = text.find(']', at);
    if (end == std::string::npos) break;
    text.erase(at, end - at);
  }
  return text;
}

std::optional<double> FanucRegisters::number(const std::string& text) const {
  if (const std::size_t i = lastOperator(text); i > 0) {
    const auto a = number(text.substr(0, i)), b = number(text.substr(i + 1));
    if (!a || !b) return std::nullopt;
    if (text[i] == '+') return *a + *b;
    if (text[i] == '-') return *a - *b;
    if (text[i] == '*') return *a * *b;
    return *b == 0.0 ? std::nullopt : std::optional(*a / *b);
  }
  if (text.starts_with("R[")) {
    const auto r = fanucBracketed(text, "R[");
    const auto found = r ? numbers_.find(*r) : numbers_.end();
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  if (const auto pr = fanucRegisterIn(text); pr && pr->second >= 1 && pr->second <= 6) {
    const auto found = held_.find(pr->first);
    if (found == held_.end() || !found->second.X) return std::nullopt;
    return elementOf(found->second, pr->second);
  }
  return parseNumber(text);
}

std::optional<double> FanucRegisters::value(int r) const {
  const auto found = numbers_.find(r);
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

const FanucPosition* FanucRegisters::position(int pr) const {
  const auto found = held_.find(pr);
  return found == held_.end() ? nullptr : &found->second;
}

std::optional<bool> FanucRegisters::holds(std::string text) const {
  for (const char* word : {" OR ", " AND "}) {
    const auto at = text.find(word);
    if (at == std::string::npos) continue;
    const auto a = holds(text.substr(0, at)), b = holds(text.substr(at + std::string(word).size()));
    if (!a || !b) return std::nullopt;
    return std::string(word) == " OR " ? *a || *b : *a && *b;
  }
  text = fanucWithoutBlanks(text);
  while (text.size() > 1 && text.front() == '(' && text.back() == ')') text = text.substr(1, text.size() - 2);
  for (const char* sign : {"<>", "<=", ">=", "=", "<", ">"}) {
    const std::size_t at = text.find(sign);
    if (at == std::string::npos) continue;
    const auto a = number(text.substr(0, at)), b = number(text.substr(at + std::string(sign).size()));
    if (!a || !b) return std::nullopt;
    return compared(*a, sign, *b);
  }
  return std::nullopt;
}

bool FanucRegisters::assign(const std::string& text) {
  const auto r = fanucBracketed(text, "R[");
  const auto equals = text.find('=');
  if (!r || equals == std::string::npos) return false;
  const auto value = number(text.substr(equals + 1));
  if (value)
    numbers_[*r] = *value;
  else
    numbers_.erase(*r);
  return true;
}

bool FanucRegisters::assignPosition(const std::string& text, const std::optional<FanucPosition>& here) {
  const auto equals = text.find('=');
  const auto left = fanucRegisterIn(text.substr(0, equals));
  if (!left || equals == std::string::npos) return false;
  const std::string right = text.substr(equals + 1);
  if (left->second == 0) {
    assignWhole(left->first, right, here);
    return true;
  }
  const auto value = number(right);
  const auto found = held_.find(left->first);
  if (found == held_.end()) return true;
  if (!value || !setElement(found->second, left->second, *value)) held_.erase(found);
  return true;
}

void FanucRegisters::assignWhole(int to, const std::string& right, const std::optional<FanucPosition>& here) {
  std::optional<FanucPosition> value;
  const auto pr = fanucRegisterIn(right);
  if (right == "LPOS" && here) {
    value = here;
  } else if (const auto p = right.starts_with("P[") ? fanucBracketed(right, "P[") : std::nullopt) {
    if (const auto found = positions_.find(*p); found != positions_.end()) value = found->second;
  } else if (pr && pr->second == 0) {
    if (const auto found = held_.find(pr->first); found != held_.end()) value = found->second;
  }
  const bool is_single = right == "LPOS" || right.find(']') + 1 == right.size();
  if (value && is_single) {
    held_[to] = *value;
  } else {
    held_.erase(to);
  }
}

}  // namespace hapticell::trajectory
