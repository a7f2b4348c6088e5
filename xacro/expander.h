// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "xacro/budget.h"
#include "xacro/evaluator.h"
#include "xacro/expand.h"
#include "xacro/macro.h"
#include "xacro/source_files.h"
#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// Turns a tree with xacro's elements into one without: the work of expand(). Throws Fault.
class Expander {
 public:
  Expander(const Arguments& arguments, const Files& files, std::vector<DeclaredArgument>& declared,
           Diagnostics& diagnostics);

  /// The root element, expanded.
  XmlPointer run(const std::filesystem::path& file);
  const std::vector<std::filesystem::path>& files() const { return sources_.all(); }
  std::string nameOf(int file) const { return sources_.nameOf(file); }

 private:
  /// The context in which an element is expanded.
  struct Context {
    Scope& symbols;
    MacroScope& macros;
    XmlNode* parent;  ///< Gets what <xacro:attribute> says.
  };
  using Nodes = std::vector<XmlPointer>;

  void expandChildren(const XmlNode& node, const Context& context, Nodes& out);
  void expandNode(const XmlPointer& node, const Context& context, Nodes& out);
  void expandElement(const XmlNode& node, const Context& context, Nodes& out);
  bool expandStatement(const XmlNode& node, const Context& context, Nodes& out);
  void copyElement(const XmlNode& node, std::string name, const Context& context, Nodes& out);
  void copyText(const XmlNode& node, const Context& context, Nodes& out);

  void include(const XmlNode& node, const Context& context, Nodes& out);
  Context nameSpace(const std::string& name, const Context& context);
  void includeFile(const std::filesystem::path& file, const Context& context, Nodes& out);
  void property(const XmlNode& node, const Context& context);
  void setProperty(const XmlNode& node, const std::string& name, Value value, Scope& symbols);
  void defineMacro(const XmlNode& node, const Context& context);
  void defineArgument(const XmlNode& node, const Context& context);
  void condition(const XmlNode& node, const Context& context, Nodes& out);
  void insertBlock(const XmlNode& node, const Context& context, Nodes& out);
  void setAttribute(const XmlNode& node, const Context& context);
  void callMacro(const XmlNode& node, const std::string& full_name, const Context& context, Nodes& out);
  const Macro* findMacro(const std::string& full_name, Scope*& caller, MacroScope*& macros);

  const std::string& required(const XmlNode& node, const char* attribute) const;
  std::string optional(const XmlNode& node, const char* attribute, const char* otherwise) const;
  void checkAttributes(const XmlNode& node, std::initializer_list<const char*> known);

  Budget budget_;
  SourceFiles sources_;
  Evaluator evaluator_;
  std::deque<MacroScope> macro_scopes_;
  std::vector<Text> calls_;  ///< "macro 'arm' called in FILE line 3", innermost last.
};

}  // namespace hapticell::xacro
