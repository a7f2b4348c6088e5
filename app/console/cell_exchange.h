// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workcell/document/command.h"

namespace hapticell::app {

/// A cell as the interpreter gets it.
struct CellText {
  std::string text;                ///< workcell::documentText() for `folder`.
  std::filesystem::path folder;    ///< Absolute.
  std::filesystem::path document;  ///< Empty: it has no file yet.
};

/// `document`: absolute, or empty. Any thread.
CellText cellTextOf(const workcell::DocumentState& state, const std::filesystem::path& document);

/// Commands that make the cell `now` what the text says, for a text that came back for cellTextOf(now, ...). Shapes that
/// `now` has are not read again; files are read for others. Errors: of reading; a change that no command of the window
/// makes. Takes as long as reading takes. Any thread.
Expected<std::vector<workcell::Command>> commandsFromText(const std::string& text, const std::filesystem::path& folder,
                                                          const workcell::DocumentState& now);

}  // namespace hapticell::app
