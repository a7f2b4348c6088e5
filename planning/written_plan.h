// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "manipulation/scene/prepared_scene.h"
#include "planning/plan.h"

namespace hapticell::planning {

/// Reads the motion that was written for a plan, and measures what was promised: the clearance to all but the entity's
/// own parts, no contact on the way (checkPath(), continuously), joints within their limits, and the ends of the plan.
///
/// The clearance is measured at the frames and at places between them, so close that no part moves by more than about
/// 2 mm from one to the next. Shares nothing with the code that plans: the scene is asked by manipulation/checks.
/// Promises: "clearance" (m), "contacts" and "limits" (findings), "start" and "goal" (m or rad of the worst number).
/// Errors: the file cannot be read, or is of another entity.
Expected<Promises> writtenPlanPromises(const std::filesystem::path& written, const Plan& plan, double clearance,
                                       const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                       workcell::EntityId entity, const config::Configuration& configuration = {});

}  // namespace hapticell::planning
