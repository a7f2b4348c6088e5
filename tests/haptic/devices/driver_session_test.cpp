// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
  EXPECT_EQ(driver.device.commands.back().force[2], 0.0) << "its giver does not know yet";
  EXPECT_TRUE(session.turn({}).takes_force);
  session.turn(push(2.0));
  EXPECT_EQ(driver.device.commands.back().force[2], 1.0) << "a step at a time";
  session.turn(push(2.0));
  EXPECT_EQ(driver.device.commands.back().force[2], 2.0);
}

/// A device with a test's clock, calibrated and pushing with 2 N.
struct Pushing {
  Pushing() : session(driver, "", {.now = [this] { return now; }}) {
    static_cast<void>(session.open());
    turn({});
    for (int i = 0; i < 3; ++i) turn(push(2.0));
  }
  const DriverAnswer& turn(const driver::Command& command, std::int64_t milliseconds = 1) {
    now += milliseconds * 1'000'000;
    return session.turn(command);
  }
  double force() const { return driver.device.commands.back().force[2]; }
  /// As the force loop does it: nothing until it is told that it may.
  void restartStretch() {
    EXPECT_TRUE(turn({}).takes_force);
    for (const double newtons : {0.1, 1.0, 2.0}) turn(push(newtons));
    EXPECT_EQ(force(), 2.0);
  }

  std::int64_t now = 1;
  ScriptedDriver driver;
  DriverSession session;
};

/// Nothing new for ever, or only garbage: zero is written all the same.
TEST(DriverSession, WhatWasMeasuredLongAgoIsGivenNoForce) {
  for (const Status answer : {Status::kNothingNew, Status::kNotCalibrated, Status::kGarbled}) {
    Pushing it;
    ASSERT_EQ(it.force(), 2.0);
    it.driver.device.answer = answer;
    for (int i = 0; i < 19; ++i) it.turn(push(2.0));
    EXPECT_EQ(it.force(), 2.0) << "19 ms are borne";
    EXPECT_FALSE(it.turn(push(2.0)).takes_force);
    EXPECT_EQ(it.force(), 0.0);
    EXPECT_FALSE(it.driver.device.commands.back().motors);
    if (answer == Status::kGarbled) continue;  // Twenty on end: it was closed.
    for (int i = 0; i < 100; ++i) it.turn(push(2.0));
    it.driver.device.answer = Status::kOk;
    for (int i = 0; i < 100; ++i) it.turn(push(2.0));
    EXPECT_EQ(it.force(), 0.0) << "not in one step";
    it.restartStretch();
  }
}

TEST(DriverSession, WhatWasHeldBackOnceBeginsAnew) {
  const auto expectHeld = [](Pushing& it, auto&& trouble) {
    ASSERT_EQ(it.force(), 2.0);
    trouble();
    for (int i = 0; i < 50; ++i) it.turn(push(2.0));
    EXPECT_EQ(it.force(), 0.0);
    it.restartStretch();
  };
  Pushing uncalibrated, forceless, stalled, held;
  expectHeld(uncalibrated, [&] {
    uncalibrated.driver.device.state.flags = 0;
    uncalibrated.turn(push(2.0));
    uncalibrated.driver.device.state.flags = driver::kCalibrated;
  });
  expectHeld(forceless, [&] {
    forceless.driver.device.state.flags |= driver::kForceless;
    forceless.turn(push(2.0));
    forceless.driver.device.state.flags = driver::kCalibrated;
  });
  expectHeld(stalled, [&] { stalled.turn(push(2.0), 21); });  // The thread itself stood still.
  expectHeld(held, [&] { held.session.hold(); });
}

