// SPDX-License-Identifier: Apache-2.0
#include "xacro/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hapticell::xacro {

namespace {

constexpr int kDeepestValue = 60;

int oneDeeper(int depth) {
  if (depth >= kDeepestValue)
    throw Fault{.found = "lists nested deeper than 60", .expected = "a list with fewer nested levels"};
  return depth + 1;
}

std::string quoted(const std::string& text) {
  const char mark = text.find('\'') != std::string::npos && text.find('"') == std::string::npos ? '"' : '\'';
  std::string result(1, mark);
  for (const char c : text) {
    if (c == mark || c == '\\') result += '\\';
    if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (c == '\r')
      result += "\\r";
    else
      result += c;
  }
  return result + mark;
}

/// Texts of what is deep and shared grow without end: the bound is kept while they grow.
void writeRepr(const Value& value, std::string& out, Budget& budget);

void writeItems(const std::vector<Value>& items, std::string& out, Budget& budget) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += ", ";
    writeRepr(items[i], out, budget);
  }
}

void writeRepr(const Value& value, std::string& out, Budget& budget) {
  budget.step();
  Budget::checkText(out.size());
  if (const std::string* text = value.text()) {
    out += quoted(*text);
  } else if (const ListValue* list = value.list()) {
    out += list->tuple ? '(' : '[';
    writeItems(list->items, out, budget);
    if (list->tuple && list->items.size() == 1) out += ',';
    out += list->tuple ? ')' : ']';
  } else if (const DictValue* dict = value.dict()) {
    out += '{';
    for (std::size_t i = 0; i < dict->items.size(); ++i) {
      if (i > 0) out += ", ";
      writeRepr(dict->items[i].first, out, budget);
      out += ": ";
      writeRepr(dict->items[i].second, out, budget);
    }
    out += '}';
  } else {
    out += textOf(value, budget);
  }
}

std::string keyText(const Value& key) {
  if (const std::string* text = key.text()) return "t" + *text;
  if (key.isNumber()) return "n" + numberText(numberOf(key));
  if (key.as<std::monostate>()) return "-";
  throw Fault{.found = Text("%1 as the key of a dictionary", kindOf(key)), .expected = "a text or a number"};
}

}  // namespace

const ListValue* Value::list() const {
  const ListPointer* pointer = as<ListPointer>();
  return pointer ? pointer->get() : nullptr;
}

const DictValue* Value::dict() const {
  const DictPointer* pointer = as<DictPointer>();
  return pointer ? pointer->get() : nullptr;
}

int depthOf(const Value& value) {
  if (const ListValue* list = value.list()) return list->depth;
  if (const DictValue* dict = value.dict()) return dict->depth;
  const FunctionPointer* function = value.as<FunctionPointer>();
  return function ? (*function)->depth : 0;
}

const Value* DictValue::find(const Value& key) const {
  const auto place = places.find(keyText(key));
  return place == places.end() ? nullptr : &items[place->second].second;
}

Value makeList(std::vector<Value> items, Budget& budget, bool tuple) {
  Budget::checkList(items.size());
  budget.take(sizeof(ListValue) + items.size() * sizeof(Value));
  ListValue list;
  list.tuple = tuple;
  int depth = 0;
  for (const Value& item : items) depth = std::max(depth, depthOf(item));
  list.depth = oneDeeper(depth);
  list.items = std::move(items);
  return ListPointer(std::make_shared<const ListValue>(std::move(list)));
}

Value makeDict(std::vector<std::pair<Value, Value>> items, Budget& budget) {
  Budget::checkList(items.size());
  budget.take(sizeof(DictValue) + items.size() * 3 * sizeof(Value));
  DictValue dict;
  int depth = 0;
  for (auto& [key, value] : items) {
    depth = std::max(depth, depthOf(value));
    const auto [place, fresh] = dict.places.emplace(keyText(key), dict.items.size());
    if (fresh)
      dict.items.emplace_back(std::move(key), std::move(value));
    else
      dict.items[place->second].second = std::move(value);
  }
  dict.depth = oneDeeper(depth);
  return DictPointer(std::make_shared<const DictValue>(std::move(dict)));
}

Value makeFunction(std::string name, std::function<Value(Call&)> run, int kept) {
  return FunctionPointer(
      std::make_shared<const FunctionValue>(FunctionValue{std::move(name), std::move(run), oneDeeper(kept)}));
}

