// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <clocale>

#include "haptic/devices/driver_device.h"
#include "haptic/devices/drivers/openhaptics/hd_library.h"
#include "haptic/devices/drivers/openhaptics/open_haptics_driver.h"
#include "tests/haptic/devices/contact_rig.h"
#include "tests/haptic/devices/drivers/openhaptics/hd_stand_in.h"

namespace hapticell::driver {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

HdStandIn& standIn() {
  static auto* const library = dlopen(HAPTICELL_HD_STAND_IN, RTLD_NOW);
  return *reinterpret_cast<HdStandIn* (*)()>(dlsym(library, "hdStandIn"))();
}

class OpenHaptics : public ::testing::Test {
 protected:
  OpenHaptics() : hd(standIn()) {
    hd.reset();
    driver.configure("library", HAPTICELL_HD_STAND_IN);
  }

  /// Opens it and lets the vendor's scheduler tick once.
  Device& opened() {
    Problem problem;
    Device* const device = driver.open("", problem);
    EXPECT_NE(device, nullptr) << problem.found;
    hd.tick();
    return *device;
  }

  HdStandIn& hd;
  OpenHapticsDriver driver;
  State state;
};

TEST_F(OpenHaptics, LoadsInTheCLocale) {
  // A process of another locale: the library must not read "0.5" as "0".
  std::setlocale(LC_ALL, "C.UTF-8");
  opened();
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
}

TEST_F(OpenHaptics, TriesTheNamesInOrder) {
  hd.known_names = {"Default PHANToM"};
  opened();
  EXPECT_THAT(hd.tried_names, ElementsAre("Default Device", "(null)", "Default PHANToM"));
}

TEST_F(OpenHaptics, ANamedDeviceAlone) {
  hd.known_names = {"Left Device"};
  Problem problem;
  EXPECT_EQ(driver.open("Right Device", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNotFound);
  EXPECT_THAT(problem.found, HasSubstr("0x302"));
  EXPECT_THAT(problem.found, HasSubstr("-14"));
  problem = {};
  EXPECT_NE(driver.open("Left Device", problem), nullptr);
  EXPECT_THAT(hd.tried_names, ElementsAre("Right Device", "Left Device"));
}

TEST_F(OpenHaptics, MissingLibraryAndMissingFunction) {
  OpenHapticsDriver none;
  none.configure("library", "/nowhere/libHD.so");
  Problem problem;
  Found found[4];
  none.find(found, 4, problem);
  EXPECT_EQ(problem.status, Status::kMissingLibrary);
  EXPECT_THAT(problem.found, HasSubstr("/nowhere/libHD.so"));
  EXPECT_THAT(problem.fix, HasSubstr("OpenHaptics"));

  OpenHapticsDriver old;
  old.configure("library", HAPTICELL_HD_OLD);
  EXPECT_EQ(old.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kMissingLibrary);
  EXPECT_THAT(problem.found, HasSubstr("lacks the function hdDisableDevice"));
}

/// The vendor's library is neither loaded nor asked for it: a device in use is not disturbed.
TEST_F(OpenHaptics, ItsPresenceTellsThatTheLibraryCameAndAsksNobody) {
  const std::string link = ::testing::TempDir() + "hapticell-libHD-" + std::to_string(getpid());
  unlink(link.c_str());
  driver.configure("library", link.c_str());
  const std::uint64_t none = driver.presence();
  EXPECT_EQ(driver.presence(), none);
  ASSERT_EQ(symlink(HAPTICELL_HD_STAND_IN, link.c_str()), 0);
  EXPECT_NE(driver.presence(), none);
  EXPECT_TRUE(hd.tried_names.empty());
  EXPECT_EQ(hd.opened, 0);
  unlink(link.c_str());
}

TEST_F(OpenHaptics, InUseIsSaid) {
  hd.init_error = 0x301;
  Problem problem;
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kInUse);
  EXPECT_THAT(problem.fix, HasSubstr("Close the other program"));
}

TEST_F(OpenHaptics, ListsWhatIsThere) {
  Found found[4];
  Problem problem;
  ASSERT_EQ(driver.find(found, 4, problem), 1u);
  EXPECT_STREQ(found[0].name, "Stand-in Touch");
  EXPECT_STREQ(found[0].firmware, "192");
  EXPECT_EQ(found[0].problem.status, Status::kOk);
  EXPECT_EQ(hd.opened, hd.closed);  // And let go again.
  opened();
  ASSERT_EQ(driver.find(found, 4, problem), 1u);
  EXPECT_EQ(found[0].problem.status, Status::kInUse);
}

TEST_F(OpenHaptics, MeasuresInTheHousesFrameAndUnits) {
  hd.position[0] = 10.0;  // mm: right, up, to the user.
  hd.position[1] = 20.0;
  hd.position[2] = 30.0;
  // A quarter turn about the vendor's y (up), as rows of a row-vector transform.
  const double turned[16] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 10, 20, 30, 1};
  std::copy_n(turned, 16, hd.transform);
  hd.buttons = 2;
  Device& device = opened();
  EXPECT_EQ(device.read(state), Status::kOk);
  EXPECT_NEAR(state.position[0], 0.010, 1e-12);
  EXPECT_NEAR(state.position[1], -0.030, 1e-12);
  EXPECT_NEAR(state.position[2], 0.020, 1e-12);
  const dquat q(state.orientation[0], state.orientation[1], state.orientation[2], state.orientation[3]);
  const dvec3 turn = rotationVector(q);
  EXPECT_NEAR(turn.z, std::acos(-1.0) / 2.0, 1e-12);  // Up is D's z.
  EXPECT_NEAR(std::hypot(turn.x, turn.y), 0.0, 1e-12);
  EXPECT_EQ(state.buttons, 2u);
  EXPECT_EQ(device.read(state), Status::kNothingNew);
  EXPECT_NEAR(device.capabilities().workspace_max[0], 0.105, 1e-12);
  EXPECT_NEAR(device.capabilities().workspace_max[1], 0.085, 1e-12);
  EXPECT_NEAR(device.capabilities().workspace_max[2], 0.110, 1e-12);
  EXPECT_NEAR(device.capabilities().stiffness, 400.0, 1e-9);
  EXPECT_NEAR(device.capabilities().peak_force, 3.3, 1e-12);
}

