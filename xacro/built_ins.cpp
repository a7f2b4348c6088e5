// SPDX-License-Identifier: Apache-2.0
#include "xacro/built_ins.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "geometry/system/utf8.h"
#include "xacro/call_arguments.h"
#include "xacro/interpreter.h"
#include "xacro/operators.h"
#include "xacro/yaml_values.h"

namespace hapticell::xacro {

namespace {

using Run = Value (*)(Call&);

Value listOf(Call& call, bool tuple) {
  expectArguments(call, tuple ? "tuple" : "list", 0, 1);
  return makeList(call.arguments.empty() ? std::vector<Value>() : call.interpreter.itemsOf(call.arguments[0]),
                  call.interpreter.budget(), tuple);
}

Value pairOf(Value first, Value second, Budget& budget) {
  std::vector<Value> both;
  both.push_back(std::move(first));
  both.push_back(std::move(second));
  return makeList(std::move(both), budget, true);
}

Value dictionary(Call& call) {
  expectArguments(call, "dict", 0, 1, true);
  std::vector<std::pair<Value, Value>> items;
  if (!call.arguments.empty() && call.arguments[0].dict()) {
    items = call.arguments[0].dict()->items;
  } else if (!call.arguments.empty()) {
    for (const Value& item : call.interpreter.itemsOf(call.arguments[0])) {
      const std::vector<Value> pair = call.interpreter.itemsOf(item);
      if (pair.size() != 2)
        throw Fault{.found = "dict() of values that are not pairs", .expected = "pairs of a key and a value"};
      items.emplace_back(pair[0], pair[1]);
    }
  }
  for (const auto& [name, value] : call.named) items.emplace_back(name, value);
  return makeDict(std::move(items), call.interpreter.budget());
}

Value length(Call& call) {
  expectArguments(call, "len", 1, 1);
  const Value& value = call.arguments[0];
  if (const std::string* text = value.text())
    return static_cast<std::int64_t>(
        std::count_if(text->begin(), text->end(), [](char c) { return !continuesCharacter(c); }));
  if (value.list()) return static_cast<std::int64_t>(value.list()->items.size());
  if (value.dict()) return static_cast<std::int64_t>(value.dict()->items.size());
  throw Fault{.found = Text("len() of %1", kindOf(value)), .expected = "a list, a dictionary or a text"};
}

Value wholeFrom(Call& call) {
  expectArguments(call, "int", 0, 2);
  if (call.arguments.empty()) return 0;
  const Value& value = call.arguments[0];
  if (value.isWhole()) return wholeOf(value);
  if (const std::string* text = value.text()) {
    if (call.arguments.size() == 1) {
      if (const auto whole = wholeFromText(*text)) return *whole;
    } else {
      const std::int64_t base = wholeOf(call.arguments[1]);
      char* end = nullptr;
      if (base >= 0 && base <= 36 && base != 1 && !text->empty() && text->size() < 60) {
        const long long whole = std::strtoll(text->c_str(), &end, static_cast<int>(base));
        if (*end == '\0') return std::int64_t{whole};
      }
    }
    throw Fault{.found = Text("int(\"%1\")", text->substr(0, 40)), .expected = "a whole number"};
  }
  const double number = numberOf(value);
  if (!(std::abs(number) < 9.2e18))
    throw Fault{.found = Text("int(%1)", numberText(number)), .expected = "a number within 64 bits"};
  return static_cast<std::int64_t>(number);
}

Value numberFrom(Call& call) {
  expectArguments(call, "float", 0, 1);
  if (call.arguments.empty()) return 0.0;
  const std::string* text = call.arguments[0].text();
  if (!text) return numberOf(call.arguments[0]);
  if (const auto number = numberFromText(*text)) return *number;
  throw Fault{.found = Text("float(\"%1\")", text->substr(0, 40)), .expected = "a number"};
}

Value textFrom(Call& call) {
  expectArguments(call, "str", 0, 1);
  if (call.arguments.empty()) return "";
  return textOf(call.arguments[0], call.interpreter.budget());
}

Value keyOf(const Call& call, const Value& item) {
  const auto key = call.named.find("key");
  return key == call.named.end() ? item : call.interpreter.call(key->second, {item});
}

Value extreme(Call& call, bool greatest) {
  expectArguments(call, greatest ? "max" : "min", 1, 100000, true);
  const std::vector<Value> items =
      call.arguments.size() == 1 ? call.interpreter.itemsOf(call.arguments[0]) : call.arguments;
  const auto otherwise = call.named.find("default");
  if (items.empty() && otherwise != call.named.end()) return otherwise->second;
  if (items.empty())
    throw Fault{.found = greatest ? Text("max() without values") : Text("min() without values"),
                .expected = "at least one value"};
  std::size_t best = 0;
  Value best_key = keyOf(call, items[0]);
  for (std::size_t i = 1; i < items.size(); ++i) {
    Value key = keyOf(call, items[i]);
    const int order = compare(key, best_key, call.interpreter.budget());
    if (greatest ? order <= 0 : order >= 0) continue;
    best = i;
    best_key = std::move(key);
  }
  return items[best];
}

/// To even, as Python does.
Value rounded(Call& call) {
  expectArguments(call, "round", 1, 2, true);
  const auto named = call.named.find("ndigits");
  Value digits;
  if (named != call.named.end()) digits = named->second;
  if (call.arguments.size() > 1) digits = call.arguments[1];
  const Value& value = call.arguments[0];
  if (value.isWhole() && digits.as<std::monostate>()) return wholeOf(value);
  const double number = numberOf(value);
  if (digits.as<std::monostate>()) {
    if (!(std::abs(number) < 9.2e18))
      throw Fault{.found = Text("round(%1)", numberText(number)), .expected = "a number within 64 bits"};
    return static_cast<std::int64_t>(std::nearbyint(number));
  }
  const std::int64_t places = std::clamp<std::int64_t>(wholeOf(digits), -300, 300);
  if (value.isWhole() && places >= 0) return wholeOf(value);
  if (places >= 0) {
    if (!std::isfinite(number)) return number;
    char buffer[800];
    std::snprintf(buffer, sizeof buffer, "%.*f", static_cast<int>(places), number);
    return std::strtod(buffer, nullptr);
  }
  const double unit = std::pow(10.0, static_cast<double>(-places)), result = std::nearbyint(number / unit) * unit;
  return value.isWhole() ? Value(static_cast<std::int64_t>(result)) : Value(result);
}

Value sorted(Call& call) {
  expectArguments(call, "sorted", 1, 1, true);
  std::vector<std::pair<Value, Value>> keyed;
  for (Value& item : call.interpreter.itemsOf(call.arguments[0])) {
    Value key = keyOf(call, item);
    keyed.emplace_back(std::move(key), std::move(item));
  }
  const auto reverse = call.named.find("reverse");
  const bool down = reverse != call.named.end() && truthOf(reverse->second);
  Budget& budget = call.interpreter.budget();
  std::stable_sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    return down ? compare(a.first, b.first, budget) > 0 : compare(a.first, b.first, budget) < 0;
  });
  std::vector<Value> items;
  for (auto& [key, item] : keyed) items.push_back(std::move(item));
  return makeList(std::move(items), budget);
}

