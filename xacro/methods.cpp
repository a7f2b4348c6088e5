// SPDX-License-Identifier: Apache-2.0
#include "xacro/methods.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "xacro/call_arguments.h"
#include "xacro/interpreter.h"

namespace hapticell::xacro {

namespace {

using TextMethod = Value (*)(const std::string&, Call&);
using Letters = int (*)(int);

constexpr const char* kBlanks = " \t\n\r\f\v";

std::string mapped(const std::string& text, Letters change) {
  std::string result = text;
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x80) c = static_cast<char>(change(static_cast<unsigned char>(c)));
  }
  return result;
}

bool allAre(const std::string& text, Letters test) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [test](unsigned char c) { return c < 0x80 && test(c) != 0; });
}

std::string stripped(const std::string& text, const Call& call, bool left, bool right) {
  const std::string signs = call.arguments.empty() || !call.arguments[0].text() ? kBlanks : *call.arguments[0].text();
  const std::size_t begin = left ? text.find_first_not_of(signs) : 0;
  if (begin == std::string::npos) return {};
  const std::size_t end = right ? text.find_last_not_of(signs) : text.size() - 1;
  return end == std::string::npos || end < begin ? std::string() : text.substr(begin, end - begin + 1);
}

std::vector<Value> splitAtBlanks(const std::string& text, std::int64_t most) {
  std::vector<Value> words;
  std::size_t at = text.find_first_not_of(kBlanks);
  while (at != std::string::npos) {
    if (most >= 0 && static_cast<std::int64_t>(words.size()) == most) {
      words.emplace_back(text.substr(at));
      break;
    }
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

Value split(const std::string& text, Call& call) {
  expectArguments(call, "split", 0, 2);
  const std::int64_t most = call.arguments.size() > 1 ? wholeOf(call.arguments[1]) : -1;
  call.interpreter.budget().step(1 + text.size());
  if (call.arguments.empty() || call.arguments[0].as<std::monostate>())
    return makeList(splitAtBlanks(text, most), call.interpreter.budget());
  const std::string& between = textArgument(call, "split", 0);
  if (between.empty()) throw Fault{.found = "split() with an empty separator", .expected = "a non-empty separator"};
  std::vector<Value> words;
  std::size_t at = 0;
  for (std::size_t next;
       (next = text.find(between, at)) != std::string::npos && static_cast<std::int64_t>(words.size()) != most;) {
    words.emplace_back(text.substr(at, next - at));
    at = next + between.size();
  }
  words.emplace_back(text.substr(at));
  return makeList(std::move(words), call.interpreter.budget());
}

Value join(const std::string& text, Call& call) {
  expectArguments(call, "join", 1, 1);
  std::string result;
  bool first = true;
  for (const Value& item : call.interpreter.itemsOf(call.arguments[0])) {
    if (!item.text()) throw Fault{.found = Text("join() of %1", kindOf(item)), .expected = "texts"};
    if (!std::exchange(first, false)) result += text;
    result += *item.text();
    Budget::checkText(result.size());
  }
  return call.interpreter.budget().text(result);
}

Value replace(const std::string& text, Call& call) {
  expectArguments(call, "replace", 2, 3);
  const std::string &old = textArgument(call, "replace", 0), &fresh = textArgument(call, "replace", 1);
  std::int64_t most = call.arguments.size() > 2 ? wholeOf(call.arguments[2]) : -1;
  if (old.empty()) throw Fault{.found = "replace() of an empty text", .expected = "a text to replace"};
  call.interpreter.budget().step(1 + text.size());
  std::string result;
  std::size_t at = 0;
  for (std::size_t next; most-- != 0 && (next = text.find(old, at)) != std::string::npos; at = next + old.size()) {
    result += text.substr(at, next - at) + fresh;
    Budget::checkText(result.size());
  }
  return call.interpreter.budget().text(result + text.substr(at));
}

bool startsOrEnds(const std::string& text, const Call& call, bool starts) {
  expectArguments(call, starts ? "startswith" : "endswith", 1, 1);
  const Value& wanted = call.arguments[0];
  const auto fits = [&](const Value& one) {
    if (!one.text())
      throw Fault{.found = Text("%1() with %2", starts ? "startswith" : "endswith", kindOf(one)), .expected = "a text"};
    return starts ? text.starts_with(*one.text()) : text.ends_with(*one.text());
  };
  if (!wanted.list()) return fits(wanted);
  return std::any_of(wanted.list()->items.begin(), wanted.list()->items.end(), fits);
}

std::string padded(const std::string& text, const Call& call, const char* name, bool left) {
  expectArguments(call, name, 1, 2);
  const std::int64_t width = wholeOf(call.arguments[0]);
  if (width > 1000)
    throw Fault{.found = std::string(name) + "(" + std::to_string(width) + ")", .expected = "at most 1000"};
  const std::string fill = call.arguments.size() > 1 ? textArgument(call, name, 1) : " ";
  if (fill.size() != 1)
    throw Fault{.found = Text("%1() with \"%2\"", name, fill.substr(0, 20)), .expected = "one character"};
  const auto missing =
      width > static_cast<std::int64_t>(text.size()) ? static_cast<std::size_t>(width) - text.size() : 0;
  return left ? std::string(missing, fill[0]) + text : text + std::string(missing, fill[0]);
}

std::string filledWithZeros(const std::string& text, const Call& call) {
  expectArguments(call, "zfill", 1, 1);
  const std::int64_t width = wholeOf(call.arguments[0]);
  if (width > 1000) throw Fault{.found = Text("zfill(%1)", width), .expected = "at most 1000"};
  const bool sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const auto missing =
      width > static_cast<std::int64_t>(text.size()) ? static_cast<std::size_t>(width) - text.size() : 0;
  return (sign ? text.substr(0, 1) : "") + std::string(missing, '0') + text.substr(sign ? 1 : 0);
}

std::string titled(const std::string& text) {
  std::string result = text;
  bool begins = true;
  for (char& c : result) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 0x80) c = static_cast<char>(begins ? std::toupper(letter) : std::tolower(letter));
    begins = letter < 0x80 && !std::isalpha(letter);
  }
  return result;
}

