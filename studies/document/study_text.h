// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::studies {

/// A value of a study document that can be edited; empty: the key is not there.
using StudyValue =
    std::variant<std::monostate, bool, double, std::string, std::vector<double>, std::vector<std::string>>;
/// As the document has it: `"robot"`, `0.5`, `[1, 2]`. Numbers with all digits that they need. @pre not empty
std::string tomlText(const StudyValue& value);

/// A table of a study document: `[[vary]]` number 2, `[sampling]`, or the keys above the first table.
struct StudyPlace {
  std::string table = {};  ///< "vary", "ask", "require", "objective"; "sampling", "search"; empty: the top.
  std::size_t index = 0;   ///< Of the tables of this name; 0 for "sampling", "search" and the top.
  bool operator==(const StudyPlace&) const = default;
};

/// The text of a study document, changed key by key: comments, order, layout and all keys that the caller does not know
/// stay as they are. A value; one thread at a time. Every change gives text that is TOML, or an error and no change.
class StudyText {
 public:
  /// An empty document.
  StudyText() = default;
  /// Any text that is TOML; whether it is a study is for StudyDocument. Error: line and reason. `file` names it.
  static Expected<StudyText> parse(std::string text, const std::string& file);

  const std::string& text() const { return text_; }
  /// Number of tables `[[table]]`; of `[table]` 0 or 1.
  std::size_t count(const std::string& table) const;
  /// Keys of a table in their order. Empty if there is no such table.
  std::vector<std::string> keys(const StudyPlace& place) const;
  /// Empty if the key is not there, or has a value of another kind (a date, a table, a mixed list).
  StudyValue value(const StudyPlace& place, std::string_view key) const;
  /// The text of a word; empty if it is not a word.
  std::string word(const StudyPlace& place, std::string_view key) const;
  /// The value as it is written, of any kind; empty if the key is not there.
  std::string written(const StudyPlace& place, std::string_view key) const;

  /// Sets a key; an empty value removes it. `[sampling]` and `[search]` are added if they are missing. Errors: no such
  /// table; a table that is written inside a line, which can only be edited as text.
  Expected<void> set(const StudyPlace& place, std::string_view key, const StudyValue& value);
  /// Adds a table `[[table]]` behind the last one of this name, else at the end.
  Expected<void> add(const std::string& table, const std::vector<std::pair<std::string, StudyValue>>& keys);
  /// Removes a table with its keys, and the comment lines right above it.
  Expected<void> remove(const StudyPlace& place);

 private:
  Expected<void> replace(std::string text);

  std::string text_;
};

}  // namespace hapticell::studies
