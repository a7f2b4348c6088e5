// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// Sine and cosine of every joint angle.
struct SineCosine {
  JointAngles sine;
  JointAngles cosine;
};

/// Computes all at once by Taylor polynomials on [-45, 45] deg after removing quarter turns: written so that the
/// compiler can process several angles per instruction, and independent of the system's libm, so that results are the
/// same on every machine. Angles beyond 1e5 rad are not supported (contract of the callers: joint angles).
void sinesAndCosines(const JointAngles& angles, SineCosine& result);

}  // namespace hapticell::mannequin
