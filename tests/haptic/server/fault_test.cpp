// SPDX-License-Identifier: Apache-2.0
// What the force loop does when its device, its clock or the machine misbehaves.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "haptic/server/fault_file.h"
#include "tests/haptic/server/scripted_hardware.h"
#include "tests/haptic/server/virtual_session.h"
#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

TEST(Faults, TwentyMissedTicksSwitchTheMotorsOffUntilReArmed) {
  Hardware hardware;
  hardware.press();
  ASSERT_GT(glm::length(hardware.device.force), 1.0);
  hardware.run(1, {0, 19});
  EXPECT_TRUE(hardware.device.motors) << "nineteen are borne";
  hardware.run(1, {0, 20});
  EXPECT_FALSE(hardware.device.motors);
  EXPECT_EQ(hardware.device.force, dvec3(0.0));
  EXPECT_TRUE(hardware.loop.motorsOff());
  hardware.run(2000);
  EXPECT_EQ(hardware.device.force, dvec3(0.0)) << "they stay off by themselves";
  hardware.device.X_DS.p.z = 0.005;
  hardware.enable(false);
  hardware.run(50);
  EXPECT_TRUE(hardware.device.motors);
  hardware.enable(true);
  hardware.run(1500);
  hardware.press();
  EXPECT_GT(glm::length(hardware.device.force), 1.0) << "re-armed";
}

/// A single failed reading takes the force away; it must not come back by itself in the tick after.
TEST(Faults, ADeviceThatFailsForOneTickStaysWithoutForce) {
  Hardware hardware;
  hardware.press();
  ASSERT_GT(glm::length(hardware.device.force), 1.0);
  hardware.device.status = DeviceStatus::kFault;
  hardware.run(1);
  hardware.device.status = DeviceStatus::kOk;
  for (int i = 0; i < 100; ++i) {
    hardware.run(1);
    ASSERT_EQ(hardware.device.force, dvec3(0.0)) << i;
  }
}

TEST(Faults, ASimulatedDeviceOnlyCountsTheStall) {
  VirtualSession session;
  session.press();
  session.loop().tick({0, 50});
  EXPECT_EQ(session.loop().stalls(), 1U);
  EXPECT_FALSE(session.loop().motorsOff());
}

TEST(Faults, ATeleportingStylusKeepsClampAndSlew) {
  Hardware hardware;
  for (int i = 0; i < 400; ++i) {
    hardware.device.X_DS.p = dvec3(0.05 * std::sin(1e3 * i), 0.05 * std::cos(7e2 * i), 0.04 * std::sin(5e2 * i));
    hardware.run(1);
  }
  EXPECT_LE(hardware.worst, 6.4 + 1e-9);
  EXPECT_LE(hardware.worst_step, 1.0 + 1e-9);
}

/// Somebody calibrates it, or takes it up quickly: nobody has to enable anything anew for that.
TEST(Faults, AJumpWhileNothingPushesIsNoFault) {
  ScriptedDevice device;
  VirtualClock clock;
  ForceLoop loop(device, clock, patientOptionsFor(device));
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      clock.advance(1'000'000);
      loop.heard();
      loop.tick();
      ASSERT_FALSE(loop.current().device_fault);
    }
  };
  loop.openLink();
  loop.tick();
  loop.submit(HapticControl{.forces_enabled = true});
  device.X_DS.p.x = 0.03;
  run(10);
  EXPECT_EQ(loop.current().X_DS.p.x, 0.03);
  run(900);
  EXPECT_EQ(loop.current().force_ramp, 1.0);
  device.X_DS.p.x = 0.0;
  for (int i = 0; i < 30; ++i) loop.tick();
  EXPECT_FALSE(loop.current().forces_on) << "with forces on it is one";
}

TEST(Faults, NumbersThatAreNoneAreNotBelieved) {
  Hardware hardware;
  hardware.press();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    const Pose good = hardware.device.X_DS;
    hardware.device.X_DS.p.x = bad;
    hardware.run(5);
    EXPECT_TRUE(std::isfinite(glm::length(hardware.device.force)));
    hardware.device.X_DS = good;
    hardware.run(20);
  }
  EXPECT_LE(hardware.worst, 6.4 + 1e-9);
  EXPECT_LE(hardware.worst_step, 1.0 + 1e-9);
}

