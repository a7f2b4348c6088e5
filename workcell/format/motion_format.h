// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "workcell/text/field_reader.h"
#include "workcell/entity/scripted_motion.h"

namespace hapticell::workcell {

/// {"path": [[t, x, y, z], ...], "repeat": "once" | "loop" | "back"}
Json jsonFromMotion(const ScriptedMotion& motion);
/// Reads and checks one; `place` is what messages call its entity.
ScriptedMotion motionFromJson(const Json& json, const std::string& place, std::optional<Error>& error,
                              Diagnostics& diagnostics);

}  // namespace hapticell::workcell
