// SPDX-License-Identifier: Apache-2.0
#include "xacro/expander.h"

#include <algorithm>
#include <set>
#include <utility>

#include "xacro/built_ins.h"
#include "xacro/fault.h"
#include "xacro/macro_call.h"
#include "xacro/pushed.h"

namespace hapticell::xacro {

namespace {

namespace fs = std::filesystem;

/// Elements of a description that move nothing and have no shape.
bool playsNoPart(const std::string& name) {
  static const std::set<std::string> kNames = {"gazebo", "transmission", "ros2_control", "plugin", "sensor"};
  return kNames.count(name) > 0;
}

}  // namespace

Expander::Expander(const Arguments& arguments, const Files& files, std::vector<DeclaredArgument>& declared,
                   Diagnostics& diagnostics)
    : sources_(files, budget_), evaluator_(arguments, sources_, declared, diagnostics, budget_) {}

XmlPointer Expander::run(const fs::path& file) {
  int index = 0;
  const XmlPointer root = sources_.parsed(file, index);
  const Pushed<int> inside = sources_.enter(index);
  Scope& globals = evaluator_.scopes().make(nullptr);
  addBuiltIns(globals, evaluator_.scopes());
  Scope& symbols = evaluator_.scopes().make(&globals);
  MacroScope& macros = macro_scopes_.emplace_back(nullptr);
  Nodes out;
  copyElement(*root, root->name, {symbols, macros, nullptr}, out);
  return out.at(0);
}

void Expander::expandChildren(const XmlNode& node, const Context& context, Nodes& out) {
  const Budget::Level level(budget_, 2);
  for (const XmlPointer& child : node.children) expandNode(child, context, out);
}

void Expander::expandNode(const XmlPointer& node, const Context& context, Nodes& out) {
  budget_.step(3);
  const Evaluator::At here(evaluator_, node.get());
  try {
    if (node->isElement())
      expandElement(*node, context, out);
    else
      copyText(*node, context, out);
  } catch (Fault& fault) {
    if (fault.file.empty()) {
      fault.file = sources_.nameOf(node->file);
      fault.place = linePlace(node->line);
    }
    throw;
  }
}

void Expander::copyText(const XmlNode& node, const Context& context, Nodes& out) {
  XmlNode copy = node;
  copy.text = evaluator_.text(node.text, context.symbols);
  budget_.take(sizeof(XmlNode) + copy.text.size());
  if (!copy.text.empty()) out.push_back(std::make_shared<const XmlNode>(std::move(copy)));
}

void Expander::expandElement(const XmlNode& node, const Context& context, Nodes& out) {
  if (node.name.starts_with("xacro:")) {
    if (!expandStatement(node, context, out)) callMacro(node, node.name.substr(6), context, out);
    return;
  }
  if (!playsNoPart(node.name)) return copyElement(node, node.name, context, out);
  try {
    copyElement(node, node.name, context, out);
  } catch (const Fault& fault) {
    evaluator_.report(fault.file.empty() ? sources_.nameOf(node.file) : fault.file,
                      fault.file.empty() ? Text("line %1", node.line) : fault.place,
                      Text("<%1> is left out, because it does not affect motion: %2", node.name, fault.found));
  }
}

bool Expander::expandStatement(const XmlNode& node, const Context& context, Nodes& out) {
  const std::string statement = node.name.substr(6);
  if (statement == "include") {
    include(node, context, out);
  } else if (statement == "property") {
    property(node, context);
  } else if (statement == "macro") {
    defineMacro(node, context);
  } else if (statement == "arg") {
    defineArgument(node, context);
  } else if (statement == "if" || statement == "unless") {
    condition(node, context, out);
  } else if (statement == "insert_block") {
    insertBlock(node, context, out);
  } else if (statement == "attribute") {
    setAttribute(node, context);
  } else if (statement == "element") {
    const std::string name = evaluator_.text(required(node, "xacro:name"), context.symbols);
    if (name.empty()) throw Fault{.found = "<xacro:element> with an empty name", .expected = "a name"};
    XmlNode renamed = node;
    renamed.name = name;
    std::erase_if(renamed.attributes, [](const XmlNode::Attribute& one) { return one.name == "xacro:name"; });
    budget_.take(sizeof(XmlNode) + node.children.size() * sizeof(XmlPointer));
    expandElement(renamed, context, out);
  } else if (statement == "call") {
    XmlNode call = node;
    std::erase_if(call.attributes, [](const XmlNode::Attribute& one) { return one.name == "macro"; });
    callMacro(call, evaluator_.text(required(node, "macro"), context.symbols), context, out);
  } else {
    return false;
  }
  return true;
}

void Expander::copyElement(const XmlNode& node, std::string name, const Context& context, Nodes& out) {
  XmlNode copy;
  copy.name = std::move(name);
  copy.file = node.file;
  copy.line = node.line;
  std::size_t size = sizeof(XmlNode) + copy.name.size();
  for (const XmlNode::Attribute& attribute : node.attributes) {
    if (attribute.name.starts_with("xacro:") || attribute.name == "xmlns:xacro") continue;
    copy.attributes.push_back(
        {attribute.name, textOf(evaluator_.valueOf(attribute, node, context.symbols), budget_), attribute.line});
    size += sizeof(XmlNode::Attribute) + copy.attributes.back().value.size();
  }
  budget_.take(size);
  Nodes children;
  expandChildren(node, {context.symbols, context.macros, &copy}, children);
  copy.children = std::move(children);
  out.push_back(std::make_shared<const XmlNode>(std::move(copy)));
}

const std::string& Expander::required(const XmlNode& node, const char* attribute) const {
  if (const XmlNode::Attribute* found = node.attribute(attribute)) return found->value;
  throw Fault{.found = Text("<%1> without %2", node.name, attribute), .expected = std::string(attribute) + "=\"…\""};
}

std::string Expander::optional(const XmlNode& node, const char* attribute, const char* otherwise) const {
  const XmlNode::Attribute* found = node.attribute(attribute);
  return found ? found->value : otherwise;
}

void Expander::checkAttributes(const XmlNode& node, std::initializer_list<const char*> known) {
  for (const XmlNode::Attribute& attribute : node.attributes) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const char* name) { return attribute.name == name; });
    if (!is_known && !attribute.name.starts_with("xmlns:"))
      evaluator_.warn(Text("<%1> has the unknown attribute '%2'", node.name, attribute.name));
  }
}

