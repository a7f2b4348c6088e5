// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "workcell/format/format_context.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// "solid", "robot" ...: wordOf() each EntityKind, in its order.
const std::vector<std::string>& entityKindWords();

/// In the order of OnContact: the values of "on_contact" in files.
inline const std::vector<std::string> kOnContactWords = {"stop", "slide", "pass"};

Json jsonFromEntity(const Entity& entity, const std::filesystem::path& folder);

/// Reads the fields of every entity (placement, colour, flags, frames, attachment, collision shape) and those of robots
/// into an entity that has its shape. Messages use `place`.
void readEntityFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity);

}  // namespace hapticell::workcell