TEST_F(OpenHaptics, ForcesInTheVendorsAxesAndOnlyWithMotors) {
  Device& device = opened();
  EXPECT_FALSE(hd.force_output);  // Off by start.
  Command command;
  command.force[0] = 1.0, command.force[1] = 2.0, command.force[2] = 3.0;
  device.write(command);
  hd.tick();
  EXPECT_FALSE(hd.force_output);
  EXPECT_EQ(hd.force[0], 0.0);
  command.motors = true;
  for (int i = 0; i < 4; ++i) {
    device.write(command);
    hd.tick();
  }
  EXPECT_TRUE(hd.force_output);
  EXPECT_EQ(hd.force[0], 1.0);
  EXPECT_EQ(hd.force[1], 3.0);
  EXPECT_EQ(hd.force[2], -2.0);
  // The virtual work is the same in both frames: mapping of forces and positions belong together.
  const dvec3 motion_hd(0.3, -0.2, 0.5);
  const HdFrame frame;
  const double mm[3] = {1e3 * motion_hd.x, 1e3 * motion_hd.y, 1e3 * motion_hd.z};
  EXPECT_NEAR(glm::dot(HdFrame::toHd({1, 2, 3}), motion_hd), glm::dot(dvec3(1, 2, 3), frame.position(mm)), 1e-12);
}

TEST_F(OpenHaptics, AHostThatStopsCommandingGetsNoForce) {
  Device& device = opened();
  Command command;
  command.motors = true;
  command.force[2] = 2.0;
  for (int i = 0; i < 2; ++i) {
    device.write(command);
    hd.tick();
  }
  EXPECT_EQ(hd.force[1], 2.0);
  for (int i = 0; i < 60; ++i) hd.tick();
  EXPECT_EQ(hd.force[1], 0.0);
  EXPECT_FALSE(hd.force_output);
  device.write(command);
  hd.tick();
  EXPECT_EQ(hd.force[1], 0.0) << "a host that is back begins anew";
  hd.tick();
  device.read(state);
  EXPECT_NE(state.flags & kForceless, 0u);
}

/// Nothing that is commanded gets through it any more: its amplifiers are switched off past it.
TEST_F(OpenHaptics, ASchedulerThatStandsStillLeavesNoForce) {
  Device& device = opened();
  Command command;
  command.motors = true;
  command.force[2] = 1.0;
  device.write(command);
  hd.tick();
  ASSERT_TRUE(hd.force_output);
  for (int i = 0; i < 21; ++i) device.read(state);
  device.write({});
  EXPECT_FALSE(hd.force_output);
}

