// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "haptic/devices/drivers/falcon/ftdi_port.h"

namespace hapticell::driver {

/// Puts the chip into the mode in which the firmware is spoken to.
bool setFalconRunning(FtdiPort& port);

/// True when the firmware runs already: it answers a packet of zero forces.
bool falconAnswers(FtdiPort& port);

/// Uploads the firmware (Novint's file, which the user supplies: its licence does not let it be shipped), each block of
/// 62 bytes compared with its echo; up to ten attempts from the start. kOk, or why not.
Problem uploadFalconFirmware(FtdiPort& port, std::span<const std::uint8_t> firmware);

}  // namespace hapticell::driver