Value range(Call& call) {
  expectArguments(call, "range", 1, 3);
  const std::size_t count = call.arguments.size();
  const std::int64_t first = count > 1 ? wholeOf(call.arguments[0]) : 0,
                     last = wholeOf(call.arguments[count > 1 ? 1 : 0]);
  const std::int64_t step = count > 2 ? wholeOf(call.arguments[2]) : 1;
  if (step == 0) throw Fault{.found = "range() with a step of 0", .expected = "a step other than 0"};
  std::vector<Value> items;
  for (std::int64_t at = first; step > 0 ? at < last : at > last;) {
    items.emplace_back(at);
    Budget::checkList(items.size());
    if (__builtin_add_overflow(at, step, &at)) break;
  }
  call.interpreter.budget().step(items.size());
  return makeList(std::move(items), call.interpreter.budget());
}

Value zipped(const std::vector<std::vector<Value>>& lists, Budget& budget) {
  std::vector<Value> items;
  std::size_t shortest = lists.empty() ? 0 : lists[0].size();
  for (const auto& list : lists) shortest = std::min(shortest, list.size());
  for (std::size_t i = 0; i < shortest; ++i) {
    std::vector<Value> together;
    for (const auto& list : lists) together.push_back(list[i]);
    items.push_back(makeList(std::move(together), budget, true));
  }
  return makeList(std::move(items), budget);
}