std::int64_t countOf(const std::string& text, const std::string& part) {
  if (part.empty()) return static_cast<std::int64_t>(text.size()) + 1;
  std::int64_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

Value partition(const std::string& text, Call& call, bool last) {
  expectArguments(call, "partition", 1, 1);
  const std::string& at = textArgument(call, "partition", 0);
  const std::size_t place = last ? text.rfind(at) : text.find(at);
  std::vector<Value> parts;
  if (place != std::string::npos)
    parts = {text.substr(0, place), at, text.substr(place + at.size())};
  else if (last)
    parts = {"", "", text};
  else
    parts = {text, "", ""};
  return makeList(std::move(parts), call.interpreter.budget(), true);
}

Value placeOfText(const std::string& text, Call& call, bool last, bool must) {
  expectArguments(call, "find", 1, 1);
  const std::string& part = textArgument(call, "find", 0);
  const std::size_t place = last ? text.rfind(part) : text.find(part);
  if (place == std::string::npos && must)
    throw Fault{.found = Text("\"%1\" is not in the text", part.substr(0, 40)), .expected = "a part of the text"};
  return place == std::string::npos ? std::int64_t{-1} : static_cast<std::int64_t>(place);
}

const std::map<std::string, TextMethod> kTextMethods = {
    {"lower", [](const std::string& text, Call&) -> Value { return mapped(text, std::tolower); }},
    {"upper", [](const std::string& text, Call&) -> Value { return mapped(text, std::toupper); }},
    {"title", [](const std::string& text, Call&) -> Value { return titled(text); }},
    {"capitalize",
     [](const std::string& text, Call&) -> Value {
       std::string result = mapped(text, std::tolower);
       if (!result.empty()) result[0] = mapped(result.substr(0, 1), std::toupper)[0];
       return result;
     }},
    {"swapcase",
     [](const std::string& text, Call&) -> Value {
       return mapped(text, [](int c) { return std::isupper(c) ? std::tolower(c) : std::toupper(c); });
     }},
    {"strip", [](const std::string& text, Call& call) -> Value { return stripped(text, call, true, true); }},
    {"lstrip", [](const std::string& text, Call& call) -> Value { return stripped(text, call, true, false); }},
    {"rstrip", [](const std::string& text, Call& call) -> Value { return stripped(text, call, false, true); }},
    {"split", split},
    {"join", join},
    {"replace", replace},
    {"startswith", [](const std::string& text, Call& call) -> Value { return startsOrEnds(text, call, true); }},
    {"endswith", [](const std::string& text, Call& call) -> Value { return startsOrEnds(text, call, false); }},
    {"find", [](const std::string& text, Call& call) { return placeOfText(text, call, false, false); }},
    {"rfind", [](const std::string& text, Call& call) { return placeOfText(text, call, true, false); }},
    {"index", [](const std::string& text, Call& call) { return placeOfText(text, call, false, true); }},
    {"count",
     [](const std::string& text, Call& call) -> Value {
       expectArguments(call, "count", 1, 1);
       return countOf(text, textArgument(call, "count", 0));
     }},
    {"partition", [](const std::string& text, Call& call) { return partition(text, call, false); }},
    {"rpartition", [](const std::string& text, Call& call) { return partition(text, call, true); }},
    {"ljust", [](const std::string& text, Call& call) -> Value { return padded(text, call, "ljust", false); }},
    {"rjust", [](const std::string& text, Call& call) -> Value { return padded(text, call, "rjust", true); }},
    {"zfill", [](const std::string& text, Call& call) -> Value { return filledWithZeros(text, call); }},
    {"isdigit", [](const std::string& text, Call&) -> Value { return allAre(text, std::isdigit); }},
    {"isnumeric", [](const std::string& text, Call&) -> Value { return allAre(text, std::isdigit); }},
    {"isalpha", [](const std::string& text, Call&) -> Value { return allAre(text, std::isalpha); }},
    {"isalnum", [](const std::string& text, Call&) -> Value { return allAre(text, std::isalnum); }},
    {"isspace", [](const std::string& text, Call&) -> Value { return allAre(text, std::isspace); }},
};

std::optional<Value> textMethod(const std::string& text, const std::string& name) {
  const auto found = kTextMethods.find(name);
  if (found == kTextMethods.end()) return std::nullopt;
  const TextMethod method = found->second;
  return makeFunction(name, [text, method](Call& call) {
    call.interpreter.budget().step(1 + text.size() / 64);
    call.interpreter.budget().take(text.size());
    return method(text, call);
  });
}

std::optional<Value> listMethod(const ListPointer& list, const std::string& name, int depth) {
  if (name != "index" && name != "count") return std::nullopt;
  const bool counts = name == "count";
  return makeFunction(
      name,
      [list, name, counts](Call& call) -> Value {
        expectArguments(call, name, 1, 1);
        std::int64_t count = 0;
        for (std::size_t i = 0; i < list->items.size(); ++i) {
          if (!equal(list->items[i], call.arguments[0], call.interpreter.budget())) continue;
          if (!counts) return static_cast<std::int64_t>(i);
          ++count;
        }
        if (!counts) throw Fault{.found = "a value that is not in the list", .expected = "a value of the list"};
        return count;
      },
      depth);
}

Value dictItems(const DictValue& dict, const std::string& name, Call& call) {
  expectArguments(call, name, 0, 0);
  Budget& budget = call.interpreter.budget();
  budget.step(dict.items.size());
  std::vector<Value> items;
  for (const auto& [key, value] : dict.items) {
    if (name == "items")
      items.push_back(makeList({key, value}, budget, true));
    else
      items.push_back(name == "keys" ? key : value);
  }
  return makeList(std::move(items), budget);
}

std::optional<Value> dictMethod(const DictPointer& dict, const std::string& name, int depth) {
  if (name == "keys" || name == "values" || name == "items")
    return makeFunction(
        name, [dict, name](Call& call) { return dictItems(*dict, name, call); }, depth);
  if (name != "get") return std::nullopt;
  return makeFunction(
      name,
      [dict](Call& call) -> Value {
        expectArguments(call, "get", 1, 2);
        if (const Value* item = dict->find(call.arguments[0])) return *item;
        return call.arguments.size() > 1 ? call.arguments[1] : Value();
      },
      depth);
}

}  // namespace

std::optional<Value> methodOf(const Value& value, const std::string& name) {
  if (const std::string* text = value.text()) return textMethod(*text, name);
  if (const ListPointer* list = value.as<ListPointer>()) return listMethod(*list, name, depthOf(value));
  if (const DictPointer* dict = value.as<DictPointer>()) return dictMethod(*dict, name, depthOf(value));
  return std::nullopt;
}

}  // namespace hapticell::xacro