TEST_F(OpenHaptics, EveryErrorOfTheStackIsHandled) {
  Device& device = opened();
  Command command;
  command.motors = true;
  command.force[2] = 2.0;
  device.write(command);
  hd.errors = {{0x200, 0, 0}};  // Warm motors: told as such, nothing else.
  hd.tick();
  EXPECT_EQ(device.read(state), Status::kOk);
  EXPECT_EQ(state.motor_temperature, 1.0);

  hd.errors = {{0x201, 0, 0}};  // Exceeded force: quiet for a while, then on again.
  device.write(command);
  hd.tick();
  device.write(command);
  hd.tick();
  EXPECT_EQ(hd.force[1], 0.0);
  EXPECT_EQ(device.read(state), Status::kOk);
  for (int i = 0; i < 260; ++i) {
    device.write(command);
    hd.tick();
  }
  EXPECT_EQ(hd.force[1], 0.0) << "not in one step";
  device.read(state);
  EXPECT_NE(state.flags & kForceless, 0u) << "the host is told, and begins anew";
  for (const bool motors : {false, true, true}) {
    command.motors = motors;
    device.write(command);
    hd.tick();
  }
  EXPECT_EQ(hd.force[1], 2.0);

  const struct {
    unsigned code;
    Status status;
  } grave[] = {{0x100, Status::kFault},    {0x102, Status::kFault},    {0x204, Status::kFault},
               {0x300, Status::kVanished}, {0x302, Status::kVanished}, {0x303, Status::kVanished},
               {0x304, Status::kFault},    {0x400, Status::kFault},    {0x501, Status::kFault},
               {0x600, Status::kFault}};
  for (const auto& error : grave) {
    hd.errors = {{0x200, 0, 0}, {error.code, -7, 0}, {0x201, 0, 0}};  // The gravest counts, wherever it stands.
    hd.tick();
    EXPECT_EQ(device.read(state), error.status) << std::hex << error.code;
    EXPECT_THAT(device.problem().found, HasSubstr("internal -7"));
    EXPECT_NE(device.problem().fix[0], '\0');
    EXPECT_TRUE(hd.errors.empty());
  }
}

TEST_F(OpenHaptics, ASchedulerThatStopsIsADeviceThatVanished) {
  Device& device = opened();
  EXPECT_EQ(device.read(state), Status::kOk);
  Status status = Status::kOk;
  int reads = 0;
  while (status != Status::kVanished && reads < 1000) {
    status = device.read(state);
    ++reads;
  }
  EXPECT_EQ(reads, 200);
}

TEST_F(OpenHaptics, CalibratesInTheInkwellByItself) {
  hd.calibration = 0x5001;
  hd.inkwell = 1;
  Device& device = opened();
  device.read(state);
  EXPECT_EQ(state.flags & kCalibrated, 0u);
  EXPECT_NE(state.flags & kDocked, 0u);
  EXPECT_EQ(hd.calibrated_with, 4u);
  hd.tick();
  device.read(state);
  EXPECT_NE(state.flags & kCalibrated, 0u);
}

TEST_F(OpenHaptics, ManualCalibrationAsksTheUser) {
  hd.calibration = 0x5002;
  hd.style = 4;
  Device& device = opened();
  EXPECT_THAT(device.calibrationText(0), HasSubstr("inkwell"));
  EXPECT_EQ(device.calibrationText(1), nullptr);
  EXPECT_EQ(hd.calibrated_with, 0u);
  device.calibrate(0);
  hd.tick();
  EXPECT_EQ(hd.calibrated_with, 4u);
}

TEST_F(OpenHaptics, TheInkwellIsEnoughForAManualOne) {
  hd.calibration = 0x5002;
  Device& device = opened();
  EXPECT_EQ(hd.calibrated_with, 0u);
  hd.inkwell = 1;
  hd.tick();
  hd.tick();
  EXPECT_EQ(hd.calibrated_with, 4u);
  device.read(state);
  EXPECT_NE(state.flags & kCalibrated, 0u);
}

