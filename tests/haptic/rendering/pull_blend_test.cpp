// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/pull_blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "haptic/rendering/force_renderer.h"

namespace hapticell::haptic {
namespace {

TEST(PullBlend, LetsWhatDoesNotChangeThrough) {
  PullBlend blend;
  blend.tick({1.0, 0.0, 0.0}, true, 1e-3);
  for (int i = 0; i < 2000; ++i) blend.tick({1.0, 0.0, 0.0}, false, 1e-3);
  EXPECT_EQ(blend.offset_D(), dvec3(0.0));
  for (int i = 0; i < 10; ++i) {
    const dvec3 pull(0.1 * i, 0.2, 0.0);
    EXPECT_EQ(blend.tick(pull, false, 1e-3), pull) << "a spring without a change of sets is not touched";
  }
}

TEST(PullBlend, IsNeverAJumpAndArrives) {
  PullBlend blend;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> newtons(-2.0, 2.0);
  dvec3 wanted(0.0), before(0.0);
  for (int i = 0; i < 5000; ++i) {
    const bool changed = i % 100 == 0 && i < 4000;
    if (changed) wanted = {newtons(random), newtons(random), newtons(random)};
    const dvec3 felt = blend.tick(wanted, changed, 1e-3);
    EXPECT_LE(glm::length(felt - before), 0.02 + 1e-9) << "tick " << i;
    before = felt;
  }
  EXPECT_NEAR(glm::length(before - wanted), 0.0, 1e-6);
}

/// The same through the renderer: sets that pull elsewhere each time, in free space.
TEST(PullBlend, ARendererWhoseSetsPullElsewhereHasNoSteps) {
  ForceRenderer renderer;
  renderer.reset(Pose::identity());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-0.02, 0.02);
  dvec3 before(0.0);
  double most = 0.0;
  for (int i = 0; i < 3000; ++i) {
    if (i % 17 == 0) {
      ConstraintSet set;
      set.sequence = static_cast<std::uint64_t>(i) + 1;
      set.X_DR = renderer.proxy();
      for (std::uint32_t k = 0; k < 3; ++k) {
        Constraint pull;
        pull.kind = ConstraintKind::kPull;
        pull.group = k;
        pull.gap = part(random);
        pull.gradient[k] = 1.0;
        pull.stiffness = 200.0;
        pull.reach = 0.05;
        set.constraints[set.count++] = pull;
      }
      ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
    }
    const RenderResult result = renderer.tick(Pose::translation({0.01 * std::sin(0.002 * i), 0.0, 0.0}), 1e-3);
    EXPECT_LE(glm::length(result.force_D - before), 0.05) << "tick " << i;
    before = result.force_D;
    most = std::max(most, glm::length(result.force_D));
  }
  EXPECT_GT(most, 1.0) << "something was felt";
}

/// A hand that bounces off a stop: the rest of the force changes by 0.11 N/ms for 10 ms, along the pull and against it.
TEST(PullBlend, GivesWayWhereTheRestChangesFast) {
  for (const double sign : {1.0, -1.0}) {
    PullBlend blend;
    const dvec3 pull(2.0, 0.0, 0.0), rest(sign * 0.11, 0.0, 0.0);
    for (int i = 0; i < 2000; ++i) blend.tick(pull, i == 0, 1e-3);
    dvec3 before = blend.tick(pull, false, 1e-3);
    for (int i = 0; i < 10; ++i) {
      const dvec3 now = blend.tick(pull, false, 1e-3, rest);
      EXPECT_LE(glm::length(rest + now - before), 0.10) << i;
      before = now;
    }
    EXPECT_LE(glm::distance(before, pull), 0.3 + 1e-12);
    for (int i = 0; i < 1000; ++i) before = blend.tick(pull, false, 1e-3);
    EXPECT_LT(glm::distance(before, pull), 1e-6) << "it comes back";
  }
  PullBlend none;
  EXPECT_EQ(none.tick(dvec3(0.0), false, 1e-3, {0.5, 0.0, 0.0}), dvec3(0.0)) << "what does not pull does not push";
}

}  // namespace
}  // namespace hapticell::haptic
