// SPDX-License-Identifier: Apache-2.0
#include "xacro/expander.h"

#include <algorithm>
#include <set>
#include <utility>

#include "xacro/built_ins.h"
#include "xacro/pushed.h"

namespace hapticell::xacro {

namespace {

namespace fs = std::filesystem;

/// Elements of a description that move nothing and have no shape.
bool playsNoPart(const std::string& name) {
  static const std::set<std::string> kNames = {"gazebo", "transmission", "ros2_control", "plugin", "sensor"};
  return kNames.count(name) > 0;
}

class At {
 public:
  At(const XmlNode*& at, const XmlNode* node) : at_(at), before_(std::exchange(at, node)) {}
  ~At() { at_ = before_; }
  At(const At&) = delete;
  At& operator=(const At&) = delete;

 private:
  const XmlNode*& at_;
  const XmlNode* before_;
};

}  // namespace

Expander::Expander(const Arguments& arguments, const Files& files, std::vector<DeclaredArgument>& declared,
                   Diagnostics& diagnostics)
    : arguments_(arguments),
      files_(files),
      declared_(declared),
      diagnostics_(diagnostics),
      interpreter_(budget_, *this) {}

std::string Expander::nameOf(int file) const {
  return files_read_[static_cast<std::size_t>(file)].string();
}

XmlPointer Expander::parsed(const fs::path& file, int& index) {
  const auto known = parsed_.find(file.string());
  if (known != parsed_.end()) {
    index = known->second.second;
    return known->second.first;
  }
  index = static_cast<int>(files_read_.size());
  const auto text = files_.read(file);
  if (!text) throw Fault(text.error().found, text.error().expected, text.error().fix);
  files_read_.push_back(file);
  budget_.take(text->size() * 4);
  XmlPointer root = readXml(*text, file.string(), index);
  parsed_[file.string()] = {root, index};
  return root;
}

XmlPointer Expander::run(const fs::path& file) {
  int index = 0;
  const XmlPointer root = parsed(file, index);
  const Pushed<int> inside(file_stack_, index);
  Scope& globals = scopes_.make(nullptr);
  addBuiltIns(globals, scopes_);
  Scope& symbols = scopes_.make(&globals);
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
  const At here(at_, node.get());
  try {
    if (node->isElement())
      expandElement(*node, context, out);
    else
      copyText(*node, context, out);
  } catch (Fault& fault) {
    if (fault.file.empty()) {
      fault.file = nameOf(node->file);
      fault.line = node->line;
    }
    throw;
  }
}

void Expander::copyText(const XmlNode& node, const Context& context, Nodes& out) {
  XmlNode copy = node;
  copy.text = interpreter_.textOfText(node.text, context.symbols);
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
    report(fault.file.empty() ? nameOf(node.file) : fault.file, fault.file.empty() ? node.line : fault.line,
           "<" + node.name + "> is left out, it moves nothing: " + fault.found);
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
    const std::string name = interpreter_.textOfText(required(node, "xacro:name"), context.symbols);
    if (name.empty()) throw Fault("<xacro:element> with an empty name", "a name");
    XmlNode renamed = node;
    renamed.name = name;
    std::erase_if(renamed.attributes, [](const XmlNode::Attribute& one) { return one.name == "xacro:name"; });
    budget_.take(sizeof(XmlNode) + node.children.size() * sizeof(XmlPointer));
    expandElement(renamed, context, out);
  } else if (statement == "call") {
    XmlNode call = node;
    std::erase_if(call.attributes, [](const XmlNode::Attribute& one) { return one.name == "macro"; });
    callMacro(call, interpreter_.textOfText(required(node, "macro"), context.symbols), context, out);
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
        {attribute.name, textOf(evaluateAt(attribute, node, context.symbols), budget_), attribute.line});
    size += sizeof(XmlNode::Attribute) + copy.attributes.back().value.size();
  }
  budget_.take(size);
  Nodes children;
  expandChildren(node, {context.symbols, context.macros, &copy}, children);
  copy.children = std::move(children);
  out.push_back(std::make_shared<const XmlNode>(std::move(copy)));
}

Value Expander::evaluateAt(const XmlNode::Attribute& attribute, const XmlNode& node, Scope& symbols) {
  try {
    return interpreter_.evaluateText(attribute.value, symbols);
  } catch (Fault& fault) {
    if (fault.file.empty()) {
      fault.file = nameOf(node.file);
      fault.line = attribute.line > 0 ? attribute.line : node.line;
    }
    throw;
  }
}

const std::string& Expander::required(const XmlNode& node, const char* attribute) const {
  if (const XmlNode::Attribute* found = node.attribute(attribute)) return found->value;
  throw Fault("<" + node.name + "> without " + attribute, std::string(attribute) + "=\"…\"");
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
      warn("<" + node.name + "> has '" + attribute.name + "', which xacro does not know");
  }
}

bool Expander::truth(const std::string& text, Scope& symbols) {
  return conditionOf(interpreter_.evaluateText(text, symbols), text);
}

void Expander::condition(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"value"});
  if (truth(required(node, "value"), context.symbols) == (node.name == "xacro:if")) expandChildren(node, context, out);
}

void Expander::setAttribute(const XmlNode& node, const Context& context) {
  const std::string name = interpreter_.textOfText(required(node, "name"), context.symbols);
  const std::string value = interpreter_.textOfText(required(node, "value"), context.symbols);
  if (name.empty()) throw Fault("<xacro:attribute> with an empty name", "a name");
  if (!context.parent) return;
  std::erase_if(context.parent->attributes, [&](const XmlNode::Attribute& one) { return one.name == name; });
  budget_.take(sizeof(XmlNode::Attribute) + name.size() + value.size());
  context.parent->attributes.push_back({name, value, node.line});
}

void Expander::insertBlock(const XmlNode& node, const Context& context, Nodes& out) {
  checkAttributes(node, {"name"});
  const std::string& name = required(node, "name");
  const Value* content = context.symbols.find("**" + name, interpreter_);
  const Value* whole = content ? content : context.symbols.find("*" + name, interpreter_);
  if (!whole)
    throw Fault("the block '" + name + "' is not defined", "a block of the macro, or a property with elements");
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
  const std::string name = interpreter_.textOfText(required(node, "name"), symbols);
  if (!isIdentifier(name) || name.starts_with("__"))
    throw Fault("a property with the name '" + name.substr(0, 60) + "'",
                "letters, digits and _, no word of Python's, no __ in front");
  const bool remove = truth(optional(node, "remove", "false"), symbols);
  const XmlNode::Attribute *value = node.attribute("value"), *otherwise = node.attribute("default");
  if ((value ? 1 : 0) + (otherwise ? 1 : 0) + (remove ? 1 : 0) > 1)
    throw Fault("the property '" + name + "' with more than one of value, default and remove", "one of them");
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
  bool lazy = truth(optional(node, "lazy_eval", "true"), symbols);
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
    warn("scope=\"" + where + "\" is not known; the property '" + name + "' is set where it stands");
  }
  if (const std::string* text = value.text(); text && !lazy)
    value = interpreter_.evaluateText(std::string(*text), symbols);
  budget_.take(sizeof(Value) * 4 + name.size() + (value.text() ? value.text()->size() : 0));
  target->set(name, std::move(value), lazy);
}

}  // namespace hapticell::xacro
