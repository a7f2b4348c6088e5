// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/falcon/falcon_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::FalconDriver(hapticell::driver::usbDevices, hapticell::driver::openFalconPort,
                                                     hapticell::driver::libusbVersion()))
