// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::SpaceMouseDriver(hapticell::driver::makeHidapi(),
                                                         hapticell::driver::makeSpacenav()))
