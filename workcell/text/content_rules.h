// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/text.h"

namespace hapticell::workcell {

/// The one rule of all readers for what a file may hold.
enum class Treatment {
  kUsed,      ///< Read.
  kNoted,     ///< Of no effect on place, shape, size, motion or limits: passed over in silence.
  kReported,  ///< Left out or replaced by an assumption; a warning names file, place and what was assumed.
  kRefused,   ///< The file is not read; one sentence says why.
};

/// "used", "noted", "reported", "refused".
const char* toString(Treatment treatment);

/// What one reader does with one kind of content.
struct ContentRule {
  std::string_view element;  ///< "parent/child" of an XML format, the name of an extension or entity otherwise.
  Treatment treatment = Treatment::kUsed;
  const char* meaning = "";  ///< In warnings: what is missing or assumed; a Text's id.
};

/// A format and all that its reader knows; docs/user/formats-content.md shows them as a table, kept equal by a test.
struct FormatRules {
  std::string_view format;
  std::span<const ContentRule> rules;
};

/// Of all formats that have a table.
std::span<const FormatRules> contentRules();

/// What one file holds, measured against the table of its format, and reported in one sentence per element.
class ContentReport {
 public:
  /// `format` must be one of contentRules().
  explicit ContentReport(std::string_view format);

  /// The rule for `element`; null where the table has none.
  const ContentRule* rule(std::string_view element) const;
  /// How it is treated; where it is to be reported, `place` ("'arm'", "line 12") is remembered. What the table does not
  /// know is reported as unknown, unless its name has a colon: such elements belong to other programs and are noted.
  Treatment meet(std::string_view element, const Text& place);
  /// One warning for each element that was to be reported, with the first places; in the order of the names.
  void tell(std::vector<Text>& warnings) const;

 private:
  const FormatRules* rules_;
  std::map<std::string, std::vector<Text>> reported_;
};

}  // namespace hapticell::workcell
