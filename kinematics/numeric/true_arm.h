// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/model/chain.h"

namespace hapticell::kinematics {

/// True if each joint of the chain has its own variable and there are at most eight joints after the first `slides`:
/// the capacity of a kernels::TrueArm.
bool fitsTrueArm(const Chain& chain, std::size_t slides = 0);

/// The joints of the chain with frames such that each turns about, or slides along, its z axis; the first `slides`,
/// which must be slides, are at zero.
kernels::TrueArm trueArm(const Chain& chain, std::size_t slides = 0);

}  // namespace hapticell::kinematics