Text kindOf(const Value& value) {
  static constexpr const char* kNames[] = {HAPTICELL_TRANSLATED("None", "True or False", "a whole number", "a number",
                                                                "a text", "a list", "a dictionary", "a function",
                                                                "a namespace", "a block")};
  return Text(kNames[value.data.index()]);
}

/// The shortest digits that bring the number back, in Python's form: plain from 1e-4 up to 1e16.
std::string numberText(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  char buffer[64];
  const auto scientific = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
  const std::string text(buffer, scientific.ptr);
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  if (exponent < -4 || exponent >= 16) return text;
  const auto fixed = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  std::string plain(buffer, fixed.ptr);
  if (plain.find('.') == std::string::npos) plain += ".0";
  return plain;
}

std::string textOf(const Value& value, Budget& budget) {
  if (value.as<std::monostate>()) return "None";
  if (const bool* truth = value.as<bool>()) return *truth ? "True" : "False";
  if (const auto* whole = value.as<std::int64_t>()) return std::to_string(*whole);
  if (const double* number = value.as<double>()) return numberText(*number);
  if (const std::string* text = value.text()) return *text;
  if (value.list() || value.dict()) return reprOf(value, budget);
  throw Fault{.found = Text("%1 instead of a text", kindOf(value)), .expected = "a text, a number or a list"};
}

std::string reprOf(const Value& value, Budget& budget) {
  std::string out;
  writeRepr(value, out, budget);
  return budget.text(out);
}

bool truthOf(const Value& value) {
  if (value.as<std::monostate>()) return false;
  if (value.isNumber()) return numberOf(value) != 0.0;
  if (const std::string* text = value.text()) return !text->empty();
  if (const ListValue* list = value.list()) return !list->items.empty();
  if (const DictValue* dict = value.dict()) return !dict->items.empty();
  return true;
}

double numberOf(const Value& value) {
  if (const bool* truth = value.as<bool>()) return *truth ? 1.0 : 0.0;
  if (const auto* whole = value.as<std::int64_t>()) return static_cast<double>(*whole);
  if (const double* number = value.as<double>()) return *number;
  throw Fault{.found = Text("%1 instead of a number", kindOf(value)), .expected = "a number"};
}

std::int64_t wholeOf(const Value& value) {
  if (const bool* truth = value.as<bool>()) return *truth ? 1 : 0;
  if (const auto* whole = value.as<std::int64_t>()) return *whole;
  throw Fault{.found = Text("%1 instead of a whole number", kindOf(value)), .expected = "a whole number"};
}

bool equal(const Value& a, const Value& b, Budget& budget) {
  budget.step();
  if (a.isWhole() && b.isWhole()) return wholeOf(a) == wholeOf(b);
  if (a.isNumber() && b.isNumber()) return numberOf(a) == numberOf(b);
  if (a.data.index() != b.data.index()) return false;
  if (a.text()) return *a.text() == *b.text();
  if (a.list()) {
    if (a.list()->tuple != b.list()->tuple || a.list()->items.size() != b.list()->items.size()) return false;
    for (std::size_t i = 0; i < a.list()->items.size(); ++i) {
      if (!equal(a.list()->items[i], b.list()->items[i], budget)) return false;
    }
    return true;
  }
  if (a.dict()) {
    if (a.dict()->items.size() != b.dict()->items.size()) return false;
    for (const auto& [key, value] : a.dict()->items) {
      const Value* other = b.dict()->find(key);
      if (!other || !equal(value, *other, budget)) return false;
    }
    return true;
  }
  return a.data == b.data;
}

int compare(const Value& a, const Value& b, Budget& budget) {
  budget.step();
  const auto order = [](const auto& x, const auto& y) { return (y < x ? 1 : 0) - (x < y ? 1 : 0); };
  if (a.isWhole() && b.isWhole()) return order(wholeOf(a), wholeOf(b));
  if (a.isNumber() && b.isNumber()) return order(numberOf(a), numberOf(b));
  if (a.text() && b.text()) return order(*a.text(), *b.text());
  if (a.list() && b.list()) {
    const auto &x = a.list()->items, &y = b.list()->items;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
      if (const int first = compare(x[i], y[i], budget); first != 0) return first;
    }
    return order(x.size(), y.size());
  }
  throw Fault{.found = Text("%1 compared with %2", kindOf(a), kindOf(b)), .expected = "two numbers or two texts"};
}

}  // namespace hapticell::xacro
