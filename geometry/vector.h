// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace hapticell {

/// The one vocabulary of 3-D geometry in headers. Metres, radians, newtons; right-handed, Z up, X forward.
using glm::dmat3;
using glm::dquat;
using glm::dvec3;
using glm::fvec3;

}  // namespace hapticell
