// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// A parameter of a macro as its "params" has it: "name", "name:=default", "name:=^" (the caller's property of this
/// name), "name:=^|default", "*block", "**block".
struct MacroParameter {
  std::string name;  ///< With the stars of a block.
  bool forwarded = false;
  std::optional<std::string> otherwise;

  bool isBlock() const { return name.starts_with("*"); }
};

struct Macro {
  std::string name;
  std::vector<MacroParameter> parameters;
  XmlPointer body;
};

/// Splits "params". A default is one word, 'words in quotes', ${…} or $(…).
std::vector<MacroParameter> parametersOf(const std::string& text);

/// Macros by name, with those around: of the file, of a name space, or of a macro's own body.
class MacroScope {
 public:
  explicit MacroScope(MacroScope* parent) : parent_(parent) {}
  const Macro* find(const std::string& name) const;
  MacroScope* findSpace(const std::string& name) const;
  void set(Macro macro);
  void setSpace(const std::string& name, MacroScope* space) { spaces_[name] = space; }

 private:
  MacroScope* parent_;
  std::map<std::string, std::shared_ptr<const Macro>> macros_;
  std::map<std::string, MacroScope*> spaces_;
};

}  // namespace hapticell::xacro
