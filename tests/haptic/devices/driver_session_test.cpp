// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptic/devices/driver_device.h"
#include "tests/haptic/devices/contact_rig.h"
#include "tests/haptic/devices/scripted_driver.h"

namespace hapticell::haptic {
namespace {

using driver::ScriptedDriver;
using driver::Status;

driver::Command push(double newtons) {
  driver::Command command;
  command.motors = true;
  command.force[2] = newtons;
  return command;
}

TEST(DriverSession, TellsWhyADeviceCannotBeOpened) {
  ScriptedDriver driver;
  driver::refuse(driver.refuses, Status::kInUse, "another program has it", "Close it.");
  DriverSession session(driver, "");
  EXPECT_EQ(session.open().status, Status::kInUse);
  EXPECT_FALSE(session.isOpen());
}

TEST(DriverSession, NoForceToADeviceThatIsNotCalibrated) {
  ScriptedDriver driver;
  driver.device.state.flags = 0;
  DriverSession session(driver, "");
  ASSERT_EQ(session.open().status, Status::kOk);
  session.turn(push(2.0));
  EXPECT_EQ(driver.device.commands.back().force[2], 0.0);
  EXPECT_FALSE(driver.device.commands.back().motors);
  driver.device.state.flags = driver::kCalibrated;
  session.turn(push(2.0));
  EXPECT_EQ(driver.device.commands.back().force[2], 2.0);
}

TEST(DriverSession, TellsItsConditionAndCalibratesWhenItsUserHasDoneHisPart) {
  ScriptedDriver driver;
  driver.device.state.flags = driver::kDocked;
  driver.device.steps = {"Put it into its inkwell.", "Pull it out."};
  const auto care = std::make_shared<DeviceCare>();
  DriverSession session(driver, "", {.reopen_turns = 2, .care = care});
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_FALSE(care->condition().calibrated);  // Before the first measurement too.
  session.turn({});
  EXPECT_EQ(care->condition().calibration, driver.device.steps);
  EXPECT_TRUE(care->condition().docked);
  EXPECT_NE(care->condition().sentence.find("not calibrated"), std::string::npos);
  const std::uint64_t changes = care->changes();
  for (int i = 0; i < 100; ++i) session.turn({});
  EXPECT_EQ(care->changes(), changes) << "nothing changed, so nothing is told";

  care->calibrate(7);  // There is no such step.
  session.turn({});
  EXPECT_TRUE(driver.device.calibrated_steps.empty());
  driver.device.refuses_step = 0;
  care->calibrate(0);
  session.turn({});
  EXPECT_NE(care->condition().sentence.find("wrong place. Try again."), std::string::npos);
  driver.device.refuses_step = -1;
  for (const std::uint32_t step : {0u, 1u}) {
    care->calibrate(step);
    session.turn({});
  }
  EXPECT_EQ(driver.device.calibrated_steps, (std::vector<std::uint32_t>{0, 0, 1}));
  session.turn({});
  EXPECT_TRUE(care->condition().calibrated);
  EXPECT_NE(care->condition().sentence.find("it is calibrated"), std::string::npos);

  driver.device.fail(Status::kVanished, "it was unplugged");
  session.turn({});
  EXPECT_FALSE(care->condition().answers);
  EXPECT_NE(care->condition().sentence.find("it was unplugged. Forces are off. Plug it in again."), std::string::npos);
  for (int i = 0; i < 3; ++i) session.turn({});
  EXPECT_TRUE(care->condition().answers);
}

TEST(DriverSession, LivesThroughSomeGarbageAndGivesUpOnMuch) {
  ScriptedDriver driver;
  std::string told;
  DriverSession session(
      driver, "", {.reopen_turns = 5, .garbled_turns = 4, .report = [&](const std::string& text) { told = text; }});
  ASSERT_EQ(session.open().status, Status::kOk);
  driver.device.fail(Status::kGarbled, "a packet of 3 bytes");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(session.turn({}).status, Status::kOk);
  EXPECT_EQ(session.turn({}).status, Status::kGarbled);
  EXPECT_EQ(driver.closed, 1);
  EXPECT_NE(told.find("a packet of 3 bytes"), std::string::npos) << told;
  EXPECT_NE(told.find("Plug it in again."), std::string::npos) << told;
}

TEST(DriverSession, ANumberThatIsNoneIsGarbage) {
  ScriptedDriver driver;
  DriverSession session(driver, "");
  ASSERT_EQ(session.open().status, Status::kOk);
  driver.device.state.position[1] = 0.01;
  session.turn({});
  driver.device.state.position[1] = std::nan("");
  EXPECT_EQ(session.turn({}).state.position[1], 0.01);
}

TEST(DriverSession, OpensAgainWhatCameBack) {
  ScriptedDriver driver;
  std::vector<std::string> told;
  DriverSession session(driver, "",
                        {.reopen_turns = 5, .report = [&](const std::string& text) { told.push_back(text); }});
  ASSERT_EQ(session.open().status, Status::kOk);
  driver.device.fail(Status::kVanished, "it was unplugged");
  EXPECT_EQ(session.turn(push(1.0)).status, Status::kVanished);
  driver::refuse(driver.refuses, Status::kNotFound, "it is not there");
  for (int i = 0; i < 12; ++i) EXPECT_EQ(session.turn(push(1.0)).status, Status::kVanished);
  EXPECT_EQ(driver.opened, 3);  // The first, and one every five turns.
  driver.refuses = {};
  for (int i = 0; i < 5; ++i) session.turn(push(1.0));
  EXPECT_TRUE(session.isOpen());
  EXPECT_EQ(session.turn(push(1.0)).status, Status::kOk);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NE(told[1].find("answers again"), std::string::npos);
}

/// Unplugged in contact: the force is gone at the next tick, nothing comes back by itself, and after a re-plug the user
/// who switches forces on feels the floor again.
TEST(DriverDevice, UnpluggedInContactAndPluggedInAgain) {
  ScriptedDriver driver;
  driver.device.state.position[2] = 0.005;
  DriverDeviceOptions options{.calls = DriverCalls::kInline};
  options.session.reopen_turns = 50;
  DriverDevice device(driver, "", options);
  ASSERT_TRUE(device.open());
  ContactRig rig(device);
  rig.engage(0.0);
  rig.run(60, [&] { driver.device.state.position[2] -= 1e-4; });
  rig.run(200);
  EXPECT_GT(rig.force(), 0.5);
  EXPECT_LE(rig.max_step, 1.0 + 1e-9);  // N in a millisecond.

  driver.device.fail(Status::kVanished, "it was unplugged");
  driver::refuse(driver.refuses, Status::kNotFound, "it is not there");
  rig.run(1);
  EXPECT_EQ(rig.force(), 0.0);
  EXPECT_TRUE(rig.loop.current().device_fault);
  EXPECT_EQ(driver.device.commands.back().force[2], 0.0);  // The last word to the device was zero.
  rig.run(500);

  driver.refuses = {};
  rig.run(500);
  EXPECT_FALSE(rig.loop.current().device_fault);
  EXPECT_EQ(rig.force(), 0.0) << "a force came back by itself";
  driver.device.state.position[2] = 0.005;
  rig.switchOnAgain(0.0);
  rig.run(60, [&] { driver.device.state.position[2] -= 1e-4; });
  rig.run(200);
  EXPECT_GT(rig.force(), 0.5);
}

TEST(DriverDevice, ABlockedDriverHoldsUpNobody) {
  ScriptedDriver driver;
  DriverDevice device(driver, "");
  ASSERT_TRUE(device.open());
  DeviceReading reading;
  {
    std::unique_lock lock(driver.device.mutex);
    driver.device.blocked = true;
    const int before = driver.device.reads;
    driver.device.changed.wait(lock, [&] { return driver.device.reads > before; });  // It hangs in read() now.
  }
  device.read(reading);  // What it had answered before.
  int ticks = 0;
  while (device.read(reading) == DeviceStatus::kOk && ticks < 100) {
    EXPECT_EQ(device.write(dvec3(0.0, 0.0, 1.0), dvec3(0.0)), DeviceStatus::kOk);
    ++ticks;
  }
  EXPECT_LE(ticks, DriverDevice::kPatience);
  {
    const std::scoped_lock lock(driver.device.mutex);
    driver.device.blocked = false;
    driver.device.changed.notify_all();
  }
  device.close();
  const std::scoped_lock lock(driver.device.mutex);
  EXPECT_FALSE(driver.device.commands.back().motors);  // Closed with the motors off.
}

TEST(DriverDevice, AThreeDMouseIsAStylusWithoutForce) {
  ScriptedDriver driver;
  driver.device.about.kind = driver::Kind::kSpaceMouse;
  driver.device.about.driven_axes = 0;
  driver.device.about.peak_force = 0.0;
  driver.device.state.motion[0] = 1.0;
  driver.device.state.motion[5] = 0.5;
  DriverDevice device(driver, "", {.calls = DriverCalls::kInline});
  ASSERT_TRUE(device.open());
  EXPECT_EQ(device.capabilities().driven_axes, 0);
  DeviceReading reading;
  for (int i = 0; i < 100; ++i) device.read(reading);
  EXPECT_NEAR(reading.X_DS.p.x, 0.012, 1e-9);
  EXPECT_NEAR(rotationVector(reading.X_DS.q).z, 0.06, 1e-9);
  for (int i = 0; i < 2000; ++i) device.read(reading);
  EXPECT_NEAR(reading.X_DS.p.x, 0.08, 1e-12);  // The edge of its workspace.
}

}  // namespace
}  // namespace hapticell::haptic
