// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "xacro/expand.h"
#include "xacro/interpreter.h"
#include "xacro/macro.h"
#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// Turns a tree with xacro's elements into one without: the work of expand(). Throws Fault.
class Expander : public Surroundings {
 public:
  Expander(const Arguments& arguments, const Files& files, std::vector<DeclaredArgument>& declared,
           Diagnostics& diagnostics);

  /// The root element, expanded.
  XmlPointer run(const std::filesystem::path& file);
  const std::vector<std::filesystem::path>& files() const { return files_read_; }
  std::string nameOf(int file) const;

  Value substitution(const std::string& words, Scope& scope) override;
  std::string readText(const std::string& reference, std::string& file) override;
  std::string absoluteName(const std::string& reference) override;
  Value argument(const std::string& name) override;
  void warn(const std::string& sentence) override;

 private:
  /// What is known where an element is expanded.
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
  void bindValues(const XmlNode& call, const Macro& macro, Scope& caller, Scope& inside,
                  std::vector<std::string>& open);
  void bindBlocks(const XmlNode& call, const Macro& macro, const Context& context, Scope& inside);
  void bindDefaults(const Macro& macro, Scope& caller, Scope& inside, const std::vector<std::string>& open);

  void report(const std::string& file, int line, const std::string& sentence);
  const std::string& required(const XmlNode& node, const char* attribute) const;
  std::string optional(const XmlNode& node, const char* attribute, const char* otherwise) const;
  void checkAttributes(const XmlNode& node, std::initializer_list<const char*> known);
  bool truth(const std::string& text, Scope& symbols);
  Value evaluateAt(const XmlNode::Attribute& attribute, const XmlNode& node, Scope& symbols);
  std::filesystem::path folder() const {
    return files_read_[static_cast<std::size_t>(file_stack_.back())].parent_path();
  }
  XmlPointer parsed(const std::filesystem::path& file, int& index);
  const DeclaredArgument* findArgument(const std::string& name) const;

  Arguments arguments_;
  const Files& files_;
  std::vector<DeclaredArgument>& declared_;
  Diagnostics& diagnostics_;
  Budget budget_;
  Interpreter interpreter_;
  Scopes scopes_;
  std::deque<MacroScope> macro_scopes_;
  std::vector<std::filesystem::path> files_read_;
  std::map<std::string, std::pair<XmlPointer, int>> parsed_;  ///< By path: a file that is included twice is read once.
  std::vector<int> file_stack_;
  std::vector<std::string> calls_;  ///< "macro 'arm' called in FILE line 3", innermost last.
  const XmlNode* at_ = nullptr;     ///< The element that is worked on.
};

}  // namespace hapticell::xacro
