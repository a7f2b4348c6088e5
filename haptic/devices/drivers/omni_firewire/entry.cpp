// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/omni_firewire/omni_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::OmniDriver(hapticell::driver::makeRaw1394()))
