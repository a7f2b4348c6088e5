// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"
#include "workcell/text/file_content.h"

namespace hapticell {

/// In results of the command line a text is plain English.
template <typename Json>
void to_json(Json& json, const Text& text) {
  json = english(text);
}

}  // namespace hapticell

namespace hapticell::cli {

/// Writes the one JSON document that is a command's result: to standard output, or to the file of `--json` ("-":
/// standard output too).
///
/// A file is written aside and moved into place, so a half-written result never stands there.
class ResultWriter {
 public:
  explicit ResultWriter(std::string json_file = {}) : json_file_(std::move(json_file)) {}
  Expected<void> write(const nlohmann::ordered_json& result) const;
  /// The same on a line of its own, for a command that tells more than once; a file has the newest one.
  Expected<void> writeLine(const nlohmann::ordered_json& result) const;
  /// True if `--json` was given, for commands that otherwise print text.
  bool isAsked() const { return !json_file_.empty(); }

 private:
  bool toFile() const { return !json_file_.empty() && json_file_ != "-"; }
  Expected<void> put(const nlohmann::ordered_json& result, int indent) const;

  std::string json_file_;
};

using workcell::writeFileAtomically;

/// [x, y, z]
nlohmann::ordered_json toJson(const dvec3& v);
/// JSON has no infinity: null stands for what is no finite number.
nlohmann::ordered_json finiteOrNull(double value);
/// For a sentence: six significant digits.
std::string shortNumber(double value);

/// Prints "hapticell-cli: SENTENCE" on standard error.
void report(const Error& error);
void warn(const Text& sentence);

}  // namespace hapticell::cli
