// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "haptic/devices/drivers/falcon/ftdi_port.h"

namespace hapticell::driver {

/// Sets the chip to the mode for communication with the firmware.
bool setFalconRunning(FtdiPort& port);

/// True if the firmware is already running: it answers a packet of zero forces.
bool falconAnswers(FtdiPort& port);

/// Uploads the firmware (Novint's file, which the user supplies, because its licence does not allow us to ship it),
/// each block of 62 bytes compared with its echo; up to ten attempts from the start. kOk, or the reason of the failure.
Problem uploadFalconFirmware(FtdiPort& port, std::span<const std::uint8_t> firmware);

}  // namespace hapticell::driver
