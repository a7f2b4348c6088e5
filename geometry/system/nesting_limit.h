// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "geometry/system/error.h"

namespace hapticell::geometry {

/// Kinds of text whose libraries recurse as deep as the text nests.
enum class NestedText {
  kJson,
  kOrderedJson,  ///< JSON whose reader compares each member's name with all before it in its object.
  kXml,
  kToml,
};

/// Levels of lists, objects, elements or tables; real files have fewer than 30.
inline constexpr int kDeepestNesting = 200;
inline constexpr int kDeepestToml = 50;              ///< Brackets, and names in a dotted key.
inline constexpr std::size_t kMostMembers = 2000;    ///< Of one object of kOrderedJson.
inline constexpr std::size_t kMostAttributes = 200;  ///< Of one XML element: the reader compares each with all before.

/// Checks a text before a library reads it. If the nesting, the members or the attributes exceed the limits above, it
/// returns an error that names `file` and the line. It does not report invalid JSON, XML or TOML; the reader does. It
/// never counts less nesting than the reader. Linear time; memory only for the levels.
Expected<void> checkNesting(std::string_view text, NestedText kind, const std::string& file);

}  // namespace hapticell::geometry
