// SPDX-License-Identifier: Apache-2.0
// Devices that fail, and the loop's end.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "haptic/server/force_loop.h"
#include "tests/haptic/server/virtual_session.h"

namespace hapticell::haptic {
namespace {

/// A device that can be told to fail.
class FailingDevice final : public Device {
 public:
  const DeviceCapabilities& capabilities() const override { return inner.capabilities(); }
  Expected<void> open() override { return inner.open(); }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    return failing ? DeviceStatus::kFault : inner.read(reading);
  }
  DeviceStatus write(const dvec3& force_D, const dvec3& torque_D) noexcept override {
    written = force_D;
    return inner.write(force_D, torque_D);
  }
  void close() noexcept override {
    closed = true;
    inner.close();
  }

  SimulatedDevice inner;
  dvec3 written{0.0};
  bool failing = false, closed = false;
};

TEST(ForceLoop, ADeviceThatFailsGetsNoForceAndMustBeEnabledAnew) {
  VirtualClock clock;
  FailingDevice device;
  ASSERT_TRUE(device.open());
  device.inner.hand().hold(Pose::translation(dvec3(0.0, 0.0, 0.005)));
  ForceLoop loop(device, clock, patientOptionsFor(device));
  InMemoryLink link(loop, clock, describe(device));
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      device.inner.advance(0.001);  // Not seen as a simulated one: the test lets its time pass.
      link.step();
    }
  };
  link.sendSet(floorSet(1));
  link.sendControl({.forces_enabled = true});
  run(1500);
  device.inner.hand().hold(Pose::translation(dvec3(0.0, 0.0, -0.010)));
  run(1000);
  ASSERT_GT(glm::length(device.written), 2.0);
  device.failing = true;
  run(1);
  EXPECT_EQ(device.written, dvec3(0.0));
  EXPECT_TRUE(loop.current().device_fault);
  device.failing = false;
  run(2000);
  EXPECT_EQ(device.written, dvec3(0.0)) << "not before the client enables forces anew";
  EXPECT_FALSE(loop.current().device_fault);
}

TEST(ForceLoop, ShuttingDownStopsTheMotorsForGood) {
  VirtualClock clock;
  FailingDevice device;
  ASSERT_TRUE(device.open());
  ForceLoop loop(device, clock, patientOptionsFor(device));
  device.written = dvec3(1.0);
  loop.shutDown();
  EXPECT_EQ(device.written, dvec3(0.0));
  EXPECT_TRUE(device.closed);
  device.written = dvec3(7.0);
  loop.tick();
  EXPECT_EQ(device.written, dvec3(7.0)) << "no tick after the end";
}

RC_GTEST_PROP(ForceLoop, NothingThatHappensToTheLinkBreaksClampOrSlew, ()) {
  VirtualSession session({.latency = 0.001 * *rc::gen::inRange(0, 60), .jitter = 0.02, .loss = 0.2});
  session.engage();
  const int events = *rc::gen::inRange(5, 40);
  std::uint64_t sequence = 2;
  for (int i = 0; i < events; ++i) {
    switch (*rc::gen::inRange(0, 7)) {
      case 0:
        session.link().disconnect();
        break;
      case 1:
        session.link().connect();
        break;
      case 2:
        session.link().setSilent(true);
        break;
      case 3:
        session.link().setSilent(false);
        break;
      case 4:
        session.holdAt(0.001 * *rc::gen::inRange(-40, 10));
        break;
      case 5:
        session.link().sendControl({.forces_enabled = *rc::gen::arbitrary<bool>()});
        break;
      default:
        session.link().sendSet(floorSet(++sequence, 0.001 * *rc::gen::inRange(-5, 30)));
        break;
    }
    session.run(*rc::gen::inRange(1, 400));
  }
  RC_ASSERT(session.max_force <= 6.4 + 1e-9);
  RC_ASSERT(session.max_step <= 1.0 + 1e-9);
}

}  // namespace
}  // namespace hapticell::haptic