Value mappedOrFiltered(Call& call, bool filters) {
  expectArguments(call, filters ? "filter" : "map", 2, 2);
  std::vector<Value> items;
  for (const Value& item : call.interpreter.itemsOf(call.arguments[1])) {
    const bool plain = filters && call.arguments[0].as<std::monostate>();
    Value made = plain ? item : call.interpreter.call(call.arguments[0], {item});
    if (!filters) items.push_back(std::move(made));
    if (filters && truthOf(made)) items.push_back(item);
  }
  return makeList(std::move(items), call.interpreter.budget());
}

Value allOrAny(Call& call, bool all) {
  expectArguments(call, all ? "all" : "any", 1, 1);
  const std::vector<Value> items = call.interpreter.itemsOf(call.arguments[0]);
  return all ? std::all_of(items.begin(), items.end(), truthOf) : std::any_of(items.begin(), items.end(), truthOf);
}

Value absolute(Call& call) {
  expectArguments(call, "abs", 1, 1);
  const Value& value = call.arguments[0];
  if (value.isWhole())
    return wholeOf(value) < 0 ? binaryOperation("-", 0, value, call.interpreter.budget()) : Value(wholeOf(value));
  return std::abs(numberOf(value));
}

Value sum(Call& call) {
  expectArguments(call, "sum", 1, 2);
  Value result = call.arguments.size() > 1 ? call.arguments[1] : Value(0);
  for (const Value& item : call.interpreter.itemsOf(call.arguments[0]))
    result = binaryOperation("+", result, item, call.interpreter.budget());
  return result;
}

Value enumerated(Call& call) {
  expectArguments(call, "enumerate", 1, 2);
  std::int64_t number = call.arguments.size() > 1 ? wholeOf(call.arguments[1]) : 0;
  std::vector<Value> items;
  for (Value& item : call.interpreter.itemsOf(call.arguments[0]))
    items.push_back(pairOf(number++, std::move(item), call.interpreter.budget()));
  return makeList(std::move(items), call.interpreter.budget());
}

Value reversed(Call& call) {
  expectArguments(call, "reversed", 1, 1);
  std::vector<Value> items = call.interpreter.itemsOf(call.arguments[0]);
  std::reverse(items.begin(), items.end());
  return makeList(std::move(items), call.interpreter.budget());
}

Value divisionWithRest(Call& call) {
  expectArguments(call, "divmod", 2, 2);
  Budget& budget = call.interpreter.budget();
  Value quotient = binaryOperation("//", call.arguments[0], call.arguments[1], budget);
  return pairOf(std::move(quotient), binaryOperation("%", call.arguments[0], call.arguments[1], budget), budget);
}

const std::pair<const char*, Run> kEverywhere[] = {
    {"list", [](Call& call) { return listOf(call, false); }},
    {"dict", dictionary},
    {"map", [](Call& call) { return mappedOrFiltered(call, false); }},
    {"len", length},
    {"str", textFrom},
    {"float", numberFrom},
    {"int", wholeFrom},
    {"min", [](Call& call) { return extreme(call, false); }},
    {"max", [](Call& call) { return extreme(call, true); }},
    {"round", rounded},
    {"sorted", sorted},
    {"range", range},
};

