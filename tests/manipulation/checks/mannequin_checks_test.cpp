// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "manipulation/checks/mannequin_sight.h"
#include "tests/manipulation/manipulators/worker.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;

TEST(TargetSight, AWallHidesWhatIsBehindIt) {
  const workcell::Entity entity = worker("standing");
  const workcell::Entity target = box(8, "target", dvec3(0.2), {2.0, 0.0, 1.6});
  const auto posture = mannequin::toPosture(*entity.figure(), {entity.X_WE, entity.joints()});
  const auto free = test::workerScene({entity, target});
  const TargetSight seen = sightOfTarget(*free, entity, posture, 8);
  EXPECT_NEAR(seen.seen, 1.0, 1e-12);
  EXPECT_NEAR(seen.distance, 1.9, 0.15);
  EXPECT_NE(seen.zone, mannequin::VisionZone::kOutside);
  const auto walled = test::workerScene({entity, target, box(9, "wall", {0.02, 2.0, 2.0}, {1.0, 0.0, 1.5})});
  const TargetSight hidden = sightOfTarget(*walled, entity, posture, 8);
  EXPECT_NEAR(hidden.seen, 0.0, 1e-12);
  EXPECT_EQ(hidden.hidden_by, "wall");
  EXPECT_EQ(hidden.clearance, 0.0);
}

}  // namespace
}  // namespace hapticell::manipulation