void Expander::condition(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"value"});
  if (evaluator_.truth(required(node, "value"), context.symbols) == (node.name == "xacro:if"))
    expandChildren(node, context, out);
}

void Expander::setAttribute(const XmlNode& node, const Context& context) {
  const std::string name = evaluator_.text(required(node, "name"), context.symbols);
  const std::string value = evaluator_.text(required(node, "value"), context.symbols);
  if (name.empty()) throw Fault{.found = "<xacro:attribute> with an empty name", .expected = "a name"};
  if (!context.parent) return;
  std::erase_if(context.parent->attributes, [&](const XmlNode::Attribute& one) { return one.name == name; });
  budget_.take(sizeof(XmlNode::Attribute) + name.size() + value.size());
  context.parent->attributes.push_back({name, value, node.line});
}

void Expander::insertBlock(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"name"});
  const std::string& name = required(node, "name");
  const Value* content = context.symbols.find("**" + name, evaluator_.interpreter());
  const Value* whole = content ? content : context.symbols.find("*" + name, evaluator_.interpreter());
  if (!whole)
    throw Fault{.found = Text("the block '%1' is not defined", name),
                .expected = "a block of the macro, or a property with elements"};
  const XmlPointer block = *whole->as<XmlPointer>();
  const Budget::Level level(budget_, 2);
  if (content)
    expandChildren(*block, context, out);
  else
    expandNode(block, context, out);
}

void Expander::property(const XmlNode& node, const Context& context) {
  checkAttributes(node, {"name", "value", "default", "remove", "scope", "lazy_eval"});
  Scope& symbols = context.symbols;
  const std::string name = evaluator_.text(required(node, "name"), symbols);
  if (!isIdentifier(name) || name.starts_with("__"))
    throw Fault{.found = Text("a property with the name '%1'", name.substr(0, 60)),
                .expected = "letters, digits and _, no Python keyword, no __ at the start"};
  const bool remove = evaluator_.truth(optional(node, "remove", "false"), symbols);
  const XmlNode::Attribute *value = node.attribute("value"), *otherwise = node.attribute("default");
  if ((value ? 1 : 0) + (otherwise ? 1 : 0) + (remove ? 1 : 0) > 1)
    throw Fault{.found = Text("the property '%1' with more than one of value, default and remove", name),
                .expected = "one of them"};
  if (remove) {
    symbols.remove(name);
  } else if (otherwise) {
    if (!symbols.holds(name)) setProperty(node, name, otherwise->value, symbols);
  } else if (value) {
    setProperty(node, name, value->value, symbols);
  } else {
    setProperty(node, "**" + name, std::make_shared<const XmlNode>(node), symbols);
  }
}

void Expander::setProperty(const XmlNode& node, const std::string& name, Value value, Scope& symbols) {
  bool lazy = evaluator_.truth(optional(node, "lazy_eval", "true"), symbols);
  const std::string where = optional(node, "scope", "");
  Scope* target = &symbols;
  if (where == "global") {
    target = &symbols.top();
    lazy = false;
  } else if (where == "parent") {
    lazy = false;
    if (symbols.parent() && symbols.parent()->parent()) target = symbols.parent();
    while (!symbols.isNameSpace() && target->isNameSpace()) target = target->parent();
  } else if (!where.empty()) {
    evaluator_.warn(Text("scope=\"%1\" is unknown; the property '%2' is set in the current scope", where, name));
  }
  if (const std::string* text = value.text(); text && !lazy) value = evaluator_.value(std::string(*text), symbols);
  budget_.take(sizeof(Value) * 4 + name.size() + (value.text() ? value.text()->size() : 0));
  target->set(name, std::move(value), lazy);
}

