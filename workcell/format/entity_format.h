// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "workcell/format/format_context.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// "solid", "robot" ...: wordOf() each EntityKind, in its order.
const std::vector<std::string>& entityKindWords();

/// As OnContact: what "on_contact" says in files.
inline const std::vector<std::string> kOnContactWords = {"stop", "slide", "pass"};

Json jsonFromEntity(const Entity& entity, const std::filesystem::path& folder);

/// Reads what every entity has (placement, colour, flags, frames, attachment, what it is checked by) and what robots
/// have, into one whose shape is there. Messages use `place`.
void readEntityFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity);

}  // namespace hapticell::workcell
