// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/cyberglove/cyberglove_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::CyberGloveDriver)
