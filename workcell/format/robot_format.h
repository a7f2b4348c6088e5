// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/format/format_context.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// What robots, mechanisms and mannequins have besides: joints, tool, tools, named poses. Nothing for others.
void addRobotFields(const Entity& entity, Json& json);

/// Reads them into an entity whose model is there; Messages use `place`.
void readRobotFields(FieldReader& fields, const Text& place, const FormatContext& context, Entity& entity);

}  // namespace hapticell::workcell
