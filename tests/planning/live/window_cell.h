// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "geometry/shapes/shapes.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/session/session.h"
#include "planning/live/live_planner.h"
#include "tests/manipulation/session/test_cells.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::planning::test {

/// A box (1) of 40 mm before a wall (2 to 5) with a window of 80 mm that is beside the straight way.
inline std::vector<workcell::Entity> windowCell() {
  using manipulation::test::solid;
  return {solid(1, "box", geometry::makeBox(dvec3(0.04)), Pose::translation({-0.1, 0.0, 0.0})),
          solid(2, "left", geometry::makeBox({0.02, 0.2, 0.4}), Pose::translation({0.0, -0.04, 0.0})),
          solid(3, "right", geometry::makeBox({0.02, 0.1, 0.4}), Pose::translation({0.0, 0.19, 0.0})),
          solid(4, "above", geometry::makeBox({0.02, 0.4, 0.16}), Pose::translation({0.0, 0.0, 0.12})),
          solid(5, "below", geometry::makeBox({0.02, 0.4, 0.16}), Pose::translation({0.0, 0.0, -0.12}))};
}

inline LiveOptions throughWindow() {
  LiveOptions options;
  options.goal = goal::ToPose{Pose::translation({0.1, 0.0, 0.0})};
  options.in_virtual_time = true;
  return options;
}

inline manipulation::PlanView viewOf(const std::shared_ptr<const manipulation::PreparedScene>& scene) {
  manipulation::PlanView view;
  view.scene = scene;
  view.entity = 1;
  view.standing.X_WE = view.X_WM = scene->find(1)->X_WE;
  view.trail = std::make_shared<const manipulation::Trail>(manipulation::Trail{view.standing});
  return view;
}

inline std::shared_ptr<const manipulation::PreparedScene> prepared() {
  return manipulation::PreparedScene::prepare(windowCell(), {}, {});
}

/// By the check of whole motions, which shares nothing with the search; poses of the box.
inline void expectFree(const std::vector<Pose>& X_WE) {
  trajectory::Trajectory motion;
  motion.entity = "box";
  for (std::size_t i = 0; i < X_WE.size(); ++i) motion.addFrame({.t = static_cast<double>(i), .X_WT = X_WE[i]});
  const auto checked = manipulation::checkPath(prepared(), "box", motion, {}, {});
  ASSERT_TRUE(checked.has_value()) << checked.error().message();
  EXPECT_TRUE(checked->findings.empty());
}

}  // namespace hapticell::planning::test
