// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "workcell/entity/scripted_motion.h"
#include "workcell/text/field_reader.h"

namespace hapticell::workcell {

/// {"path": [[t, x, y, z], ...], "repeat": "once" | "loop" | "back"}
Json jsonFromMotion(const ScriptedMotion& motion);
/// Reads and checks a motion; `place` names its entity in messages.
ScriptedMotion motionFromJson(const Json& json, const Text& place, std::optional<Error>& error,
                              Diagnostics& diagnostics);

}  // namespace hapticell::workcell
