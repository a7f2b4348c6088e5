// SPDX-License-Identifier: Apache-2.0
#include "manipulation/free_motion.h"

#include <gtest/gtest.h>

#include "geometry/shapes.h"
#include "manipulation/solid_manipulator.h"

namespace hapticell::manipulation {
namespace {

EntityConfiguration at(const dvec3& p, const dvec3& turn = dvec3(0.0)) {
  return {Pose{p, quaternionFromRotationVector(turn)}, {}};
}

/// A box of 60 mm that stands on a table whose top is z = 0, guarded upwards.
struct StandingBox {
  StandingBox()
      : motion({collision::MeshCollider::build(geometry::makeBox(dvec3(0.06)))},
               {{collision::MeshCollider::build(geometry::makeBox({1.0, 1.0, 0.1})), Pose::translation({0, 0, -0.05})}},
               {{0, 0, true}}) {
    motion.reset(box, at({0, 0, 0.03}));
    motion.guard(0, {0, 0, 1});
  }
  SolidManipulator box{Pose::identity(), {Pose::identity()}};
  FreeMotion motion;
};

TEST(FreeMotionGuard, StopsWhatTouchesFromSinkingIn) {
  StandingBox standing;
  ASSERT_TRUE(standing.motion.isSoft(0));
  const MotionAnswer answer = standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0.01, 0, 0.025}));
  EXPECT_TRUE(answer.blocked);
  EXPECT_LE(answer.s * 0.005, FreeMotion::kGuard);
  EXPECT_NEAR(answer.contact.nhat_BA_W.z, 1.0, 1e-9);
}

TEST(FreeMotionGuard, StopsACornerThatTurnsIn) {
  StandingBox standing;
  const MotionAnswer answer = standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0, 0, 0.031}, {0.2, 0, 0}));
  EXPECT_TRUE(answer.blocked);
  // The corner sinks by 30 mm a radian while the box rises by 1 mm.
  EXPECT_LE(answer.s * (0.03 * 0.2 - 0.001), 1.1 * FreeMotion::kGuard);
}

TEST(FreeMotionGuard, LetsItSlideAndLeave) {
  StandingBox standing;
  EXPECT_EQ(standing.motion.advance(standing.box, at({0, 0, 0.03}), at({0.1, 0, 0.03})).s, 1.0);
  EXPECT_EQ(standing.motion.advance(standing.box, at({0.1, 0, 0.03}), at({0.1, 0, 0.04})).s, 1.0);
  EXPECT_FALSE(standing.motion.isSoft(0));
  EXPECT_TRUE(standing.motion.advance(standing.box, at({0.1, 0, 0.04}), at({0.1, 0, 0.02})).blocked);
}

}  // namespace
}  // namespace hapticell::manipulation
