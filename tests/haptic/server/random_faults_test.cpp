// SPDX-License-Identifier: Apache-2.0
// Ten thousand random faults of device, clock, machine, client and link, in virtual time, in one life of a force loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/haptic/server/scripted_hardware.h"

namespace hapticell::haptic {
namespace {

constexpr double kPeak = 6.4;  // N, of the scripted device.
constexpr double kSlew = 1.0;  // N a tick.
constexpr double kRounding = 1e-9;
constexpr int kFaults = 10'000;

/// A hand that presses on the floor and lifts again while everything else goes wrong.
class FaultyLife {
 public:
  explicit FaultyLife(std::uint64_t seed) : random_(seed) {}

  void fault();
  /// What must hold after every tick.
  void tick(TickTiming timing = {});
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }
  /// A client that does everything right, on a device that does.
  void recover();

  Hardware hardware;
  int forced = 0;  ///< Ticks with a force: the programme is not one of forces that are off.
  int cuts = 0;    ///< Ticks in which a fault took the force away at once.

 private:
  std::uint64_t draw(std::uint64_t count) { return random_() % count; }
  double between(double low, double high) { return low + (high - low) * 1e-6 * static_cast<double>(draw(1'000'001)); }
  double wild();
  void faultOfDevice();
  void faultOfTime();
  void faultOfClient();
  void faultOfLink();

  std::mt19937_64 random_;
  std::uint64_t sequence_ = 1;
  double phase_ = 0.0;
};

double FaultyLife::wild() {
  constexpr double kWild[] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity(),
                              1e300,
                              -1e12,
                              5e-324,
                              0.0};
  return kWild[draw(std::size(kWild))];
}

void FaultyLife::tick(TickTiming timing) {
  phase_ += 0.004;
  const Pose good = Pose::translation({0.001 * std::sin(3.0 * phase_), 0.0, 0.002 - 0.005 * std::sin(phase_)});
  if (hardware.device.X_DS.isValid() && glm::length(hardware.device.X_DS.p) < 0.5) hardware.device.X_DS = good;
  const dvec3 before = hardware.device.force;
  hardware.clock.advance(1'000'000);
  hardware.loop.tick(timing);
  const dvec3 now = hardware.device.force;
  ASSERT_TRUE(std::isfinite(now.x) && std::isfinite(now.y) && std::isfinite(now.z));
  ASSERT_LE(glm::length(now), kPeak + kRounding);
  const double step = glm::distance(now, before);
  const double milliseconds = 1.0 + std::min(timing.skipped, ForceLoop::kStall);
  if (step > kSlew * milliseconds + kRounding) {
    ASSERT_EQ(now, dvec3(0.0)) << "only a cut may be quicker than the slew limit: " << glm::length(before)
                               << " N before, " << glm::length(now) << " N now, " << timing.skipped << " ticks skipped";
    ++cuts;
  }
  if (hardware.loop.motorsOff()) {
    ASSERT_EQ(now, dvec3(0.0));
  }
  forced += glm::length(now) > 0.1 ? 1 : 0;
}

void FaultyLife::faultOfDevice() {
  Pose& X_DS = hardware.device.X_DS;
  switch (draw(5)) {
    case 0:
      X_DS.p[static_cast<int>(draw(3))] = wild();
      break;
    case 1:
      X_DS.q = dquat(wild(), wild(), wild(), wild());
      break;
    case 2:  // Teleports, there and back.
      for (int i = 0; i < 20; ++i) {
        X_DS.p = dvec3(between(-0.3, 0.3), between(-0.3, 0.3), between(-0.3, 0.3));
        tick();
      }
      break;
    case 3:
      hardware.device.status = DeviceStatus::kFault;
      run(static_cast<int>(draw(30)) + 1);
      hardware.device.status = DeviceStatus::kOk;
      break;
    default:  // Stuck where it is.
      phase_ -= 0.4;
      break;
  }
  run(static_cast<int>(draw(5)) + 1);
  X_DS = Pose::identity();
}

void FaultyLife::faultOfTime() {
  switch (draw(4)) {
    case 0:
      hardware.clock.advance(static_cast<std::int64_t>(draw(3'600'000)) * 1'000'000);
      break;
    case 1:
      hardware.clock.advance(-static_cast<std::int64_t>(draw(3'600'000)) * 1'000'000);
      break;
    case 2:
      tick({static_cast<std::int64_t>(draw(1'000'000'000)), static_cast<std::uint32_t>(draw(300))});
      break;
    default:
      tick({std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::uint32_t>::max()});
      break;
  }
}

void FaultyLife::faultOfClient() {
  ConstraintSet set = floorSet(++sequence_, between(-0.004, 0.004));
  switch (draw(9)) {
    case 0:
      set.sequence = draw(sequence_ + 1);  // Doubled or out of order.
      break;
    case 1:
      set.stamp_ns = static_cast<std::int64_t>(random_());  // From the future, from long ago.
      break;
    case 2:
      set.X_DR.p.x = between(-1.0, 1.0);
      break;
    case 3:
      set.constraints[0].gradient[draw(6)] = wild();
      break;
    case 4:
      set.zone_radius = wild();
      break;
    case 5:
      set.count = draw(200);
      break;
    case 6:
      set.constraints[0].stiffness = wild();
      set.constraints[0].friction = between(0.0, 100.0);
      break;
    case 7:
      set.constraints[0].velocity_D = dvec3(wild(), between(-100.0, 100.0), 0.0);
      break;
    default:
      hardware.loop.submit(HapticControl{.forces_enabled = draw(2) == 0, .stiffness = wild(), .damping = wild()});
      break;
  }
  hardware.loop.submit(set);
}

void FaultyLife::faultOfLink() {
  switch (draw(4)) {
    case 0:
      hardware.loop.closeLink();
      run(static_cast<int>(draw(80)));
      break;
    case 1:  // Another client, before the old one has gone.
      hardware.loop.openLink();
      break;
    case 2:  // Silent.
      run(static_cast<int>(draw(1000)));
      break;
    default:
      hardware.enable(draw(2) == 0);
      break;
  }
}

void FaultyLife::fault() {
  switch (draw(4)) {
    case 0:
      return faultOfDevice();
    case 1:
      return faultOfTime();
    case 2:
      return faultOfClient();
    default:
      return faultOfLink();
  }
}

void FaultyLife::recover() {
  hardware.device.status = DeviceStatus::kOk;
  hardware.device.X_DS = Pose::identity();
  hardware.loop.openLink();
  const auto wait = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      hardware.loop.heard();
      tick();
    }
  };
  hardware.enable(false);
  wait(30);
  hardware.loop.submit(floorSet(++sequence_));
  hardware.enable(true);
  wait(static_cast<int>(draw(4)) == 0 ? 3000 : 30);
}

TEST(RandomFaults, TenThousandKeepClampAndSlewAndTheForceComesBack) {
  FaultyLife life(20261121);
  for (int i = 0; i < kFaults && !testing::Test::HasFatalFailure(); ++i) {
    life.fault();
    if (i % 10 == 9) life.recover();
  }
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  EXPECT_GT(life.forced, 10'000) << "forces acted while it went on";
  EXPECT_GT(life.cuts, 0);

  life.recover();
  life.forced = 0;
  for (int i = 0; i < 4000; ++i) {
    life.hardware.loop.heard();
    life.tick();
  }
  EXPECT_GT(life.forced, 500) << "the arm that all this happened to works again";
}

}  // namespace
}  // namespace hapticell::haptic
