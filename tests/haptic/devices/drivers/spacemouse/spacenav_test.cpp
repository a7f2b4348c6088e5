// SPDX-License-Identifier: Apache-2.0
// The 3-D mouse of spacenavd: the real libspnav against a socket of the test's.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/spacemouse/space_mouse_driver.h"
#include "tests/haptic/devices/drivers/spacemouse/fake_spacenavd.h"
#include "tests/haptic/devices/drivers/spacemouse/scripted_hid.h"
#include "tests/support/test_data.h"

namespace hapticell::driver {
namespace {

constexpr int kPatience = 2000;  // ms

class Spacenav : public ::testing::TestWithParam<int> {
 protected:
  Spacenav() : driver(std::make_unique<ScriptedHidBackend>(hid), makeSpacenav()) {
    setenv("SPNAV_SOCKET", socket().c_str(), 1);
    hid.devices = {{"/dev/null", "", "", 0x256f, 0xc635, 1, 8}};
  }
  std::string socket() const { return (folder.path() / "spnav.sock").string(); }
  void start() { daemon.emplace(socket(), GetParam()); }
  Found only() {
    Found found[4];
    Problem problem;
    EXPECT_EQ(driver.find(found, 4, problem), 1u);
    return found[0];
  }
  static bool until(const std::function<bool()>& done) {
    for (int i = 0; i < kPatience && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return done();
  }

  const test::TemporaryFolder folder;
  ScriptedHid hid;
  std::optional<FakeSpacenavd> daemon;
  SpaceMouseDriver driver;
};

TEST_P(Spacenav, TheMouseComesFromTheDaemonWhereOneRuns) {
  EXPECT_STREQ(only().place, "/dev/null") << "directly, while none runs";
  const std::uint64_t before = driver.presence();
  start();
  EXPECT_NE(driver.presence(), before) << "it is noticed";
  const Found found = only();
  EXPECT_STREQ(found.id, SpaceMouseDriver::kSpacenavId);
  EXPECT_STREQ(found.name, "SpaceMouse Compact");
  EXPECT_EQ(found.place, socket());
  EXPECT_TRUE(hid.written.empty()) << "nobody else touches the device";
}

TEST_P(Spacenav, MotionAndKeys) {
  start();
  haptic::DriverSession session(driver, "", {.reopen_turns = 3});
  ASSERT_EQ(session.open().status, Status::kOk);
  ASSERT_TRUE(until([&] { return daemon->clients() == 1; }));
  State state;
  const auto reaches = [&](const std::function<bool()>& done) {
    return until([&] {
      state = session.turn({}).state;
      return done();
    });
  };
  // spacenavd: right, up, away, the same about; 500 is full deflection.
  daemon->move(500, 250, -125, 50, -100, 600);
  ASSERT_TRUE(reaches([&] { return state.motion[0] == 1.0; }));
  EXPECT_DOUBLE_EQ(state.motion[1], -0.25);
  EXPECT_DOUBLE_EQ(state.motion[2], 0.5);
  EXPECT_DOUBLE_EQ(state.motion[3], 0.1);
  EXPECT_DOUBLE_EQ(state.motion[4], 1.0);
  EXPECT_DOUBLE_EQ(state.motion[5], -0.2);
  daemon->press(1);
  ASSERT_TRUE(reaches([&] { return state.buttons == 2u; }));
  daemon->press(30);
  ASSERT_TRUE(reaches([&] { return state.buttons == (2u | 1u << 30); }));
  daemon->release(1);
  ASSERT_TRUE(reaches([&] { return state.buttons == 1u << 30; }));
  daemon->send({3, 0, 1, 0, 0, 0, 0, 0});  // A device has come: nothing of ours.
  daemon->press(40);                       // More keys than a state holds.
  daemon->move(0, 0, 0, 0, 0, 0);
  ASSERT_TRUE(reaches([&] { return state.motion[0] == 0.0; }));
  EXPECT_EQ(state.buttons, 1u << 30);
}

/// It says a deflection once: unlike a report that was lost it stands.
TEST_P(Spacenav, ADeflectionStands) {
  start();
  haptic::DriverSession session(driver, "", {.reopen_turns = 3});
  ASSERT_EQ(session.open().status, Status::kOk);
  daemon->move(250, 0, 0, 0, 0, 0);
  State state;
  ASSERT_TRUE(until([&] { return (state = session.turn({}).state).motion[0] == 0.5; }));
  for (int i = 0; i < SpaceMouseDevice::kPatience + 50; ++i) state = session.turn({}).state;
  EXPECT_DOUBLE_EQ(state.motion[0], 0.5);
}

TEST_P(Spacenav, WhenTheDaemonEndsTheMouseIsReadDirectly) {
  start();
  haptic::DriverSession session(driver, "", {.reopen_turns = 3});
  ASSERT_EQ(session.open().status, Status::kOk);
  daemon.reset();
  ASSERT_TRUE(until([&] { return session.turn({}).status == Status::kVanished; }));
  hid.reports.push_back({1, 0x5E, 0x01, 0, 0, 0, 0});
  State state;
  EXPECT_TRUE(until([&] { return (state = session.turn({}).state).motion[0] == 1.0; }));
}

TEST_P(Spacenav, WithoutAMouseThereIsNone) {
  hid.devices.clear();
  start();
  Found found[4];
  Problem problem;
  // A daemon before 1.0 does not tell of its devices; a newer one tells of what only it can see.
  EXPECT_EQ(driver.find(found, 4, problem), GetParam() == 0 ? 0u : 1u);
}

INSTANTIATE_TEST_SUITE_P(Protocols, Spacenav, ::testing::Values(0, 1));

}  // namespace
}  // namespace hapticell::driver
