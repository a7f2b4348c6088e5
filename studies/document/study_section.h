// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "workcell/text/toml_fields.h"

namespace hapticell::studies {

/// A table of a study document with its place.
struct StudySection {
  const toml::table* table = nullptr;
  std::string kind;  ///< Value of its key `what`.
  std::string name;  ///< Value of `name`; the kind where it says none.
  std::filesystem::path file;
  std::string list;  ///< "vary" or "ask".

  std::filesystem::path folder() const { return file.parent_path(); }
  /// An absolute path for a file that the document names.
  std::filesystem::path fileNamed(const std::string& path) const;
  /// An error about this section.
  Error fault(Text found, Text expected, Text fix = {}) const;
  /// How errors call it: "vary 'height'".
  std::string title() const;
};

/// One table of a study document as its reader gets it: fields with checks, and the error with the document's name.
///
///     SectionReader reader(section);
///     reader.fields().read("entity", entity_);
///     HAPTICELL_TRY(reader.end());
class SectionReader {
 public:
  /// A section's table; its keys `what` and `name` count as read.
  explicit SectionReader(const StudySection& section);
  /// Another table of the document; it lives as long as that.
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

}  // namespace hapticell::studies
