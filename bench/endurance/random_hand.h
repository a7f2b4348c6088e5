// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "haptic/devices/hand_path.h"

namespace hapticell::endurance {

/// A hand that wanders through the device's workspace for `duration` seconds: smooth ways between random places (within
/// 70 mm, turned by up to 20 degrees), some slow, some as quick as 0.6 m/s, pauses, and a button that takes and lets
/// go.
haptic::HandPath randomHand(std::mt19937_64& random, double duration);

}  // namespace hapticell::endurance
