// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::agents {

/// The table of a section as it was read; SectionReader reads it.
struct AgentTable;

/// A table [[agent]] of a task with its place.
struct AgentSection {
  std::shared_ptr<const AgentTable> table;  ///< Lives as long as its task.
  std::string kind;  ///< Value of its key `what`.
  double weight = 1.0;
  bool enabled = true;
  std::filesystem::path file;

  /// An error about this section.
  Error fault(Text found, Text expected, Text fix = {}) const;
};

}  // namespace hapticell::agents
