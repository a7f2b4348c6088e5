// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/drivers/haply/haply_driver.h"

HAPTICELL_DRIVER(new hapticell::driver::HaplyDriver)
