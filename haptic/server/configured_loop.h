// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/configuration.h"
#include "haptic/devices/simulated_hand.h"
#include "haptic/server/force_loop.h"

namespace hapticell::haptic {

/// The device's default options, overridden by the configuration.
ForceLoopOptions configuredLoop(const Device& device, const config::Configuration& configuration);

/// The hand on a simulated stylus, from the configuration.
HandOptions configuredHand(const config::Configuration& configuration);

}  // namespace hapticell::haptic
