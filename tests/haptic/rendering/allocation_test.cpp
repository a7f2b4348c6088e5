// SPDX-License-Identifier: Apache-2.0
// The force loop's work takes nothing from the heap.
#include "tests/support/allocation_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "haptic/devices/simulated_device.h"
#include "haptic/rendering/force_renderer.h"
#include "haptic/rendering/safety_chain.h"
#include "haptic/rendering/triple_buffer.h"

namespace hapticell::haptic {
namespace {

using ::hapticell::test::AllocationGuard;

ConstraintSet boreOfRows(std::uint64_t sequence) {
  ConstraintSet set;
  set.sequence = sequence;
  set.count = kMaxConstraints;
  for (std::size_t i = 0; i < set.count; ++i) {
    Constraint& c = set.constraints[i];
    const double angle = 0.0981747704 * static_cast<double>(i);
    c.group = static_cast<std::uint32_t>(i);
    c.gap = 0.005;
    c.gradient = {-std::cos(angle), -std::sin(angle), 0.1, 0.001, 0.002, 0.0};
    c.curvature[0] = c.curvature[6] = -50.0;
    c.friction = 0.3;
  }
  return set;
}

TEST(AllocationGuard, SeesAnAllocation) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  const AllocationGuard guard;
  const auto number = std::make_unique<int>(3);
  EXPECT_EQ(guard.count(), 1u);
  EXPECT_EQ(*number, 3);
}

TEST(ForceLoop, AllocatesNothingInTenThousandTicks) {
  if (!test::allocationsAreCounted()) GTEST_SKIP() << test::kNotCounted;
  const auto renderer = std::make_unique<ForceRenderer>();
  const auto sets = std::make_unique<TripleBuffer<ConstraintSet>>();
  SafetyChain chain;
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  int contact_ticks = 0;
  const AllocationGuard guard;
  for (int i = 0; i < 10000; ++i) {
    if (i % 16 == 0) {
      sets->writeSlot() = boreOfRows(static_cast<std::uint64_t>(i));
      sets->publish();
    }
    const double reach = i < 2000 ? 0.002 : 0.008;
    device.hand().hold(Pose::translation(reach * dvec3(std::cos(0.01 * i), std::sin(0.01 * i), 0.0)), i % 100 < 10);
    device.advance(0.001);
    DeviceReading reading;
    device.read(reading);
    if (sets->update()) renderer->adopt(sets->value());
    const RenderResult result = renderer->tick(reading.X_DS, 0.001);
    SafetyInput input;
    input.force_D = result.force_D;
    input.v_DS = result.v_DS;
    input.enabled = true;
    const SafetyResult safe = chain.tick(input);
    renderer->noteApplied(safe.force_D);
    device.write(safe.force_D, dvec3(0.0));
    contact_ticks += result.contact ? 1 : 0;
  }
  EXPECT_EQ(guard.count(), 0u);
  EXPECT_GT(contact_ticks, 3000);
  EXPECT_EQ(chain.tick({}).gate, GateState::kClosing) << "the gate had opened";
}

}  // namespace
}  // namespace hapticell::haptic
