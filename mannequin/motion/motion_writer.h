// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "mannequin/body/figure.h"
#include "mannequin/posture/posture.h"

namespace hapticell::mannequin {

/// Postures of a figure as BVH: H-Anim joint names, centimetres, Y up, at rest facing Z with the arms hanging (zero
/// posture). Only the joints of segments; fingers are omitted.
std::string bvhText(const Figure& figure, std::span<const Posture> postures, double frame_time);

/// A figure in a posture as X3D (ISO/IEC 19775) with an H-Anim humanoid (ISO/IEC 19774): metres, Y up, facing Z; joint
/// centres at zero posture, their rotations for the posture.
std::string hanimText(const Figure& figure, const Posture& posture, const std::string& name);

}  // namespace hapticell::mannequin
