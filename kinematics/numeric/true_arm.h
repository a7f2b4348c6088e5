// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/model/chain.h"
#include "kinematics/kernels/kernels.h"

namespace hapticell::kinematics {

/// True when each joint of the chain has a variable of its own and there are no more than eight behind the first
/// `slides`: what a kernels::TrueArm can hold.
bool fitsTrueArm(const Chain& chain, std::size_t slides = 0);

/// The chain's joints with frames chosen so that each turns about, or slides along, its z; the first `slides`, which
/// must be slides, stand at zero.
kernels::TrueArm trueArm(const Chain& chain, std::size_t slides = 0);

}  // namespace hapticell::kinematics
