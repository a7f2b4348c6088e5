// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"
#include "workcell/text/file_content.h"

namespace hapticell {

/// Results of the command line contain a text in plain English.
template <typename Json>
void to_json(Json& json, const Text& text) {
  json = english(text);
}

}  // namespace hapticell

namespace hapticell::cli {

/// Writes the one JSON document that is a command's result: to standard output, or to the file of `--json` ("-": also
/// standard output).
///
/// A file is written as a temporary file and moved into place, so that no partial result can be read.
class ResultWriter {
 public:
  explicit ResultWriter(std::string json_file = {}) : json_file_(std::move(json_file)) {}
  Expected<void> write(const nlohmann::ordered_json& result) const;
  /// The same on a separate line, for a command that reports more than once; a file has the newest result.
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
/// Null for a number that is not finite, because JSON has no infinity.
nlohmann::ordered_json finiteOrNull(double value);
/// Six significant digits, for a sentence.
std::string shortNumber(double value);

/// Prints a text that is no JSON document on standard output, as it is; to a CommandListener if there is one.
Expected<void> printText(const std::string& text);

/// Prints "hapticell-cli: SENTENCE" on standard error; a CommandListener gets the error itself.
void report(const Error& error);
void warn(const Text& sentence);

}  // namespace hapticell::cli
