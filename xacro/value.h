// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "xacro/budget.h"

namespace hapticell::xacro {

class Interpreter;
class Scope;
struct XmlNode;
struct Value;

struct ListValue;
struct DictValue;
struct FunctionValue;
using ListPointer = std::shared_ptr<const ListValue>;
using DictPointer = std::shared_ptr<const DictValue>;
using FunctionPointer = std::shared_ptr<const FunctionValue>;

/// What an expression gives: nothing, a truth, a whole number, a number, a text, a list or tuple, a dictionary, a
/// function of the reader's own, the scope of a name space, or a block of elements. Whole numbers have 64 bits: beyond
/// them is a Fault. No value refers to anything of the program, and none changes once it is made.
struct Value {
  using Data = std::variant<std::monostate, bool, std::int64_t, double, std::string, ListPointer, DictPointer,
                            FunctionPointer, Scope*, std::shared_ptr<const XmlNode>>;
  Data data;

  Value() = default;
  template <class T>
  Value(T given) : data(std::move(given)) {}  // NOLINT(google-explicit-constructor): values are written as such.
  Value(const char* text) : data(std::string(text)) {}  // NOLINT(google-explicit-constructor)
  Value(int number) : data(std::int64_t{number}) {}     // NOLINT(google-explicit-constructor)

  template <class T>
  const T* as() const {
    return std::get_if<T>(&data);
  }
  const std::string* text() const { return as<std::string>(); }
  const ListValue* list() const;
  const DictValue* dict() const;
  bool isNumber() const { return as<bool>() || as<std::int64_t>() || as<double>(); }
  bool isWhole() const { return as<bool>() || as<std::int64_t>(); }
};

struct ListValue {
  std::vector<Value> items;
  bool tuple = false;
  int depth = 1;  ///< Levels of lists and dictionaries in it.
};

/// Keeps the order of insertion; keys are whole numbers, numbers, truths, texts or nothing.
struct DictValue {
  std::vector<std::pair<Value, Value>> items;
  std::unordered_map<std::string, std::size_t> places;  ///< By keyText().
  int depth = 1;

  const Value* find(const Value& key) const;
  const Value* find(const std::string& key) const { return find(Value(key)); }
};

/// The arguments of a call.
struct Call {
  Interpreter& interpreter;
  std::vector<Value> arguments;
  std::map<std::string, Value> named;
};

struct FunctionValue {
  std::string name;
  std::function<Value(Call&)> run;
  int depth = 1;  ///< As of a list that holds what the function keeps: methods their object, a lambda its names.
};

/// Bounds on sizes and depth are kept here: Fault where one is passed.
Value makeList(std::vector<Value> items, Budget& budget, bool tuple = false);
/// A key that comes twice keeps its first place and its last value.
Value makeDict(std::vector<std::pair<Value, Value>> items, Budget& budget);
/// `kept`: depthOf() the deepest value that `run` holds.
Value makeFunction(std::string name, std::function<Value(Call&)> run, int kept = 0);
/// Levels of lists, dictionaries and what functions keep; 0 of others.
int depthOf(const Value& value);

/// "a text", "a list" … for messages.
Text kindOf(const Value& value);
/// As Python's str() and repr() write it: True, None, 0.1, 1e-05, [1, 'a'].
std::string textOf(const Value& value, Budget& budget);
std::string reprOf(const Value& value, Budget& budget);
std::string numberText(double value);
bool truthOf(const Value& value);
/// Of a truth or a number.
double numberOf(const Value& value);
std::int64_t wholeOf(const Value& value);
/// Python's ==: numbers by value, lists item by item.
bool equal(const Value& a, const Value& b, Budget& budget);
/// Negative, zero or positive, for numbers, texts and lists; Fault for others.
int compare(const Value& a, const Value& b, Budget& budget);

}  // namespace hapticell::xacro
