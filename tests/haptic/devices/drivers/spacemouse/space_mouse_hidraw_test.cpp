// SPDX-License-Identifier: Apache-2.0
// The real hidapi on a mocked system, as an unprivileged user; run under umockdev-wrapper.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <string>
#include <vector>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"
#include "tests/haptic/devices/drivers/spacemouse/mock_hidraw.h"

namespace hapticell::driver {
namespace {

template <typename Condition>
bool turnUntil(haptic::DriverSession& session, Condition&& good) {
  for (int i = 0; i < 5000; ++i) {
    if (good(session.turn({}))) return true;
  }
  return false;
}

TEST(SpaceMouseHidraw, IsFoundOpenedReadAndLit) {
  MockHidraw mock;
  ASSERT_TRUE(mock.isThere());
  SpaceMouseDriver driver(makeHidapi());
  Found found[4];
  Problem problem;
  ASSERT_EQ(driver.find(found, 4, problem), 1u);
  EXPECT_STREQ(found[0].name, "SpaceMouse Compact");
  EXPECT_STREQ(found[0].place, "/dev/hidraw0");
  EXPECT_EQ(found[0].problem.status, Status::kOk) << found[0].problem.found;
  haptic::DriverSession session(driver, "");
  problem = session.open();
  ASSERT_EQ(problem.status, Status::kOk) << problem.found;
  mock.send({1, 0x5E, 0x01, 0, 0, 0, 0});
  mock.send({2, 0, 0, 0, 0, 0x51, 0xFF});
  mock.send({3, 2, 0});
  EXPECT_TRUE(turnUntil(session, [](const auto& answer) { return answer.state.buttons == 2; }));
  const State state = session.turn({}).state;
  EXPECT_DOUBLE_EQ(state.motion[0], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[5], 0.5);
  session.close();
  const auto written = mock.written();
  ASSERT_EQ(written.size(), 2u);  // Light on, light off.
  EXPECT_EQ(written[0], (std::vector<std::uint8_t>{4, 1}));
  EXPECT_EQ(written[1], (std::vector<std::uint8_t>{4, 0}));
}

/// Between two reports that belong together, the last of them cut off: what it moved stands still, and is picked up
/// where it comes back.
TEST(SpaceMouseHidraw, PulledOutInTheMiddleOfReportsAndPluggedInAgain) {
  MockHidraw mock;
  SpaceMouseDriver driver(makeHidapi());
  std::vector<std::string> told;
  haptic::DriverSession session(driver, "/dev/hidraw0", {.reopen_turns = 5, .report = [&](const std::string& sentence) {
                                                           told.push_back(sentence);
                                                         }});
  ASSERT_EQ(session.open().status, Status::kOk);
  mock.send({1, 0x5E, 0x01, 0, 0, 0, 0});
  mock.send({3, 1, 0});
  ASSERT_TRUE(turnUntil(session, [](const auto& answer) { return answer.state.buttons == 1; }));
  EXPECT_DOUBLE_EQ(session.turn({}).state.motion[0], 1.0);
  mock.send({1, 0x5E, 0x01, 0, 0});
  mock.unplug();
  ASSERT_TRUE(turnUntil(session, [&](const auto&) { return !session.isOpen(); }));
  const std::uint64_t measured = session.turn({}).measurements;
  ASSERT_FALSE(told.empty());
  EXPECT_NE(told.back().find("unplugged"), std::string::npos) << told.back();
  for (int i = 0; i < 20; ++i) session.turn({});
  EXPECT_FALSE(session.isOpen()) << "it is not there";
  EXPECT_EQ(session.turn({}).measurements, measured);

  mock.plug();
  ASSERT_TRUE(turnUntil(session, [&](const auto&) { return session.isOpen(); }));
  mock.send({1, 0, 0, 0x5E, 0x01, 0, 0});
  EXPECT_TRUE(turnUntil(session, [](const auto& answer) { return std::abs(answer.state.motion[1]) == 1.0; }));
}

TEST(SpaceMouseHidraw, AFileThatMayNotBeOpenedIsSaidWithItsFix) {
  MockHidraw mock;
  mock.forbid();
  SpaceMouseDriver driver(makeHidapi());
  Found found[4];
  Problem problem;
  ASSERT_EQ(driver.find(found, 4, problem), 1u);
  EXPECT_EQ(found[0].problem.status, Status::kNoPermission);
  EXPECT_NE(std::strstr(found[0].problem.fix, "udevadm"), nullptr);
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNoPermission);
}

TEST(SpaceMouseHidraw, ItsPresenceTellsThatItCameAndWentAndMayBeOpened) {
  MockHidraw mock;
  SpaceMouseDriver driver(makeHidapi());
  const std::uint64_t there = driver.presence();
  EXPECT_EQ(driver.presence(), there);
  mock.unplug();
  const std::uint64_t none = driver.presence();
  EXPECT_NE(none, there);
  EXPECT_NE(none, 0u);
  mock.plug();
  const std::uint64_t again = driver.presence();
  EXPECT_NE(again, none);
  mock.forbid();
  EXPECT_NE(driver.presence(), again);
}

TEST(SpaceMouseHidraw, NothingPluggedIn) {
  UMockdevTestbed* const empty = umockdev_testbed_new();
  SpaceMouseDriver driver(makeHidapi());
  Problem problem;
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNotFound);
  g_object_unref(empty);
}

}  // namespace
}  // namespace hapticell::driver

int main(int count, char** words) {
  // Root may open everything: these tests are those of an ordinary user.
  if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) return 1;
  testing::InitGoogleTest(&count, words);
  return RUN_ALL_TESTS();
}
