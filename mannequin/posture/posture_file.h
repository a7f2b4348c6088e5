// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/system/error.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// A posture as a JSON text: {"format":"hapticell-posture","version":1,"root":{"position":[x,y,z],"orientation":
/// [w,x,y,z]},"joints":{"l_elbow_flexion":0.5, ...}} in metres and radians, all 56 joints by name
/// (docs/user/formats.md).
std::string postureText(const Posture& posture);

/// Reads such a text; messages use `name`. Joints that are not listed are 0; "unit":"deg" next to "joints" means
/// degrees. `has_root`, if given, receives whether the text gives the pose of the root. Errors: invalid JSON, an
/// unknown joint, an invalid number or one beyond +-7 rad, a newer version. Limits are not checked here
/// (limitViolations()).
Expected<Posture> parsePosture(std::string_view text, const std::string& name, bool* has_root = nullptr);
Expected<Posture> readPosture(const std::filesystem::path& file, bool* has_root = nullptr);

}  // namespace hapticell::mannequin
