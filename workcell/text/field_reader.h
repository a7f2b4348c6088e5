// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::workcell {

using Json = nlohmann::ordered_json;

/// Reads the members of one JSON object with checks. A missing member leaves its target unchanged. A field of the wrong
/// kind is stored as the error (the first one counts), and later calls have no effect, so the caller need not check
/// each call.
class FieldReader {
 public:
  /// `object` must outlive this; `place` names it in messages ("entity 'table'").
  FieldReader(const Json& object, Text place, std::optional<Error>& error);

  void read(const char* key, std::string& target);
  void read(const char* key, bool& target);
  void read(const char* key, double& target);  ///< Finite.
  void read(const char* key, Pose& target);    ///< {"position": [x, y, z], "quaternion": [w, x, y, z]}
  void read(const char* key, std::vector<std::string>& target);
  void read(const char* key, std::map<std::string, std::string>& target);  ///< {"name": "text", …}
  /// Exactly `count` finite numbers.
  bool readNumbers(const char* key, std::size_t count, std::vector<double>& target);
  /// One of the words; `target` gets its index.
  void readWord(const char* key, const std::vector<std::string>& words, int& target);
  /// The member if it is of that kind (array or object); null if missing.
  const Json* array(const char* key);
  const Json* object(const char* key);

  void require(const char* key);
  /// Warns of members that were not read: otherwise, a misspelt key would silently have no effect.
  void warnAboutOthers(Diagnostics& diagnostics) const;
  void fail(const std::string& key, Text found, Text expected);

 private:
  const Json* member(const char* key);

  const Json& object_;
  Text place_;
  std::optional<Error>& error_;
  std::set<std::string> asked_;
};

/// JSON text with one member per line, and lists of plain values in one line. Ends with a newline.
std::string prettyText(const Json& value);

Json toJson(const Pose& pose);

}  // namespace hapticell::workcell
