// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/format/format_context.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// Writes the fields of robots, mechanisms and mannequins: joints, tool, tools, named poses. Does nothing for others.
void addRobotFields(const Entity& entity, Json& json);

/// Reads these fields into an entity that has its model. Messages use `place`.
void readRobotFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity);

}  // namespace hapticell::workcell
