// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/openhaptics/open_haptics_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::OpenHapticsDriver)