TEST_F(OpenHaptics, TwoDevicesShareTheScheduler) {
  hd.known_names = {"Left Device", "Right Device"};
  Problem problem;
  Device* const left = driver.open("Left Device", problem);
  Device* const right = driver.open("Right Device", problem);
  ASSERT_NE(left, nullptr);
  ASSERT_NE(right, nullptr);
  hd.tick();
  EXPECT_EQ(left->read(state), Status::kOk);
  EXPECT_EQ(right->read(state), Status::kOk);
  driver.close(left);
  hd.tick();
  EXPECT_EQ(right->read(state), Status::kOk);
  EXPECT_TRUE(hd.running);
  driver.close(right);
  EXPECT_FALSE(hd.running);
  EXPECT_EQ(hd.closed, 2);
}

/// A whole force loop on it: contact, the cable is pulled out, nothing is left; plugged in again it is felt again.
TEST_F(OpenHaptics, UnpluggedInContact) {
  hd.position[1] = 5.0;
  haptic::DriverDeviceOptions options{.calls = haptic::DriverCalls::kInline};
  options.session.reopen_turns = 50;
  std::vector<std::string> told;
  options.session.report = [&](const std::string& sentence) { told.push_back(sentence); };
  haptic::DriverDevice device(driver, "", options);
  ASSERT_TRUE(device.open());
  hd.tick();
  haptic::ContactRig rig(device);
  rig.link.sendControl({.forces_enabled = true});
  rig.link.sendSet(haptic::floorSet(1));
  rig.run(1500, [&] { hd.tick(); });
  rig.run(80, [&] {
    hd.position[1] -= 0.1;
    hd.tick();
  });
  rig.run(100, [&] { hd.tick(); });
  EXPECT_GT(hd.force[1], 0.5);

  hd.errors = {{0x302, -28, 0}};
  hd.known_names.clear();
  rig.run(1, [&] { hd.tick(); });
  EXPECT_EQ(rig.force(), 0.0);
  EXPECT_FALSE(hd.force_output);
  EXPECT_TRUE(rig.loop.current().device_fault);
  ASSERT_FALSE(told.empty());
  EXPECT_THAT(told[0], HasSubstr("Communication error"));
  rig.run(300, [&] { hd.tick(); });
  EXPECT_FALSE(hd.force_output);

  hd.known_names = {"Default Device"};
  hd.position[1] = 5.0;
  rig.run(100, [&] { hd.tick(); });
  EXPECT_FALSE(rig.loop.current().device_fault);
  EXPECT_FALSE(hd.force_output) << "forces may not come back by themselves";
}

TEST_F(OpenHaptics, ItsLibraryIsTheFirstThatCanBeLoaded) {
  HdLibrary library;
  EXPECT_FALSE(library.isLoaded());
  EXPECT_EQ(library.load({"/nowhere/libHD.so.3", HAPTICELL_HD_STAND_IN, "/nowhere/other.so"}).status, Status::kOk);
  EXPECT_TRUE(library.isLoaded());
  EXPECT_EQ(library.file, HAPTICELL_HD_STAND_IN);
  EXPECT_EQ(library.load({"/nowhere/libHD.so"}).status, Status::kOk) << "loaded once for all";
  // The stand-in has the maker's numbers written out: the names here must be the same ones.
  hd.reset();
  const unsigned device = library.hdInitDevice("Default Device");
  EXPECT_NE(device, driver::hd::kBadHandle);
  EXPECT_EQ(library.hdGetError().code, 0u);
  library.hdMakeCurrentDevice(device);
  library.hdEnable(driver::hd::kForceOutput);
  EXPECT_TRUE(hd.force_output);
  library.hdDisable(driver::hd::kForceOutput);
  EXPECT_FALSE(hd.force_output);
  EXPECT_EQ(library.hdInitDevice("No such device"), driver::hd::kBadHandle);
  EXPECT_EQ(library.hdGetError().code, driver::hd::kCommError);
}

TEST_F(OpenHaptics, WhatCannotBeLoadedSaysWhyByItsFirstName) {
  HdLibrary none, old;
  const Problem missing = none.load({"/nowhere/first.so", "/nowhere/second.so"});
  EXPECT_EQ(missing.status, Status::kMissingLibrary);
  EXPECT_THAT(missing.found, HasSubstr("/nowhere/first.so"));
  EXPECT_FALSE(none.isLoaded());
  const Problem lacks = old.load({HAPTICELL_HD_OLD});
  EXPECT_EQ(lacks.status, Status::kMissingLibrary);
  EXPECT_THAT(lacks.found, HasSubstr("hdDisableDevice"));
  EXPECT_FALSE(old.isLoaded());
}

}  // namespace
}  // namespace hapticell::driver
