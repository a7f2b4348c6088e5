// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/text.h"

namespace hapticell::workcell {

/// How a reader treats one kind of content; the same rules for all readers.
enum class Treatment {
  kUsed,      ///< Read.
  kNoted,     ///< No effect on pose, shape, size, motion or limits: ignored silently.
  kReported,  ///< Left out or replaced by an assumption; a warning names file, position and assumption.
  kRefused,   ///< The file is not read; one sentence says why.
};

/// "used", "noted", "reported", "refused".
const char* toString(Treatment treatment);

/// How one reader treats one kind of content.
struct ContentRule {
  std::string_view element;  ///< "parent/child" for an XML format, else the name of an extension or entity.
  Treatment treatment = Treatment::kUsed;
  const char* meaning = "";  ///< In warnings: what is missing or assumed; a Text's id.
};

/// A format and the content known to its reader; a test compares it with the table in docs/user/formats-content.md.
struct FormatRules {
  std::string_view format;
  std::span<const ContentRule> rules;
};

/// The rules of all formats with a table.
std::span<const FormatRules> contentRules();

/// The content of one file, compared with the table of its format, and reported in one sentence per element.
class ContentReport {
 public:
  /// `format` must be one of contentRules().
  explicit ContentReport(std::string_view format);

  /// The rule for `element`; null if the table has none.
  const ContentRule* rule(std::string_view element) const;
  /// Returns how an element is treated; if it is reported, stores `place` ("'arm'", "line 12"; empty: the whole
  /// file). An element missing in
  /// the table is reported as unknown, unless its name has a colon: such elements are of other programs and noted.
  Treatment meet(std::string_view element, const Text& place);
  /// One warning for each element to report, with its first places; in the order of the names.
  void tell(std::vector<Text>& warnings) const;

 private:
  const FormatRules* rules_;
  std::map<std::string, std::vector<Text>> reported_;
};

}  // namespace hapticell::workcell