TEST(DriverSession, TwoCommandsAreNeverMoreThanAStepApart) {
  Pushing it;
  for (const double newtons : {6.0, -6.0, 3.0, 0.0, 5.0, -1.0}) {
    for (int i = 0; i < 4; ++i) {
      const double before = it.force();
      it.turn(push(newtons));
      const double step = std::abs(it.force() - before);
      EXPECT_TRUE(step <= 1.0 + 1e-12 || it.force() == 0.0) << "nothing at all is sent at once, all else by steps";
    }
  }
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

/// A device in contact behind the real force loop, in virtual time; what is asked is what the *device* was told.
struct DeviceInContact {
  DeviceInContact() : device(driver, "", {.calls = DriverCalls::kInline}) {
    driver.device.state.position[2] = 0.005;
    EXPECT_TRUE(device.open());
    rig.emplace(device);
    rig->engage(0.0);
    press();
  }
  void press() {
    rig->run(60, [&] { driver.device.state.position[2] -= 1e-4; });
    rig->run(300);
    EXPECT_GT(force(), 0.5);
  }
  double force() const { return driver.device.commands.back().force[2]; }
  /// A tick of a hand on its way there.
  void lead(double height) {
    double& z = driver.device.state.position[2];
    z += std::clamp(height - z, -1e-4, 1e-4);
  }
  /// The greatest rise from one command to the next from command `first` on, and the last that was not zero.
  double greatestRise(std::size_t first) const {
    double rise = 0.0;
    const auto& commands = driver.device.commands;
    for (std::size_t i = std::max<std::size_t>(first, 1); i < commands.size(); ++i)
      rise = std::max(rise, std::abs(commands[i].force[2]) - std::abs(commands[i - 1].force[2]));
    return rise;
  }

  ScriptedDriver driver;
  DriverDevice device;
  std::optional<ContactRig> rig;
};

TEST(DriverDevice, NothingNewForTwentyMillisecondsIsZeroWrittenAndAFault) {
  DeviceInContact contact;
  const std::size_t first = contact.driver.device.commands.size();
  contact.driver.device.answer = Status::kNothingNew;
  contact.rig->run(18);
  EXPECT_GT(contact.force(), 0.5);
  contact.rig->run(3);
  EXPECT_EQ(contact.force(), 0.0);
  EXPECT_TRUE(contact.rig->loop.current().device_fault);
  contact.rig->run(2000);
  contact.driver.device.answer = Status::kOk;
  contact.rig->run(2000);
  for (std::size_t i = first + 21; i < contact.driver.device.commands.size(); ++i)
    ASSERT_EQ(contact.driver.device.commands[i].force[2], 0.0) << "nothing comes back by itself";
  contact.driver.device.state.position[2] = 0.005;
  contact.rig->run(50);
  contact.rig->switchOnAgain(0.0);
  contact.press();
}

/// Finite, and nowhere: refused, then tripped; nobody is told of it.
TEST(DriverDevice, AnAbsurdPoseIsRefusedAndTrips) {
  for (const double x : {0.02, 0.4, 3.0, 1e9, 1e12, 1e300}) {
    DeviceInContact contact;
    contact.driver.device.state.position[0] = x;
    contact.rig->run(25);
    EXPECT_EQ(contact.force(), 0.0) << x;
    contact.rig->run(2000);
    EXPECT_EQ(contact.force(), 0.0) << x;
    EXPECT_LT(std::abs(contact.rig->loop.current().X_DS.p.x), 0.7) << x;
    contact.driver.device.state.position[0] = 0.0;
    contact.driver.device.state.position[2] = 0.005;
    contact.rig->run(50);
    contact.rig->switchOnAgain(0.0);
    contact.press();
  }
}

/// Calibration flags that flip, at any rhythm: every force that the device is told comes by the ramp.
TEST(DriverDevice, ACalibrationFlagThatFlipsNeverGivesAStep) {
  for (const int period : {1, 2, 7, 40, 300, 1200}) {
    DeviceInContact contact;
    const std::size_t first = contact.driver.device.commands.size();
    for (int i = 0; i < 4000; ++i) {
      if (i % period == 0) contact.driver.device.state.flags ^= driver::kCalibrated;
      contact.lead(i % 1000 < 500 ? 0.0005 : -0.002);
      contact.rig->run(1);
    }
    EXPECT_LE(contact.greatestRise(first), 0.2) << period;
    contact.driver.device.state.flags = driver::kCalibrated;
    contact.rig->run(100, [&] { contact.lead(0.005); });
    contact.rig->run(1500);
    contact.press();
  }
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
