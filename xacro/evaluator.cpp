// SPDX-License-Identifier: Apache-2.0
#include "xacro/evaluator.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "xacro/fault.h"

namespace hapticell::xacro {

namespace {

constexpr std::size_t kMostWarnings = 1000;

std::pair<std::string, std::string> splitWord(const std::string& words) {
  const std::size_t begin = std::min(words.find_first_not_of(" \t\n"), words.size());
  const std::size_t end = std::min(words.find_first_of(" \t\n", begin), words.size());
  const std::size_t rest = words.find_first_not_of(" \t\n", end), last = words.find_last_not_of(" \t\n");
  return {words.substr(begin, end - begin), rest == std::string::npos ? "" : words.substr(rest, last - rest + 1)};
}

}  // namespace

Evaluator::Evaluator(const Arguments& arguments, SourceFiles& sources, std::vector<DeclaredArgument>& declared,
                     Diagnostics& diagnostics, Budget& budget)
    : arguments_(arguments),
      sources_(sources),
      declared_(declared),
      diagnostics_(diagnostics),
      budget_(budget),
      interpreter_(budget, *this) {}

Value Evaluator::valueOf(const XmlNode::Attribute& attribute, const XmlNode& node, Scope& scope) {
  try {
    return value(attribute.value, scope);
  } catch (Fault& fault) {
    if (fault.file.empty()) {
      fault.file = sources_.nameOf(node.file);
      fault.place = linePlace(attribute.line > 0 ? attribute.line : node.line);
    }
    throw;
  }
}

void Evaluator::report(const std::string& file, const Text& place, const Text& sentence) {
  budget_.step(100);
  const Text placed = place.empty() ? Text("%1: %2", file, sentence) : Text("%1, %2: %3", file, place, sentence);
  const Text whole = file.empty() ? sentence : placed;
  const auto& known = diagnostics_.warnings;
  if (known.size() < kMostWarnings && std::find(known.begin(), known.end(), whole) == known.end())
    diagnostics_.warn(whole);
}

void Evaluator::warn(const Text& sentence) {
  report(at_ ? sources_.nameOf(at_->file) : "", at_ ? Text("line %1", at_->line) : Text(), sentence);
}

const DeclaredArgument* Evaluator::findArgument(const std::string& name) const {
  const auto found =
      std::find_if(declared_.begin(), declared_.end(), [&](const DeclaredArgument& one) { return one.name == name; });
  return found == declared_.end() ? nullptr : &*found;
}

void Evaluator::declare(const std::string& name, const XmlNode& node, Scope& scope) {
  if (findArgument(name)) return;
  const auto given = arguments_.find(name);
  DeclaredArgument argument{name, "", std::nullopt, sources_.nameOf(node.file), node.line};
  if (const XmlNode::Attribute* otherwise = node.attribute("default"))
    argument.otherwise = text(otherwise->value, scope);
  if (given != arguments_.end())
    argument.value = given->second;
  else if (argument.otherwise)
    argument.value = *argument.otherwise;
  else
    return;  // Reported where it is used.
  budget_.take(sizeof argument + name.size() + argument.value.size());
  declared_.push_back(std::move(argument));
}

Value Evaluator::argument(const std::string& name) {
  if (const DeclaredArgument* argument = findArgument(name)) return argument->value;
  if (const auto given = arguments_.find(name); given != arguments_.end()) return given->second;
  declared_.push_back({name, "", std::nullopt, at_ ? sources_.nameOf(at_->file) : "", at_ ? at_->line : 0});
  throw Fault{.found = Text("undefined substitution argument %1", name.substr(0, 100)),
              .expected = "a value",
              .fix = Text("Set it with %1:=VALUE.", name.substr(0, 100))};
}

Value Evaluator::environment(const std::string& words, bool optional) {
  const auto [name, otherwise] = splitWord(words);
  const char* value = std::getenv(name.c_str());
  if (value) return std::string(value).substr(0, 4096);
  if (optional) return otherwise;
  throw Fault{.found = Text("the environment variable %1 is not set", name.substr(0, 100)),
              .expected = "a value",
              .fix = "Set it before you start the program."};
}

/// $(eval …): the arguments, and functions for the other substitutions, are names in it.
Value Evaluator::expression(const std::string& text, Scope& scope) {
  Scope& names = scopes_.make(scope.top().parent());
  for (const DeclaredArgument& one : declared_) names.set(one.name, one.value, false);
  for (const auto& [name, value] : arguments_) names.set(name, value, false);
  const auto add = [&](const char* name, const char* verb_of_it) {
    names.set(name,
              makeFunction(name,
                           [this, verb_of_it, &names](Call& call) -> Value {
                             std::string inside = verb_of_it;
                             for (const Value& value : call.arguments) inside += " " + textOf(value, budget_);
                             Value found = substitution(inside, names);
                             return found.text() ? literalOf(std::string(*found.text())) : found;
                           }),
              false);
  };
  for (const char* name : {"arg", "env", "optenv", "find", "dirname"}) add(name, name);
  names.set("true", true, false);
  names.set("false", false, false);
  return interpreter_.evaluateExpression(text, names);
}

Value Evaluator::substitution(const std::string& words, Scope& scope) {
  const auto [verb, rest] = splitWord(words);
  if (verb == "find") return "package://" + rest;
  if (verb == "arg") return argument(rest);
  if (verb == "dirname") return sources_.folder().string();
  if (verb == "cwd") return sources_.firstFolder().string();  // The working folder says nothing in a window.
  if (verb == "env" || verb == "optenv") return environment(rest, verb == "optenv");
  if (verb == "anon") return rest;
  if (verb != "eval")
    throw Fault{.found = "$(" + words.substr(0, 60) + ")",
                .expected = "$(find), $(arg), $(env), $(optenv), $(eval), $(dirname) or $(cwd)"};
  return expression(rest, scope);
}

}  // namespace hapticell::xacro
