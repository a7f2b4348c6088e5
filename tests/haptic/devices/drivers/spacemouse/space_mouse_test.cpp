// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"
#include "tests/haptic/devices/drivers/spacemouse/scripted_hid.h"
#include "tests/haptic/devices/drivers/spacemouse/space_mouse_descriptors.h"

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

TEST(HidLayout, ReadsWhatADescriptorStates) {
  const HidLayout layout = HidLayout::parse(kEnterpriseDescriptor);
  EXPECT_TRUE(layout.hasReportIds());
  EXPECT_TRUE(layout.statesAxes());
  ASSERT_EQ(layout.fields().size(), 6u + 31u + 6u);
  EXPECT_EQ(layout.fields()[5].usage, 0x35);
  EXPECT_EQ(layout.fields()[5].bit, 80u);
  EXPECT_EQ(layout.fields()[5].low, -350);
  EXPECT_EQ(layout.fields()[5].high, 350);
  EXPECT_EQ(layout.fields()[36].usage, 31);
  EXPECT_TRUE(layout.fields()[42].array);
  EXPECT_EQ(layout.fields()[42].report, 0x1C);
}

TEST(HidLayout, BrokenDescriptorsStateNothing) {
  EXPECT_FALSE(HidLayout::parse({}).statesAxes());
  for (std::size_t length = 0; length < kEnterpriseDescriptor.size(); ++length) {
    const Report cut(kEnterpriseDescriptor.begin(),
                     kEnterpriseDescriptor.begin() + static_cast<std::ptrdiff_t>(length));
    static_cast<void>(HidLayout::parse(cut));
  }
  EXPECT_TRUE(HidLayout::parse(Report{0xB4}).fields().empty()) << "a pop without a push";
  EXPECT_TRUE(HidLayout::parse(Report{0x75, 0x01, 0x97, 0xFF, 0xFF, 0xFF, 0xFF, 0x81, 0x02}).fields().empty());
}

TEST(SpaceMouseReports, ADescriptorsOwnOrderCounts) {
  const HidLayout layout = HidLayout::parse(kOtherOrderDescriptor);
  ASSERT_TRUE(layout.statesAxes());
  EXPECT_FALSE(layout.hasReportIds());
  SpaceMouseState state;
  // Button 3; z 127, y -127, x 64, rz 0, ry 0, rx -127.
  EXPECT_EQ(takeSpaceMouseReport(Report{0x04, 127, 0x81, 64, 0, 0, 0x81}, state, nullptr, &layout), Status::kOk);
  EXPECT_EQ(state.buttons, 4u);
  EXPECT_NEAR(state.motion[0], 64.0 / 127.0, 1e-12);
  EXPECT_DOUBLE_EQ(state.motion[1], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[2], -1.0);
  EXPECT_DOUBLE_EQ(state.motion[3], -1.0);
  EXPECT_TRUE(state.moved);
  EXPECT_EQ(takeSpaceMouseReport(Report{0x04, 127, 0x81}, state, nullptr, &layout), Status::kGarbled);
  EXPECT_DOUBLE_EQ(state.motion[1], 1.0) << "as it was";
}

/// spacenavd: these three have neither DF_SWAPYZ nor DF_INVYZ, all others both. Its own axes are right, up, away.
TEST(SpaceMouseReports, PlusXtClassicAndNuLooqPointUpAndAway) {
  for (const std::uint16_t product : {0xc603, 0xc606, 0xc640}) {
    const SpaceMouseModel* model = findSpaceMouseModel(0x046d, product);
    ASSERT_NE(model, nullptr);
    SpaceMouseState state;
    EXPECT_EQ(takeSpaceMouseReport(Report{1, 0x5E, 0x01, 0xAF, 0x00, 0x23, 0x00}, state, model), Status::kOk);
    EXPECT_DOUBLE_EQ(state.motion[0], 1.0);
    EXPECT_DOUBLE_EQ(state.motion[1], 0.1) << "z is away";
    EXPECT_DOUBLE_EQ(state.motion[2], 0.5) << "y is up";
    takeSpaceMouseReport(Report{2, 0, 0, 0x5E, 0x01, 0, 0}, state, model);
    EXPECT_DOUBLE_EQ(state.motion[5], 1.0) << "about up";
  }
}

