// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/chain_lanes.h"
#include "kinematics/kernels/choose_lanes.h"
#include "kinematics/kernels/fit_lanes.h"
#include "kinematics/kernels/frame_lanes.h"
#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/offset_lanes.h"
#include "kinematics/kernels/opw_lanes.h"
#include "kinematics/kernels/seed_lanes.h"
#include "kinematics/kernels/seven_lanes.h"
#include "kinematics/kernels/ur_lanes.h"

namespace hapticell::kinematics::kernels {
namespace {

/// The functions as this translation unit is compiled.
constexpr Table tableNamed(const char* name) {
  return {name,  map,         opw,    opwError, ur,  srs,          srsRing, srsOfRing,
          panda, offsetWrist, polish, axes,     fit, nearestSeeds, choose};
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
