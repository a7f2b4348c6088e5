// SPDX-License-Identifier: Apache-2.0
#include "xacro/yaml_values.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "xacro/built_ins.h"
#include "xacro/interpreter.h"

namespace hapticell::xacro {

namespace {

constexpr std::size_t kLongestYaml = std::size_t{8} << 20;

const std::map<std::string, double> kUnits = {{"!radians", 1.0}, {"!degrees", std::numbers::pi / 180.0},
                                              {"!meters", 1.0},  {"!millimeters", 0.001},
                                              {"!foot", 0.3048}, {"!inches", 0.0254}};
const std::set<std::string> kTrue = {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"};
const std::set<std::string> kFalse = {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"};
const std::set<std::string> kNothing = {"", "~", "null", "Null", "NULL"};

bool allOf(const std::string& text, std::size_t begin, const char* signs) {
  return begin < text.size() && text.find_first_not_of(signs, begin) == std::string::npos;
}

std::string withoutUnderscores(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

/// Sexagesimal: 1:30 is 90.
std::optional<double> baseSixty(const std::string& text, bool& real) {
  if (text.find(':') == std::string::npos || !allOf(text, 0, "0123456789:._") || text[0] == ':' || text[0] == '.')
    return std::nullopt;
  double value = 0.0;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(':', at), text.size());
    const auto part = numberFromText(text.substr(at, end - at));
    if (!part || (at > 0 && *part >= 60.0)) return std::nullopt;
    value = value * 60.0 + *part;
    at = end + 1;
  }
  real = text.find('.') != std::string::npos;
  return value;
}

/// Whole numbers of YAML 1.1, without their sign.
std::optional<std::int64_t> wholeOfYaml(const std::string& text) {
  int base = 10;
  std::size_t begin = 0;
  if (text.starts_with("0x")) {
    base = 16;
    begin = 2;
  } else if (text.starts_with("0b")) {
    base = 2;
    begin = 2;
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
    begin = 1;
  }
  if (begin == 0 && !allOf(text, 0, "0123456789_")) return std::nullopt;
  const std::string digits = withoutUnderscores(text.substr(begin));
  std::int64_t whole = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), whole, base);
  return !digits.empty() && problem == std::errc() && end == digits.data() + digits.size() ? std::optional(whole)
                                                                                           : std::nullopt;
}

/// Numbers of YAML 1.1 need a point, and a sign in their exponent.
std::optional<double> numberOfYaml(const std::string& text) {
  if (text == ".inf" || text == ".Inf" || text == ".INF") return std::numeric_limits<double>::infinity();
  const std::size_t e = text.find_first_of("eE");
  const std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos || !allOf(mantissa, 0, "0123456789._")) return std::nullopt;
  if (e != std::string::npos &&
      (e + 2 > text.size() || (text[e + 1] != '+' && text[e + 1] != '-') || !allOf(text, e + 2, "0123456789")))
    return std::nullopt;
  return numberFromText(withoutUnderscores(text));
}

Value plainValue(const std::string& text) {
  if (kNothing.count(text)) return {};
  if (kTrue.count(text)) return true;
  if (kFalse.count(text)) return false;
  if (text == ".nan" || text == ".NaN" || text == ".NAN") return std::numeric_limits<double>::quiet_NaN();
  const bool negative = text[0] == '-', sign = negative || text[0] == '+';
  const std::string rest = text.substr(sign ? 1 : 0);
  if (rest.empty()) return text;
  if (const auto whole = wholeOfYaml(rest)) return negative ? -*whole : *whole;
  if (const auto number = numberOfYaml(rest)) return negative ? -*number : *number;
  bool real = false;
  if (const auto number = baseSixty(rest, real)) {
    const double value = negative ? -*number : *number;
    return real ? Value(value) : Value(static_cast<std::int64_t>(value));
  }
  return text;
}

class Converter {
 public:
  Converter(Interpreter& interpreter, std::string file) : interpreter_(interpreter), file_(std::move(file)) {}

  Value convert(const YAML::Node& node) {
    Budget& budget = interpreter_.budget();
    budget.step(4);
    const Budget::Level level(budget, 4);
    try {
      if (node.IsScalar()) return scalar(node);
      if (node.IsSequence()) return sequence(node);
      if (node.IsMap()) return map(node);
      return {};
    } catch (Fault& fault) {
      place(fault, node);
      throw;
    }
  }