struct Key {
  int evdev;   ///< Code that Linux gives it: 255 + usage.
  int number;  ///< spacenavd's.
};
std::uint32_t pressed(const SpaceMouseModel* model, const HidLayout* layout, int usage) {
  SpaceMouseState state;
  Report report{3, 0, 0, 0, 0};
  if (usage <= 31) {
    report[static_cast<std::size_t>(1 + (usage - 1) / 8)] = static_cast<std::uint8_t>(1 << (usage - 1) % 8);
  } else {
    report = {0x1C, static_cast<std::uint8_t>(usage), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  }
  EXPECT_EQ(takeSpaceMouseReport(report, state, model, layout), Status::kOk);
  const std::uint32_t down = state.buttons;
  std::fill(report.begin() + 1, report.end(), std::uint8_t{0});
  takeSpaceMouseReport(report, state, model, layout);
  EXPECT_EQ(state.buttons, 0u) << "let go";
  return down;
}

/// The numbers of spacenavd's bnhack_sment(); the usages of the first 22 are also PySpaceMouse's bytes and bits (BTN_1
/// [3, 2, 4] is usage 13), of all the report descriptor's.
TEST(SpaceMouseReports, KeysOfTheEnterprise) {
  const SpaceMouseModel* model = findSpaceMouseModel(0x256f, 0xc633);
  const HidLayout layout = HidLayout::parse(kEnterpriseDescriptor);
  constexpr Key kKeys[] = {{256, 12}, {257, 13}, {258, 14}, {260, 15}, {261, 16}, {264, 17}, {266, 30}, {268, 0},
                           {269, 1},  {270, 2},  {271, 3},  {272, 4},  {273, 5},  {274, 6},  {275, 7},  {276, 8},
                           {277, 9},  {278, 18}, {279, 19}, {280, 20}, {281, 21}, {282, 22}, {291, 23}, {292, 24},
                           {332, 10}, {333, 11}, {358, 27}, {359, 28}, {360, 29}, {430, 25}, {431, 26}};
  ASSERT_EQ(std::size(kKeys), 31u);
  for (const Key& key : kKeys) {
    EXPECT_EQ(pressed(model, &layout, key.evdev - 255), 1u << key.number) << key.evdev;
    EXPECT_EQ(pressed(model, nullptr, key.evdev - 255), 1u << key.number) << key.evdev << " without a descriptor";
  }
  SpaceMouseState state;
  takeSpaceMouseReport(Report{0x1C, 103, 0, 36, 0, 0, 0, 0, 0, 0, 0, 0, 0}, state, model, &layout);
  takeSpaceMouseReport(Report{3, 0, 0x10, 0, 0}, state, model, &layout);
  EXPECT_EQ(state.buttons, 1u << 27 | 1u << 23 | 1u << 0) << "V1, enter and 1 at once";
}

/// spacenavd's bnhack_smpro(); PySpaceMouse has the same bits.
TEST(SpaceMouseReports, KeysOfThePro) {
  constexpr Key kKeys[] = {{256, 4}, {257, 5}, {258, 6},  {260, 7},  {261, 8},  {264, 9},  {268, 0}, {269, 1},
                           {270, 2}, {271, 3}, {278, 11}, {279, 12}, {280, 13}, {281, 14}, {282, 10}};
  for (const std::uint16_t product : {0xc631, 0xc632, 0xc638}) {
    const SpaceMouseModel* model = findSpaceMouseModel(0x256f, product);
    ASSERT_EQ(model->buttons, std::size(kKeys));
    for (const Key& key : kKeys) EXPECT_EQ(pressed(model, nullptr, key.evdev - 255), 1u << key.number) << key.evdev;
  }
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