TEST(Faults, AJumpOfTheClockKeepsClampAndSlew) {
  Hardware hardware;
  hardware.press();
  hardware.clock.advance(3'600'000'000'000);
  hardware.run(1, {3'600'000'000'000, 10});
  hardware.run(300);
  hardware.clock.advance(-1'800'000'000'000);
  hardware.run(300);
  EXPECT_LE(hardware.worst, 6.4 + 1e-9);
  EXPECT_LE(hardware.worst_step, 1.0 + 1e-9);
}

TEST(Faults, TheLastTwoSecondsAreKeptAndWritten) {
  Hardware hardware;
  hardware.press();
  EXPECT_FALSE(hardware.loop.faults().pending());
  hardware.device.status = DeviceStatus::kFault;
  hardware.run(1);
  hardware.device.status = DeviceStatus::kOk;
  hardware.run(300);
  ASSERT_TRUE(hardware.loop.faults().pending());
  const FaultRecord record = hardware.loop.faults().copy();
  hardware.loop.faults().release();
  EXPECT_EQ(record.kind, FaultKind::kDevice);
  ASSERT_EQ(record.samples.size(), 2200U);
  for (std::size_t i = 1; i < record.samples.size(); ++i) {
    EXPECT_EQ(record.samples[i].tick, record.samples[i - 1].tick + 1);
  }
  EXPECT_LT(record.samples.front().tick, record.tick);
  EXPECT_GT(record.samples.back().tick, record.tick + 150);

  const test::TemporaryFolder folder;
  const auto path = writeFault(record, folder.path() / "deep");
  ASSERT_TRUE(path.has_value()) << path.error().message();
  std::ifstream file(*path);
  std::string line;
  int lines = 0;
  while (std::getline(file, line)) ++lines;
  EXPECT_EQ(lines, 2202);
  EXPECT_FALSE(writeFault(record, "/proc/no/such/place").has_value());
}

TEST(Faults, WhoMakesFaultsWithoutEndFillsNoDisk) {
  const test::TemporaryFolder folder;
  const auto filesThere = [&] {
    return std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator());
  };
  folder.write("fault-notes.txt", "mine");
  FaultFiles files(folder.path(), {.files = 4, .bytes = 1 << 20, .at_once = 3, .pause = 60.0});
  FaultRecord record{FaultKind::kInput, 0, std::vector<FaultSample>(10)};
  int written = 0;
  for (int second = 1; second <= 600; ++second) {  // A fault each second for ten minutes.
    record.tick = static_cast<std::uint64_t>(1000 * second);
    const auto file = files.write(record, toNanoseconds(second));
    ASSERT_TRUE(file) << file.error().message();
    written += file->has_value() ? 1 : 0;
    ASSERT_LE(filesThere(), 4 + 1);
  }
  EXPECT_EQ(written, 3 + 9) << "three at once, then one a minute";
  EXPECT_EQ(files.leftOut(), 600u - 12u);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "fault-notes.txt")) << "what is no fault file is let be";
  FaultFiles small(folder.path(), {.files = 4, .bytes = 1, .at_once = 3, .pause = 60.0});
  const auto newest = small.write(record, toNanoseconds(1.0));
  ASSERT_TRUE(newest && *newest);
  EXPECT_EQ(filesThere(), 2) << "the newest stays, however large";
}

TEST(Faults, GoIntoNoFolderThatOthersMayWriteTo) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "open");
  std::filesystem::permissions(folder.path() / "open", std::filesystem::perms::all);
  const auto refused = writeFault({FaultKind::kInput, 1, {}}, folder.path() / "open");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("other users can write to it"), std::string::npos);
  FaultFiles homeless(makeError({.found = "HOME is not set"}));
  EXPECT_FALSE(homeless.write({FaultKind::kInput, 1, {}}, 1)) << "nothing is written into the current folder";
}

TEST(Faults, ASecondFaultWhileTheFirstIsReadIsOnlyCounted) {
  FaultRecorder recorder(10, 2);
  const auto add = [&](int count) {
    for (int i = 0; i < count; ++i) recorder.add({});
  };
  add(20);
  recorder.trigger(FaultKind::kInput);
  add(3);
  ASSERT_TRUE(recorder.pending());
  recorder.trigger(FaultKind::kDevice);
  add(5);
  EXPECT_EQ(recorder.faults(), 2U);
  EXPECT_EQ(recorder.copy().kind, FaultKind::kInput);
  recorder.release();
  recorder.trigger(FaultKind::kDevice);
  add(3);
  ASSERT_TRUE(recorder.pending());
  EXPECT_EQ(recorder.copy().kind, FaultKind::kDevice);
}

}  // namespace
}  // namespace hapticell::haptic
