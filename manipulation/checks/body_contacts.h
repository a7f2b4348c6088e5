// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "manipulation/scene/prepared_scene.h"
#include "mannequin/posture/posture.h"

namespace hapticell::manipulation {

/// Name of an entity that the body enters in this posture, apart from hands (they touch the work), from what it carries
/// and from pairs that the cell's rules leave out; empty: none. `body` is a mannequin of the scene. Any thread.
std::string enteredByBody(const PreparedScene& scene, const workcell::Entity& body,
                          const mannequin::Posture& posture);

}  // namespace hapticell::manipulation
