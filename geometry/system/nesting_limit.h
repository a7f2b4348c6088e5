// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// Texts that are read by libraries which recurse as deep as the text nests.
enum class NestedText {
  kJson,
  kOrderedJson,  ///< JSON whose reader compares each member's name with all before it in its object.
  kXml,
  kToml,
};

/// Levels of lists, objects, elements or tables; those of real files stay under thirty.
inline constexpr int kDeepestNesting = 200;
inline constexpr int kDeepestToml = 50;           ///< Brackets, and names in a dotted key.
inline constexpr std::size_t kMostMembers = 2000;     ///< Of one object of kOrderedJson.
inline constexpr std::size_t kMostAttributes = 200;  ///< Of one XML element: the reader compares each with all before.

/// One look over a text before a library reads it: deeper nesting than above, or more members or attributes, is an error
/// that names `file` and the line. Text that is no JSON, XML or TOML is left to the reader's own complaint: the look is
/// never less strict than it about what nests. Linear in the text, no memory beyond the levels.
Expected<void> checkNesting(std::string_view text, NestedText kind, const std::string& file);

}  // namespace hapticell::geometry
