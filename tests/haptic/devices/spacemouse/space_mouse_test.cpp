// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"
#include "tests/haptic/devices/spacemouse/scripted_hid.h"

namespace hapticell::driver {
namespace {

using Report = std::vector<std::uint8_t>;

TEST(SpaceMouseReports, SixBytesEachOfTranslationAndRotation) {
  SpaceMouseState state;
  // x 350, y -175, z 35, little-endian.
  EXPECT_EQ(takeSpaceMouseReport(Report{1, 0x5E, 0x01, 0x51, 0xFF, 0x23, 0x00}, state), Status::kOk);
  EXPECT_DOUBLE_EQ(state.motion[0], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[1], 0.5);   // To the user is -y of D.
  EXPECT_DOUBLE_EQ(state.motion[2], -0.1);  // Down is -z.
  EXPECT_EQ(takeSpaceMouseReport(Report{2, 0x00, 0x00, 0x00, 0x00, 0xA2, 0xFE}, state), Status::kOk);
  EXPECT_DOUBLE_EQ(state.motion[5], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[0], 1.0);  // The translation stands.
}

TEST(SpaceMouseReports, ThirteenBytesAreAllSixAxes) {
  SpaceMouseState state;
  const Report report{1, 0x5E, 0x01, 0, 0, 0, 0, 0xAF, 0x00, 0, 0, 0xFF, 0x7F};
  EXPECT_EQ(takeSpaceMouseReport(report, state), Status::kOk);
  EXPECT_DOUBLE_EQ(state.motion[0], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[3], 0.5);
  EXPECT_DOUBLE_EQ(state.motion[5], -1.0);  // Beyond full deflection is full deflection.
}

TEST(SpaceMouseReports, Buttons) {
  SpaceMouseState state;
  EXPECT_EQ(takeSpaceMouseReport(Report{3, 0x03, 0x00}, state), Status::kOk);
  EXPECT_EQ(state.buttons, 3u);
  EXPECT_EQ(takeSpaceMouseReport(Report{3, 0x00, 0x10, 0x00, 0x80, 0x55}, state), Status::kOk);
  EXPECT_EQ(state.buttons, 0x80001000u);
}

TEST(SpaceMouseReports, ShortOnesAndForeignOnesChangeNothing) {
  SpaceMouseState state;
  takeSpaceMouseReport(Report{1, 0x5E, 0x01, 0, 0, 0, 0}, state);
  for (const Report& report : {Report{}, Report{1}, Report{1, 2, 3, 4, 5, 6}, Report{2, 0}, Report{3}}) {
    EXPECT_EQ(takeSpaceMouseReport(report, state), Status::kGarbled);
  }
  EXPECT_EQ(takeSpaceMouseReport(Report{0x17, 9, 9, 9}, state), Status::kNothingNew);  // At the end of wireless bursts.
  EXPECT_DOUBLE_EQ(state.motion[0], 1.0);
}

TEST(SpaceMouseDriver, KnowsItsModelsAndNotTheMakersOtherThings) {
  EXPECT_STREQ(findSpaceMouseModel(0x256f, 0xc635)->name, "SpaceMouse Compact");
  EXPECT_EQ(findSpaceMouseModel(0x046d, 0xc52b), nullptr);  // A receiver of another make.
  EXPECT_TRUE(isOtherThanSpaceMouse(0x256f, 0xc651));       // A CadMouse.
  ScriptedHid script;
  script.devices = {{"/dev/null", "CadMouse", "", 0x256f, 0xc651, 1, 2},
                    {"/dev/null", "Keyboard of a new kind", "", 0x256f, 0xc700, 1, 6},
                    {"/dev/null", "SpaceMouse of a new kind", "42", 0x256f, 0xc701, 1, 8},
                    {"/dev/null", "SpaceNavigator", "", 0x046d, 0xc626, 0, 0},
                    {"/dev/null", "Mouse", "", 0x046d, 0xc077, 1, 2}};
  SpaceMouseDriver driver(std::make_unique<ScriptedHidBackend>(script));
  Found found[8];
  Problem problem;
  ASSERT_EQ(driver.find(found, 8, problem), 2u);
  EXPECT_STREQ(found[0].id, "42");
  EXPECT_STREQ(found[0].name, "SpaceMouse of a new kind");
  EXPECT_STREQ(found[1].name, "SpaceNavigator");
  EXPECT_EQ(found[0].kind, Kind::kSpaceMouse);
  EXPECT_EQ(driver.find(found, 1, problem), 2u);  // More than there is room for is only counted.
}

class OpenSpaceMouse : public ::testing::Test {
 protected:
  OpenSpaceMouse() : driver(std::make_unique<ScriptedHidBackend>(script)), session(driver, "", {.reopen_turns = 3}) {
    script.devices = {{"/dev/null", "", "", 0x256f, 0xc635, 1, 8}};
  }
  ScriptedHid script;
  SpaceMouseDriver driver;
  haptic::DriverSession session;
};

TEST_F(OpenSpaceMouse, LightGoesOnAndOff) {
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_EQ(script.written.at(0), (Report{4, 1}));
  session.close();
  EXPECT_EQ(script.written.back(), (Report{4, 0}));
}

TEST_F(OpenSpaceMouse, TakesAWholeBurstAtOnce) {
  ASSERT_EQ(session.open().status, Status::kOk);
  for (int i = 1; i <= 10; ++i) {
    script.reports.push_back(
        {1, static_cast<std::uint8_t>(35 * i & 0xFF), static_cast<std::uint8_t>(35 * i >> 8), 0, 0, 0, 0});
    script.reports.push_back({2, 0, 0, 0, 0, 0, 0});
  }
  script.reports.push_back({0x17, 0});
  EXPECT_DOUBLE_EQ(session.turn({}).state.motion[0], 1.0);
  EXPECT_TRUE(script.reports.empty());
}

TEST_F(OpenSpaceMouse, ADeflectionWhoseEndWasLostEnds) {
  ASSERT_EQ(session.open().status, Status::kOk);
  script.reports.push_back({1, 0x5E, 0x01, 0, 0, 0, 0});
  session.turn({});
  for (int i = 0; i < SpaceMouseDevice::kPatience - 1; ++i) session.turn({});
  EXPECT_DOUBLE_EQ(session.turn({}).state.motion[0], 0.0);
}

TEST_F(OpenSpaceMouse, UnpluggedAndPluggedInAgain) {
  ASSERT_EQ(session.open().status, Status::kOk);
  script.reports.push_back({1, 0x5E, 0x01, 0, 0, 0, 0});
  session.turn({});
  script.gone = true;
  EXPECT_EQ(session.turn({}).status, Status::kVanished);
  script.devices.clear();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(session.turn({}).status, Status::kVanished);
  script.gone = false;
  script.devices = {{"/dev/null", "", "", 0x256f, 0xc635, 1, 8}};
  for (int i = 0; i < 3; ++i) session.turn({});
  EXPECT_EQ(session.turn({}).status, Status::kOk);
}

TEST_F(OpenSpaceMouse, NoPermission) {
  refuse(script.refuses, Status::kNoPermission, "/dev/hidraw0 may not be opened: Permission denied");
  EXPECT_EQ(session.open().status, Status::kNoPermission);
}

TEST_F(OpenSpaceMouse, GarbageForLongIsADeviceThatFailed) {
  ASSERT_EQ(session.open().status, Status::kOk);
  int turns = 0;
  Status status = Status::kOk;
  while (status == Status::kOk && turns < 100) {
    script.reports.push_back({1, 1, 2});
    status = session.turn({}).status;
    ++turns;
  }
  EXPECT_EQ(status, Status::kGarbled);
  EXPECT_EQ(turns, 20);
}

}  // namespace
}  // namespace hapticell::driver
