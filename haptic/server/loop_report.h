// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptic/server/loop_statistics.h"

namespace hapticell::haptic {

/// The force loop's figures in words and as a lateness histogram, several lines, for the terminal.
std::string loopReport(const LoopFigures& figures);

}  // namespace hapticell::haptic
