// SPDX-License-Identifier: Apache-2.0
#include "config/device_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_data.h"

namespace hapticell::config {
namespace {

using ::testing::HasSubstr;

std::string problem(std::string_view text) {
  const auto profile = parseDeviceProfile(text, "mine.toml");
  return profile ? "no problem" : profile.error().message();
}

TEST(DeviceProfile, TheShippedDefaultIsTheBuiltInOne) {
  const auto profile = readDeviceProfile(test::sourceFile("config/devices/phantom_desktop.toml"));
  ASSERT_TRUE(profile.has_value()) << profile.error().message();
  EXPECT_EQ(*profile, DeviceProfile{});
}

TEST(DeviceProfile, TheDefaultIsThePapersDevice) {
  const DeviceProfile profile;
  EXPECT_EQ(profile.workspace, dvec3(0.160, 0.130, 0.130));
  EXPECT_EQ(profile.resolution, 0.02e-3);
  EXPECT_EQ(profile.measured_axes, 6);
  EXPECT_EQ(profile.driven_axes, 3);
  EXPECT_EQ(profile.peak_force, 6.4);
  EXPECT_EQ(profile.continuous_force, 1.4);
}

TEST(DeviceProfile, EveryShippedProfileIsGoodAndNamesItself) {
  for (const char* name : {"phantom_desktop", "touch", "touch_x", "premium", "premium_6dof"}) {
    const auto profile = readDeviceProfile(test::sourceFile(std::string("config/devices/") + name + ".toml"));
    ASSERT_TRUE(profile.has_value()) << profile.error().message();
    EXPECT_THAT(profile->name, HasSubstr("simulated"));
    EXPECT_GT(profile->peak_force, profile->continuous_force);
  }
}

TEST(DeviceProfile, DrivesTurningOnlyWithATorque) {
  EXPECT_THAT(problem("[capabilities]\ndriven_axes = 6\n"), HasSubstr("above 0 with driven_axes = 6"));
  EXPECT_THAT(problem("[capabilities]\npeak_torque = 0.2\n"), HasSubstr("above 0 with driven_axes = 6"));
  EXPECT_THAT(problem("[capabilities]\ndriven_axes = 5\n"), HasSubstr("3 (force) or 6"));
}

TEST(DeviceProfile, KeepsDefaultsOfKeysThatAreMissing) {
  const auto profile = parseDeviceProfile("[mechanics]\nweight = 0.2\n", "mine.toml");
  ASSERT_TRUE(profile.has_value());
  EXPECT_EQ(profile->mechanics.weight, 0.2);
  EXPECT_EQ(profile->peak_force, 6.4);
  EXPECT_EQ(*parseDeviceProfile("", "mine.toml"), DeviceProfile{});
}

TEST(DeviceProfile, NamesLineKeyAndRangeOfABadValue) {
  EXPECT_EQ(problem("[capabilities]\n\npeak_force = 900.0\n"),
            "mine.toml, line 3, key 'capabilities.peak_force': 900; expected 0.1 .. 100");
  EXPECT_THAT(problem("[mechanics]\nweight = nan\n"), HasSubstr("key 'mechanics.weight': nan"));
  EXPECT_THAT(problem("[electronics]\ndelay_ticks = 1.5\n"), HasSubstr("not a whole number; expected 0 .. 15"));
  EXPECT_THAT(problem("[electronics]\ndelay_ticks = 99999999999\n"), HasSubstr("expected 0 .. 15"));
  EXPECT_THAT(problem("[capabilities]\nname = \"\"\n"), HasSubstr("the name is missing"));
  EXPECT_THAT(problem("[capabilities]\nname = 3\n"), HasSubstr("the name is missing"));
  EXPECT_THAT(problem("[capabilities]\nworkspace = [0.1, 0.1]\n"), HasSubstr("not a list of three numbers"));
  EXPECT_THAT(problem("[capabilities]\nworkspace = [0.1, 0.1, \"wide\"]\n"), HasSubstr("not a number"));
  EXPECT_THAT(problem("[capabilities]\nworkspace = [0.1, 0.1, -0.1]\n"), HasSubstr("0.01 .. 2"));
}

TEST(DeviceProfile, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(problem("[mechanics]\nwieght = 0.2\n"),
              HasSubstr("line 2, key 'mechanics.wieght': this key does not exist"));
  EXPECT_THAT(problem("[motors]\n"), HasSubstr("key 'motors': this key does not exist"));
  EXPECT_THAT(problem("mechanics = 3\n"), HasSubstr("not a table"));
}

TEST(DeviceProfile, RefusesForcesThatContradictEachOther) {
  EXPECT_THAT(problem("[capabilities]\npeak_force = 2.0\ncontinuous_force = 3.0\n"), HasSubstr("at most peak_force"));
}

TEST(DeviceProfile, NamesThePlaceOfASyntaxError) {
  EXPECT_THAT(problem("[capabilities]\npeak_force = \n"), HasSubstr("mine.toml, line 2"));
  EXPECT_THAT(problem(std::string_view("\0\xFF\xFE", 3)), HasSubstr("mine.toml, line 1"));
}

TEST(DeviceProfile, SaysWhichFileCannotBeRead) {
  const auto profile = readDeviceProfile("no/such/profile.toml");
  ASSERT_FALSE(profile.has_value());
  EXPECT_THAT(profile.error().message(), HasSubstr("no/such/profile.toml: the file does not exist"));
}

}  // namespace
}  // namespace hapticell::config
