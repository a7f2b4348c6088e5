// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "agents/task/agent_section.h"
#include "workcell/text/toml_fields.h"

namespace hapticell::agents {

struct AgentTable {
  const toml::table& toml;
};

/// One table of a task as its reader gets it: fields with checks, and the error with the file's name.
///
///     SectionReader reader(section);
///     reader.fields().read("within", within_);
///     HAPTICELL_TRY(reader.end());
class SectionReader {
 public:
  /// A section's table; its keys `what`, `weight` and `enabled` count as read.
  explicit SectionReader(const AgentSection& section);
  /// Another table of the file; it lives as long as that.
  SectionReader(const toml::table& table, std::string name, std::filesystem::path file)
      : file_(std::move(file)), fields_(table, std::move(name), error_) {}
  SectionReader(const SectionReader&) = delete;
  SectionReader& operator=(const SectionReader&) = delete;

  workcell::TomlFields& fields() { return fields_; }
  /// Refuses keys that nobody asked for. The first fault, with file, line and key.
  Expected<void> end();
  /// The first fault so far.
  Expected<void> check() const;

 private:
  std::filesystem::path file_;
  std::optional<Error> error_;
  workcell::TomlFields fields_;
};

}  // namespace hapticell::agents
