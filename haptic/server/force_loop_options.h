// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "haptic/devices/device.h"
#include "haptic/protocol/messages.h"
#include "haptic/rendering/renderer_options.h"
#include "haptic/rendering/safety_chain.h"

namespace hapticell::haptic {

/// Options of a force loop.
struct ForceLoopOptions {
  double rate_hz = 1000.0;
  RendererOptions renderer;  ///< The device's stiffness, damping and delay.
  SafetyOptions safety;
  std::size_t log_ticks = 4096;  ///< Number of ticks that the log keeps.
};

/// The options that follow from what a device can do: its forces, stiffness, damping and delay.
ForceLoopOptions optionsFor(const Device& device, double rate_hz = 1000.0);

/// The description of a device that a client gets at connection.
DeviceDescription describe(const Device& device);

}  // namespace hapticell::haptic
