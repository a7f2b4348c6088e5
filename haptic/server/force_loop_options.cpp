// SPDX-License-Identifier: Apache-2.0
#include "haptic/server/force_loop_options.h"

namespace hapticell::haptic {

ForceLoopOptions optionsFor(const Device& device, double rate_hz) {
  const DeviceCapabilities& capabilities = device.capabilities();
  ForceLoopOptions options;
  options.rate_hz = rate_hz;
  options.renderer.stiffness = capabilities.stiffness;
  options.renderer.damping = capabilities.damping;
  options.renderer.peak_force = capabilities.peak_force;
  options.renderer.tick = 1.0 / rate_hz;
  options.safety.peak_force = capabilities.peak_force;
  if (capabilities.driven_axes == 6) {
    options.renderer.peak_torque = options.safety.peak_torque = capabilities.peak_torque;
  }
  options.safety.continuous_force = capabilities.continuous_force;
  // A killed client's socket is closed some milliseconds late, and 50 ms are promised from the kill.
  options.safety.close_decay = 0.02;
  options.renderer.delay = capabilities.delay_ticks / rate_hz;
  options.safety.thermal_time = capabilities.thermal_time;
  return options;
}

DeviceDescription describe(const Device& device) {
  const DeviceCapabilities& c = device.capabilities();
  DeviceDescription description;
  description.name = c.name;
  description.simulated = c.simulated;
  description.workspace_min = c.workspace_min;
  description.workspace_max = c.workspace_max;
  description.resolution = c.resolution;
  description.peak_force = c.peak_force;
  description.continuous_force = c.continuous_force;
  description.stiffness = c.stiffness;
  description.damping = c.damping;
  description.measured_axes = c.measured_axes;
  description.driven_axes = c.driven_axes;
  description.peak_torque = c.peak_torque;
  description.buttons = c.buttons;
  return description;
}

}  // namespace hapticell::haptic
