// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "manipulation/scene/prepared_scene.h"
#include "mannequin/posture/posture.h"

namespace hapticell::manipulation {

/// Which pairs of a body and a part of the cell count.
enum class BodyPairs {
  kChecked,  ///< Those that the cell's rules leave out do not.
  kAll,      ///< All; what is attached to the body alone does not.
};

/// Name of an entity that the body enters in this posture, apart from hands (they touch the work) and from what it
/// carries; empty: none. `body` is a mannequin of the scene. Any thread.
std::string enteredByBody(const PreparedScene& scene, const workcell::Entity& body, const mannequin::Posture& posture,
                          BodyPairs pairs = BodyPairs::kChecked);

}  // namespace hapticell::manipulation
