// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "xacro/evaluator.h"
#include "xacro/macro.h"
#include "xacro/scope.h"
#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// Gives the parameters of one call of a macro their values, in the scope of its body: first those of the call, then
/// its blocks, then the defaults. Throws Fault for parameters that are unknown or missing. The constructor's arguments
/// must outlive it.
class MacroCall {
 public:
  MacroCall(const Macro& macro, Scope& caller, Scope& inside, Evaluator& evaluator);

  void bindValues(const XmlNode& call);
  /// `blocks`: the children of the call, expanded.
  void bindBlocks(std::vector<XmlPointer> blocks);
  void bindDefaults();

 private:
  const Macro& macro_;
  Scope& caller_;
  Scope& inside_;
  Evaluator& evaluator_;
  std::vector<std::string> open_;  ///< Parameters that the call gives no value.
};

}  // namespace hapticell::xacro
