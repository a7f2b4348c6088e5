// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"
#include "cli/session/session_plan.h"
#include "manipulation/session/session.h"

namespace hapticell::cli {

/// Applies one `KEY=VALUE` of the command session: moved_by, axes, scale, force_class, on_contact, forces,
/// safety_distance, plan_goal, plan_hints (into `plan`), plan_authority, plan_clearance, or any key of hapticell.toml. An
/// unknown key or a bad value is an error that lists the possible ones; `options` are then unchanged.
Expected<void> applySessionSetting(const std::string& setting, manipulation::SessionOptions& options, SessionPlanWords& plan);

/// The profile of a simulated device by its name: phantom_desktop, touch, touch_x, premium, premium_6dof. Errors:
/// another name.
Expected<config::DeviceProfile> simulatedDevice(const std::string& name);

}  // namespace hapticell::cli
