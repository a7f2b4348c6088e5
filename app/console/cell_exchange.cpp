// SPDX-License-Identifier: Apache-2.0
#include "app/console/cell_exchange.h"

#include "app/console/state_commands.h"
#include "workcell/format/document_io.h"

namespace hapticell::app {

CellText cellTextOf(const workcell::DocumentState& state, const std::filesystem::path& document) {
  const std::filesystem::path folder = document.empty() ? std::filesystem::path("/") : document.parent_path();
  return {workcell::documentText(state, folder), folder, document};
}

Expected<std::vector<workcell::Command>> commandsFromText(const std::string& text, const std::filesystem::path& folder,
                                                          const workcell::DocumentState& now) {
  Diagnostics diagnostics;
  workcell::LoadOptions options;
  options.keep_unloaded = true;
  options.known = &now;
  const auto wanted = workcell::parseDocument(text, folder, "Python", diagnostics, options);
  HAPTICELL_TRY(wanted);
  return commandsBetween(now, wanted->state());
}

}  // namespace hapticell::app
