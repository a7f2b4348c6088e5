// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/configuration.h"
#include "haptic/devices/simulated_hand.h"
#include "haptic/server/force_loop.h"

namespace hapticell::haptic {

/// What suits the device, with what the configuration says otherwise.
ForceLoopOptions configuredLoop(const Device& device, const config::Configuration& configuration);

/// The hand that holds a simulated stylus, as the configuration describes it.
HandOptions configuredHand(const config::Configuration& configuration);

}  // namespace hapticell::haptic
