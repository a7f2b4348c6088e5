// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "manipulation/scene/prepared_scene.h"
#include "planning/plan.h"

namespace hapticell::planning {

/// A pair that the motion leaves at its start, or reaches at its goal, in contact or nearer than the clearance.
struct TightPair {
  std::string moved, met;   ///< "robot/link_4", "fixture"
  double gap = 0.0;         ///< m at the start (the goal); below 0: so deep, by a shift that frees them.
  double t = 0.0;           ///< s: until then it is left; from then on it is reached.
  bool is_reached = false;  ///< At the goal, not at the start.
  Text text() const;        ///< "robot/link_4 touches fixture at the start and is clear of it from 0.4 s on"
};

/// What was measured on a written motion.
struct WrittenPlan {
  Promises promises;
  std::vector<TightPair> tight;
};

/// The files of a plan.
struct WrittenFiles {
  WrittenFiles(std::filesystem::path of_entity, std::vector<std::filesystem::path> of_axes = {})
      : motion(std::move(of_entity)), axes(std::move(of_axes)) {}
  std::filesystem::path motion;
  /// Of a robot's external axes, as motionsOfEntities() gives them; empty: they stay.
  std::vector<std::filesystem::path> axes;
};

/// Reads the motion that was written for a plan, and measures what was promised: the clearance to all but the entity's
/// own parts, no contact on the way (checkPath(), continuously), joints within their limits, and the ends of the plan.
///
/// The clearance is measured at the frames and at places between them, so close that no part moves by more than about
/// 2 mm from one to the next. Shares nothing with the code that plans: the scene is asked by manipulation/checks.
/// Promises: "clearance" (m), "contacts" and "limits" (findings), "start" and "goal" (m or rad of the worst number); with
/// poses to pass "through", with a pose as goal "pose" (m; a radian counts like 0.1 m); of a mannequin "feet" and "balance"
/// (m; see written_poses.h).
/// If the plan leaves contacts, pairs that begin or end in contact or nearer than the clearance are judged by LeavingRule
/// until they are left and once they are reached, and add two promises: "depth" (m) at start and goal, and "closing" (m):
/// by how much a gap becomes smaller that is to open, or larger that is to close. Gaps below 0 are the shortest shift
/// that was found along a few directions.
/// With external axes, "limits" counts their joints too, and there is "axis_speed": the share of the greatest speed of the
/// axes' joints from frame to frame.
/// Errors: a file cannot be read, or is of another entity.
Expected<WrittenPlan> checkWrittenPlan(const WrittenFiles& written, const Plan& plan, double clearance,
                                       const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                       workcell::EntityId entity, const config::Configuration& configuration = {});

/// Its promises alone.
Expected<Promises> writtenPlanPromises(const WrittenFiles& written, const Plan& plan, double clearance,
                                       const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                       workcell::EntityId entity, const config::Configuration& configuration = {});

}  // namespace hapticell::planning
