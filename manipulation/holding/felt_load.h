// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/configuration.h"
#include "haptic/rendering/held_load.h"
#include "manipulation/holding/motion_mapping.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// What of a held entity's mass the hand is to feel, by its force class: nothing (constant), what gravity compensation
/// leaves of its weight (contact), that and inertia and damping (dynamics). The weight points down in the cell, turned
/// into the device's axes, and is at most half of what the motors bear for ever.
haptic::LoadOptions feltLoad(const workcell::Entity& entity, workcell::ForceClass force_class,
                             const config::Configuration::Manipulation& settings, const MotionMapping& mapping,
                             double continuous_force);

}  // namespace hapticell::manipulation
