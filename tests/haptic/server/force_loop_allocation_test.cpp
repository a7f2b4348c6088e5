// SPDX-License-Identifier: Apache-2.0
// A whole tick, messages and statistics included, takes nothing from the heap.
#include <gtest/gtest.h>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/force_loop.h"
#include "tests/haptic/server/virtual_session.h"
#include "tests/support/allocation_guard.h"

namespace hapticell::haptic {
namespace {

TEST(ForceLoopTick, AllocatesNothingWhateverArrives) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  VirtualClock clock;
  SimulatedDevice device;
  ASSERT_TRUE(device.open());
  ForceLoop loop(device, clock, optionsFor(device));
  std::size_t allocations = 0, pressed_ticks = 0;
  for (int i = 0; i < 10'000; ++i) {
    clock.advance(1'000'000);
    if (i % 4000 == 0) loop.openLink();
    if (i % 4000 == 3900) loop.closeLink();
    if (i % 4000 < 3000 && i % 100 == 0) loop.heard();
    if (i % 1000 == 1) loop.submit(HapticControl{.forces_enabled = true, .stiffness = 800.0});
    if (i % 16 == 2) loop.submit(floorSet(static_cast<std::uint64_t>(i), 0.0, loop.current().X_DP.p));
    const double height = i % 4000 < 2000 ? 0.005 : -0.010;
    loop.submit(HandTarget{true, Pose::translation(dvec3(0.0, 0.0, height)), 0});
    const test::AllocationGuard guard;
    loop.tick({.late_ns = 1000 * i, .skipped = i % 500 == 0 ? 20u : 0u});
    allocations += guard.count();
    if (glm::length(loop.current().force_D) > 1.0) ++pressed_ticks;
  }
  EXPECT_EQ(allocations, 0u);
  EXPECT_GT(pressed_ticks, 1000u) << "it was at work";
}

}  // namespace
}  // namespace hapticell::haptic
