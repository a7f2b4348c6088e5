// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "kinematics/model/chain.h"
#include "trajectory/programs/writing/program_export.h"

namespace hapticell::manipulation {

/// The configuration of a six-axis arm as written in a program's targets, for ProgramOptions::configuration: KUKA "S
/// 2,T 35", ABB "[0,-1,0,1]", FANUC "N U T, 0, 0, 0". Empty for formats without configurations and for chains without
/// six axes.
std::function<std::string(std::span<const double>)> programConfiguration(std::shared_ptr<const kinematics::Chain> chain,
                                                                         trajectory::ProgramFormat format);

}  // namespace hapticell::manipulation
