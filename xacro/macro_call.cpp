// SPDX-License-Identifier: Apache-2.0
#include "xacro/macro_call.h"

#include <algorithm>

#include "geometry/system/listed.h"
#include "xacro/fault.h"

namespace hapticell::xacro {

MacroCall::MacroCall(const Macro& macro, Scope& caller, Scope& inside, Evaluator& evaluator)
    : macro_(macro), caller_(caller), inside_(inside), evaluator_(evaluator) {
  for (const MacroParameter& parameter : macro.parameters) open_.push_back(parameter.name);
}

void MacroCall::bindValues(const XmlNode& call) {
  for (const XmlNode::Attribute& attribute : call.attributes) {
    if (attribute.name.starts_with("xmlns:") || attribute.name.starts_with("xacro:")) continue;
    const auto place = std::find(open_.begin(), open_.end(), attribute.name);
    if (place == open_.end()) {
      const std::string known = listed(macro_.parameters, &MacroParameter::name);
      throw Fault{.found = Text("the macro '%1' has no parameter '%2'", macro_.name, attribute.name),
                  .expected = known.empty() ? Text("none") : Text("one of %1", known.substr(0, 400))};
    }
    open_.erase(place);
    inside_.set(attribute.name, evaluator_.valueOf(attribute, call, caller_), false);
  }
}

void MacroCall::bindBlocks(std::vector<XmlPointer> blocks) {
  std::erase_if(blocks, [](const XmlPointer& node) { return !node->isElement(); });
  std::size_t next = 0;
  for (const MacroParameter& parameter : macro_.parameters) {
    if (!parameter.isBlock()) continue;
    if (next == blocks.size())
      throw Fault{.found = Text("the call of macro '%1' has no block for %2", macro_.name, parameter.name),
                  .expected = "one element inside the call for each block"};
    inside_.set(parameter.name, blocks[next++], false);
  }
  if (next < blocks.size())
    throw Fault{.found = Text("<%1> inside the call of macro '%2'", blocks[next]->name, macro_.name),
                .expected = Text("%1 blocks", next)};
}

void MacroCall::bindDefaults() {
  std::string missing;
  for (const MacroParameter& parameter : macro_.parameters) {
    if (parameter.isBlock() || std::find(open_.begin(), open_.end(), parameter.name) == open_.end()) continue;
    const Value* forwarded = parameter.forwarded ? caller_.find(parameter.name, evaluator_.interpreter()) : nullptr;
    if (forwarded)
      inside_.set(parameter.name, Value(*forwarded), false);
    else if (parameter.otherwise)
      inside_.set(parameter.name, evaluator_.value(*parameter.otherwise, caller_), false);
    else
      missing += (missing.empty() ? "" : ", ") + parameter.name;
  }
  if (!missing.empty())
    throw Fault{.found = Text("the call of macro '%1' does not set %2", macro_.name, missing.substr(0, 400)),
                .expected = "a value for each parameter"};
}

}  // namespace hapticell::xacro
