// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/configured_loop.h"

namespace hapticell::haptic {

ForceLoopOptions configuredLoop(const Device& device, const config::Configuration& configuration) {
  ForceLoopOptions options = optionsFor(device, configuration.haptic.rate_hz);
  if (configuration.haptic.stiffness > 0.0) options.renderer.stiffness = configuration.haptic.stiffness;
  if (configuration.haptic.damping > 0.0) options.renderer.damping = configuration.haptic.damping;
  options.safety.ramp_time = configuration.haptic.force_ramp_s;
  return options;
}

HandOptions configuredHand(const config::Configuration& configuration) {
  HandOptions options;
  options.mass = configuration.hand.mass;
  options.stiffness = configuration.hand.stiffness;
  options.damping = configuration.hand.damping;
  return options;
}

}  // namespace hapticell::haptic