const std::pair<const char*, Run> kInPython[] = {
    {"abs", absolute},
    {"all", [](Call& call) { return allOrAny(call, true); }},
    {"any", [](Call& call) { return allOrAny(call, false); }},
    {"divmod", divisionWithRest},
    {"enumerate", enumerated},
    {"filter", [](Call& call) { return mappedOrFiltered(call, true); }},
    {"repr",
     [](Call& call) -> Value {
       expectArguments(call, "repr", 1, 1);
       return reprOf(call.arguments[0], call.interpreter.budget());
     }},
    {"reversed", reversed},
    {"sum", sum},
    {"tuple", [](Call& call) { return listOf(call, true); }},
    {"zip",
     [](Call& call) {
       std::vector<std::vector<Value>> lists;
       for (const Value& list : call.arguments) lists.push_back(call.interpreter.itemsOf(list));
       return zipped(lists, call.interpreter.budget());
     }},
};

std::string messageOf(Call& call) {
  std::string text;
  for (const Value& value : call.arguments)
    text += (text.empty() ? "" : " ") + textOf(value, call.interpreter.budget());
  return text.substr(0, 1000);
}

/// At ',', ';' and blanks, or at the signs of a second text.
Value tokenized(Call& call) {
  expectArguments(call, "tokenize", 1, 3, true);
  const std::string& text = textArgument(call, "tokenize", 0);
  const auto option = [&call](std::size_t index, const char* name) -> const Value* {
    if (call.arguments.size() > index) return &call.arguments[index];
    const auto named = call.named.find(name);
    return named == call.named.end() ? nullptr : &named->second;
  };
  const Value *separators = option(1, "sep"), *skip = option(2, "skip_empty");
  const std::string signs = separators && separators->text() ? *separators->text() : ",; ";
  std::vector<Value> words;
  call.interpreter.budget().step(1 + text.size());
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(signs, at), text.size());
    if (end > at || (skip && !truthOf(*skip))) words.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return makeList(std::move(words), call.interpreter.budget());
}

Value loadedYaml(Call& call) {
  expectArguments(call, "load_yaml", 1, 1);
  return loadYaml(textArgument(call, "load_yaml", 0), call.interpreter);
}

const std::pair<const char*, Run> kInXacro[] = {
    {"load_yaml", loadedYaml},
    {"abs_filename",
     [](Call& call) -> Value {
       expectArguments(call, "abs_filename", 1, 1);
       return call.interpreter.surroundings().absoluteName(textArgument(call, "abs_filename", 0));
     }},
    {"dotify",
     [](Call& call) -> Value {
       expectArguments(call, "dotify", 1, 1);
       return call.arguments[0];
     }},
    {"arg",
     [](Call& call) {
       expectArguments(call, "arg", 1, 1);
       return call.interpreter.surroundings().argument(textArgument(call, "arg", 0));
     }},
    {"tokenize", tokenized},
    {"message", [](Call&) -> Value { return ""; }},
    {"print_location", [](Call&) -> Value { return ""; }},
    {"warning",
     [](Call& call) -> Value {
       call.interpreter.surroundings().warn(Text("the file warns: %1", messageOf(call)));
       return "";
     }},
    {"error",
     [](Call& call) -> Value {
       call.interpreter.surroundings().warn(Text("the file reports an error: %1", messageOf(call)));
       return "";
     }},
    {"fatal",
     [](Call& call) -> Value { throw Fault{.found = Text("the file stops with the error: %1", messageOf(call))}; }},
};

}  // namespace

void addBuiltIns(Scope& scope, Scopes& scopes) {
  Scope &python = scopes.make(nullptr, true), &xacro = scopes.make(nullptr, true), &math = scopes.make(nullptr, true);
  addMathFunctions(scope, math);
  const auto add = [](Scope& to, const std::pair<const char*, Run>& entry) {
    to.set(entry.first, makeFunction(entry.first, entry.second), false);
  };
  for (const auto& entry : kEverywhere) {
    add(scope, entry);
    add(python, entry);
  }
  for (const auto& entry : kInPython) add(python, entry);
  for (const auto& entry : kInXacro) add(xacro, entry);
  for (const char* name : {"load_yaml", "abs_filename", "dotify"}) {
    for (const auto& entry : kInXacro) {
      if (std::string(entry.first) == name) add(scope, entry);
    }
  }
  scope.set("abs", makeFunction("abs", absolute), false);
  scope.set("python", &python, false);
  scope.set("xacro", &xacro, false);
  scope.set("math", &math, false);
}

}  // namespace hapticell::xacro
