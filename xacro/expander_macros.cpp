// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "xacro/expander.h"
#include "xacro/pushed.h"

namespace hapticell::xacro {

void Expander::defineMacro(const XmlNode& node, const Context& context) {
  checkAttributes(node, {"name", "params"});
  Macro macro;
  macro.name = required(node, "name");
  if (macro.name.starts_with("xacro:")) macro.name.erase(0, 6);
  if (macro.name == "call" || macro.name.find('.') != std::string::npos)
    throw Fault("a macro with the name '" + macro.name + "'", "a name without points, other than call");
  macro.parameters = parametersOf(optional(node, "params", ""));
  budget_.take(sizeof(Macro) + macro.parameters.size() * sizeof(MacroParameter));
  budget_.step(macro.parameters.size());
  macro.body = std::make_shared<const XmlNode>(node);
  budget_.take(sizeof(XmlNode) + node.children.size() * sizeof(XmlPointer));
  context.macros.set(std::move(macro));
}

void Expander::callMacro(const XmlNode& node, const std::string& full_name, const Context& context, Nodes& out) {
  Scope* caller = &context.symbols;
  MacroScope* macros = &context.macros;
  const Macro* macro = macros->find(full_name);
  std::string rest = full_name;
  for (std::size_t point; !macro && (point = rest.find('.')) != std::string::npos;) {
    const std::string space = rest.substr(0, point);
    rest.erase(0, point + 1);
    macros = macros->findSpace(space);
    const Value* symbols = macros ? caller->find(space, interpreter_) : nullptr;
    if (!symbols || !symbols->as<Scope*>()) break;
    caller = *symbols->as<Scope*>();
    macro = macros->find(rest);
  }
  if (!macro)
    throw Fault("<xacro:" + full_name + ">: there is no macro of this name",
                "a macro that is defined in front, or an element of xacro's",
                "Include the file that defines it, or correct the name.");
  const Macro kept = *macro;  // It may define itself anew.
  budget_.step(10 + kept.parameters.size());
  Scope& inside = scopes_.make(caller);
  MacroScope& inside_macros = macro_scopes_.emplace_back(macros);
  budget_.take(sizeof(Scope) + sizeof(MacroScope) + kept.parameters.size() * 3 * sizeof(Value));
  std::vector<std::string> open;
  bindValues(node, kept, *caller, inside, open);
  bindBlocks(node, kept, {*caller, *macros, nullptr}, inside);
  bindDefaults(kept, *caller, inside, open);
  const Pushed<std::string> call(calls_, "macro '" + full_name + "' called in " +
                                             std::filesystem::path(nameOf(node.file)).filename().string() + " line " +
                                             std::to_string(node.line));
  const Budget::Level level(budget_, 4);
  try {
    expandChildren(*kept.body, {inside, inside_macros, context.parent}, out);
  } catch (Fault& fault) {
    if (fault.found.find(" (macro '") == std::string::npos) fault.found += " (" + calls_.back() + ")";
    throw;
  }
}

void Expander::bindValues(const XmlNode& call, const Macro& macro, Scope& caller, Scope& inside,
                          std::vector<std::string>& open) {
  for (const MacroParameter& parameter : macro.parameters) open.push_back(parameter.name);
  for (const XmlNode::Attribute& attribute : call.attributes) {
    if (attribute.name.starts_with("xmlns:") || attribute.name.starts_with("xacro:")) continue;
    const auto place = std::find(open.begin(), open.end(), attribute.name);
    if (place == open.end()) {
      std::string known;
      for (const MacroParameter& parameter : macro.parameters) known += (known.empty() ? "" : ", ") + parameter.name;
      throw Fault("the macro '" + macro.name + "' has no parameter '" + attribute.name + "'",
                  known.empty() ? "none" : "one of " + known.substr(0, 400));
    }
    open.erase(place);
    inside.set(attribute.name, evaluateAt(attribute, call, caller), false);
  }
}

void Expander::bindBlocks(const XmlNode& call, const Macro& macro, const Context& context, Scope& inside) {
  Nodes blocks;
  expandChildren(call, context, blocks);
  std::erase_if(blocks, [](const XmlPointer& node) { return !node->isElement(); });
  std::size_t next = 0;
  for (const MacroParameter& parameter : macro.parameters) {
    if (!parameter.isBlock()) continue;
    if (next == blocks.size())
      throw Fault("the macro '" + macro.name + "' without its block " + parameter.name,
                  "an element inside of the call for each block");
    inside.set(parameter.name, blocks[next++], false);
  }
  if (next < blocks.size())
    throw Fault("<" + blocks[next]->name + "> inside of the call of macro '" + macro.name + "'",
                std::to_string(next) + " blocks");
}

void Expander::bindDefaults(const Macro& macro, Scope& caller, Scope& inside, const std::vector<std::string>& open) {
  std::string missing;
  for (const MacroParameter& parameter : macro.parameters) {
    if (parameter.isBlock() || std::find(open.begin(), open.end(), parameter.name) == open.end()) continue;
    const Value* forwarded = parameter.forwarded ? caller.find(parameter.name, interpreter_) : nullptr;
    if (forwarded)
      inside.set(parameter.name, Value(*forwarded), false);
    else if (parameter.otherwise)
      inside.set(parameter.name, interpreter_.evaluateText(*parameter.otherwise, caller), false);
    else
      missing += (missing.empty() ? "" : ", ") + parameter.name;
  }
  if (!missing.empty())
    throw Fault("the macro '" + macro.name + "' without its parameters " + missing.substr(0, 400), "a value for each");
}

}  // namespace hapticell::xacro
