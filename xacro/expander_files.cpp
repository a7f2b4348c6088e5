// SPDX-License-Identifier: Apache-2.0
#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>

#include "xacro/expand.h"
#include "xacro/expander.h"
#include "xacro/pushed.h"

namespace hapticell::xacro {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;

/// Files of a folder by a pattern in their name, in order.
std::vector<fs::path> filesLike(const fs::path& pattern) {
  std::vector<fs::path> found;
  std::error_code problem;
  std::size_t seen = 0;
  for (fs::directory_iterator entry(pattern.parent_path(), fs::directory_options::skip_permission_denied, problem), end;
       !problem && entry != end && ++seen <= kMostFiles; entry.increment(problem)) {
    if (fnmatch(pattern.filename().c_str(), entry->path().filename().c_str(), FNM_PERIOD) == 0)
      found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string packageOf(const std::string& reference) {
  const std::size_t begin = std::string("package://").size();
  return reference.substr(begin, reference.find('/', begin) - begin);
}

std::pair<std::string, std::string> splitWord(const std::string& words) {
  const std::size_t begin = std::min(words.find_first_not_of(" \t\n"), words.size());
  const std::size_t end = std::min(words.find_first_of(" \t\n", begin), words.size());
  const std::size_t rest = words.find_first_not_of(" \t\n", end), last = words.find_last_not_of(" \t\n");
  return {words.substr(begin, end - begin), rest == std::string::npos ? "" : words.substr(rest, last - rest + 1)};
}

Fault notFound(const std::string& reference) {
  if (!reference.starts_with("package://"))
    return Fault("the file " + reference + " is not there", "a file", "Correct the path or put the file there.");
  return Fault("resource not found: " + packageOf(reference) + " (" + reference + ")", "the package's folder",
               "Put the package's folder beside the file or above it, or name its place in ROS_PACKAGE_PATH.");
}

}  // namespace

void Expander::report(const std::string& file, int line, const std::string& sentence) {
  budget_.step(100);
  const std::string whole = (file.empty() ? "" : file + ", line " + std::to_string(line) + ": ") + sentence;
  const auto& known = diagnostics_.warnings;
  if (known.size() < kMostFiles && std::find(known.begin(), known.end(), whole) == known.end())
    diagnostics_.warn(whole);
}

void Expander::warn(const std::string& sentence) {
  report(at_ ? nameOf(at_->file) : "", at_ ? at_->line : 0, sentence);
}

std::string Expander::absoluteName(const std::string& reference) {
  if (reference.starts_with("package://") || fs::path(reference).is_absolute()) return reference;
  return (folder() / reference).lexically_normal().string();
}

std::string Expander::readText(const std::string& reference, std::string& file) {
  const auto found = files_.find(reference, folder());
  if (!found) throw notFound(reference);
  file = found->string();
  const auto text = files_.read(*found);
  if (!text) throw Fault(text.error().found, text.error().expected, text.error().fix);
  budget_.step(1 + text->size() / 64);
  if (std::find(files_read_.begin(), files_read_.end(), *found) == files_read_.end()) files_read_.push_back(*found);
  return *text;
}

Expander::Context Expander::nameSpace(const std::string& name, const Context& context) {
  budget_.take(sizeof(Scope) + sizeof(MacroScope));
  MacroScope& macros = macro_scopes_.emplace_back(nullptr);
  context.macros.setSpace(name, &macros);
  Scope& symbols = scopes_.make(&context.symbols, true);
  context.symbols.set(name, &symbols, false);
  return {symbols, macros, context.parent};
}

void Expander::include(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"filename", "ns", "optional"});
  const std::string reference = interpreter_.textOfText(required(node, "filename"), context.symbols);
  const std::string space = interpreter_.textOfText(optional(node, "ns", ""), context.symbols);
  const Context inside = space.empty() ? context : nameSpace(space, context);
  if (reference.find_first_of("*?[") != std::string::npos) {
    const std::vector<fs::path> files = filesLike(absoluteName(reference));
    if (files.empty()) warn("no file is like " + reference);
    for (const fs::path& file : files) includeFile(file, inside, out);
    return;
  }
  if (const auto file = files_.find(reference, folder())) return includeFile(*file, inside, out);
  if (!truth(optional(node, "optional", "false"), context.symbols)) throw notFound(reference);
}

void Expander::includeFile(const fs::path& file, const Context& context, Nodes& out) {
  const Budget::Level level(budget_, 8);
  int index = 0;
  const XmlPointer root = parsed(file, index);
  const Pushed<int> inside(file_stack_, index);
  expandChildren(*root, context, out);
}

const DeclaredArgument* Expander::findArgument(const std::string& name) const {
  const auto found =
      std::find_if(declared_.begin(), declared_.end(), [&](const DeclaredArgument& one) { return one.name == name; });
  return found == declared_.end() ? nullptr : &*found;
}

void Expander::defineArgument(const XmlNode& node, const Context& context) {
  const std::string& name = required(node, "name");
  if (findArgument(name)) return;
  const auto given = arguments_.find(name);
  DeclaredArgument argument{name, "", std::nullopt, nameOf(node.file), node.line};
  if (node.attribute("default"))
    argument.otherwise = interpreter_.textOfText(required(node, "default"), context.symbols);
  if (given != arguments_.end())
    argument.value = given->second;
  else if (argument.otherwise)
    argument.value = *argument.otherwise;
  else
    return;  // Reported where it is used.
  budget_.take(sizeof argument + name.size() + argument.value.size());
  declared_.push_back(std::move(argument));
}

Value Expander::argument(const std::string& name) {
  if (const DeclaredArgument* argument = findArgument(name)) return argument->value;
  if (const auto given = arguments_.find(name); given != arguments_.end()) return given->second;
  declared_.push_back({name, "", std::nullopt, at_ ? nameOf(at_->file) : "", at_ ? at_->line : 0});
  throw Fault("undefined substitution argument " + name.substr(0, 100), "a value for it",
              "Give one: " + name.substr(0, 100) + ":=VALUE.");
}

Value Expander::substitution(const std::string& words, Scope& scope) {
  const auto [verb, rest] = splitWord(words);
  if (verb == "find") return "package://" + rest;
  if (verb == "arg") return argument(rest);
  if (verb == "dirname") return folder().string();
  if (verb == "cwd") return files_read_[0].parent_path().string();  // The working folder says nothing in a window.
  if (verb == "env" || verb == "optenv") {
    const auto [name, otherwise] = splitWord(rest);
    const char* value = std::getenv(name.c_str());
    if (value) return std::string(value).substr(0, 4096);
    if (verb == "optenv") return otherwise;
    throw Fault("the environment variable " + name.substr(0, 100) + " is not set", "a value for it",
                "Set it before the program is started.");
  }
  if (verb == "anon") return rest;
  if (verb != "eval")
    throw Fault("$(" + words.substr(0, 60) + ")", "$(find), $(arg), $(env), $(optenv), $(eval), $(dirname) or $(cwd)");
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
  return interpreter_.evaluateExpression(rest, names);
}

}  // namespace hapticell::xacro