Expander::Context Expander::nameSpace(const std::string& name, const Context& context) {
  budget_.take(sizeof(Scope) + sizeof(MacroScope));
  MacroScope& macros = macro_scopes_.emplace_back(nullptr);
  context.macros.setSpace(name, &macros);
  Scope& symbols = evaluator_.scopes().make(&context.symbols, true);
  context.symbols.set(name, &symbols, false);
  return {symbols, macros, context.parent};
}

void Expander::include(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"filename", "ns", "optional"});
  const std::string reference = evaluator_.text(required(node, "filename"), context.symbols);
  const std::string space = evaluator_.text(optional(node, "ns", ""), context.symbols);
  const Context inside = space.empty() ? context : nameSpace(space, context);
  if (reference.find_first_of("*?[") != std::string::npos) {
    const std::vector<fs::path> files = sources_.matching(reference);
    if (files.empty()) evaluator_.warn(Text("no file matches %1", reference));
    for (const fs::path& file : files) includeFile(file, inside, out);
    return;
  }
  if (const auto file = sources_.find(reference)) return includeFile(*file, inside, out);
  if (!evaluator_.truth(optional(node, "optional", "false"), context.symbols)) throw notFound(reference);
}

void Expander::includeFile(const fs::path& file, const Context& context, Nodes& out) {
  const Budget::Level level(budget_, 8);
  int index = 0;
  const XmlPointer root = sources_.parsed(file, index);
  const Pushed<int> inside = sources_.enter(index);
  expandChildren(*root, context, out);
}

void Expander::defineArgument(const XmlNode& node, const Context& context) {
  evaluator_.declare(required(node, "name"), node, context.symbols);
}

void Expander::defineMacro(const XmlNode& node, const Context& context) {
  checkAttributes(node, {"name", "params"});
  Macro macro;
  macro.name = required(node, "name");
  if (macro.name.starts_with("xacro:")) macro.name.erase(0, 6);
  if (macro.name == "call" || macro.name.find('.') != std::string::npos)
    throw Fault{.found = Text("a macro with the name '%1'", macro.name),
                .expected = "a name without dots, other than call"};
  macro.parameters = parametersOf(optional(node, "params", ""));
  budget_.take(sizeof(Macro) + macro.parameters.size() * sizeof(MacroParameter));
  budget_.step(macro.parameters.size());
  macro.body = std::make_shared<const XmlNode>(node);
  budget_.take(sizeof(XmlNode) + node.children.size() * sizeof(XmlPointer));
  context.macros.set(std::move(macro));
}

/// The macro "NAME" or "SPACE.NAME"; `caller` and `macros` become the scopes that it is defined in.
const Macro* Expander::findMacro(const std::string& full_name, Scope*& caller, MacroScope*& macros) {
  const Macro* macro = macros->find(full_name);
  std::string rest = full_name;
  for (std::size_t point; !macro && (point = rest.find('.')) != std::string::npos;) {
    const std::string space = rest.substr(0, point);
    rest.erase(0, point + 1);
    macros = macros->findSpace(space);
    const Value* symbols = macros ? caller->find(space, evaluator_.interpreter()) : nullptr;
    if (!symbols || !symbols->as<Scope*>()) break;
    caller = *symbols->as<Scope*>();
    macro = macros->find(rest);
  }
  if (!macro)
    throw Fault{.found = Text("<xacro:%1>: there is no macro of this name", full_name),
                .expected = "a macro that is defined earlier, or an element of xacro",
                .fix = "Include the file that defines it, or correct the name."};
  return macro;
}

void Expander::callMacro(const XmlNode& node, const std::string& full_name, const Context& context, Nodes& out) {
  Scope* caller = &context.symbols;
  MacroScope* macros = &context.macros;
  const Macro kept = *findMacro(full_name, caller, macros);  // A copy: it may redefine itself.
  budget_.step(10 + kept.parameters.size());
  Scope& inside = evaluator_.scopes().make(caller);
  MacroScope& inside_macros = macro_scopes_.emplace_back(macros);
  budget_.take(sizeof(Scope) + sizeof(MacroScope) + kept.parameters.size() * 3 * sizeof(Value));
  MacroCall binding(kept, *caller, inside, evaluator_);
  binding.bindValues(node);
  Nodes blocks;
  expandChildren(node, {*caller, *macros, nullptr}, blocks);
  binding.bindBlocks(std::move(blocks));
  binding.bindDefaults();
  const std::string file = std::filesystem::path(sources_.nameOf(node.file)).filename().string();
  const Pushed<Text> call(calls_, Text("macro '%1' called in %2 line %3", full_name, file, node.line));
  const Budget::Level level(budget_, 4);
  try {
    expandChildren(*kept.body, {inside, inside_macros, context.parent}, out);
  } catch (Fault& fault) {
    if (!std::exchange(fault.names_macro, true)) fault.found = Text("%1 (%2)", fault.found, calls_.back());
    throw;
  }
}

}  // namespace hapticell::xacro
