// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config/configuration.h"
#include "haptic/rendering/held_load.h"
#include "manipulation/holding/motion_mapping.h"
#include "workcell/entity/entity.h"

namespace hapticell::manipulation {

/// The load of a held entity that the hand feels, by its force class: nothing (constant), the weight that remains after
/// gravity compensation (contact), or that plus inertia and damping (dynamics). The weight points down in the cell, is
/// converted to the device's axes, and is at most half of the motors' continuous force.
haptic::LoadOptions feltLoad(const workcell::Entity& entity, workcell::ForceClass force_class,
                             const config::Configuration::Manipulation& settings, const MotionMapping& mapping,
                             double continuous_force);

}  // namespace hapticell::manipulation