 private:
  Interpreter& interpreter_;
  std::string file_;
  Scopes scopes_;
  Scope* globals_ = nullptr;

  void place(Fault& fault, const YAML::Node& node) const {
    if (!fault.file.empty()) return;
    fault.file = file_;
    fault.place = linePlace(node.Mark().line + 1);
  }

  Value scalar(const YAML::Node& node) {
    const std::string& text = node.Scalar();
    interpreter_.budget().take(text.size());
    const std::string& tag = node.Tag();
    if (const auto unit = kUnits.find(tag); unit != kUnits.end()) return measure(text, unit->second);
    if (tag == "!" || tag == "tag:yaml.org,2002:str") return text;
    if (tag.empty() || tag == "?" || tag.starts_with("tag:yaml.org,2002:")) return plainValue(text);
    throw Fault{.found = Text("the tag %1", tag),
                .expected = "no tag, or one of !degrees, !radians, !meters, !millimeters, !foot, !inches"};
  }

  /// An expression that may name the functions and pi, but no property.
  Value measure(const std::string& text, double factor) {
    if (!globals_) addBuiltIns(*(globals_ = &scopes_.make(nullptr)), scopes_);
    const Value value = interpreter_.evaluateExpression(text, *globals_);
    const auto number = value.text() ? numberFromText(*value.text()) : std::optional(numberOf(value));
    if (!number) throw Fault{.found = Text("\"%1\" with a unit", text.substr(0, 80)), .expected = "a number"};
    return *number * factor;
  }

  static void expectPlain(const YAML::Node& node, const char* kind) {
    const std::string& tag = node.Tag();
    if (!tag.empty() && tag != "?" && tag != "!" && tag != std::string("tag:yaml.org,2002:") + kind)
      throw Fault{.found = Text("the tag %1", tag), .expected = "none"};
  }

  Value sequence(const YAML::Node& node) {
    expectPlain(node, "seq");
    std::vector<Value> items;
    for (const YAML::Node& item : node) items.push_back(convert(item));
    return makeList(std::move(items), interpreter_.budget());
  }

  Value map(const YAML::Node& node) {
    expectPlain(node, "map");
    std::vector<std::pair<Value, Value>> merged, own;
    for (const auto& item : node) {
      Value key = convert(item.first);
      Value value = convert(item.second);
      const bool merges = item.first.IsScalar() && item.first.Scalar() == "<<" && item.first.Tag() != "!";
      if (merges)
        merge(value, merged);
      else
        own.emplace_back(std::move(key), std::move(value));
    }
    merged.insert(merged.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    return makeDict(std::move(merged), interpreter_.budget());
  }

  /// "<<" takes over the items of a dictionary, or of a list of them of which the first counts.
  static void merge(const Value& value, std::vector<std::pair<Value, Value>>& merged) {
    if (const DictValue* dict = value.dict()) {
      merged.insert(merged.end(), dict->items.begin(), dict->items.end());
    } else if (const ListValue* list = value.list()) {
      for (auto item = list->items.rbegin(); item != list->items.rend(); ++item) merge(*item, merged);
    } else {
      throw Fault{.found = Text("<< with %1", kindOf(value)), .expected = "a dictionary"};
    }
  }
};

}  // namespace

Value loadYaml(const std::string& reference, Interpreter& interpreter) {
  std::string file;
  const std::string text = interpreter.surroundings().readText(reference, file);
  const auto refuse = [&file](const Text& found, int line) {
    return Fault{.found = found, .expected = "a YAML file", .file = file, .place = linePlace(line)};
  };
  if (text.size() > kLongestYaml) throw refuse(Text("a YAML file larger than 8 MB"), 0);
  interpreter.budget().take(text.size() * 8);
  try {
    return Converter(interpreter, file).convert(YAML::Load(text));
  } catch (const YAML::Exception& problem) {
    throw refuse(Text("invalid YAML (%1)", problem.msg), problem.mark.line + 1);
  }
}

}  // namespace hapticell::xacro
