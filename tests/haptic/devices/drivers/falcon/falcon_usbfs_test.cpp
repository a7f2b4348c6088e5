// SPDX-License-Identifier: Apache-2.0
// The real libusb on a mocked USB, as an unprivileged user; run under umockdev-wrapper.
#include <gtest/gtest.h>
#include <unistd.h>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/drivers/falcon/falcon_driver.h"
#include "tests/haptic/devices/drivers/falcon/mock_usbfs.h"

namespace hapticell::driver {
namespace {

class FalconUsbfs : public ::testing::Test {
 protected:
  FalconUsbfs() : driver(usbDevices, openFalconPort, libusbVersion()) { falcon.running = falcon.homed = true; }
  FakeFalcon falcon;
  FalconDriver driver;
};

TEST_F(FalconUsbfs, IsFoundOpenedReadAndPushed) {
  MockUsbfs mock(falcon);
  ASSERT_TRUE(mock.isThere());
  falcon.p_F = FalconArm::middle() + dvec3(0.02, 0.0, 0.0);
  Found found[2];
  Problem problem;
  ASSERT_EQ(driver.find(found, 2, problem), 1u);
  EXPECT_STREQ(found[0].id, "FL0042");
  EXPECT_STREQ(found[0].place, "usb 1-4");
  EXPECT_EQ(found[0].problem.status, Status::kOk) << found[0].problem.found;
  haptic::DriverSession session(driver, "FL0042", {.now = [] { return std::int64_t{1}; }});
  problem = session.open();
  ASSERT_EQ(problem.status, Status::kOk) << problem.found;
  Command push;
  push.motors = true;
  push.force[2] = 2.0;
  for (int i = 0; i < 200 && session.turn({}).measurements < 2; ++i) {
  }
  for (int i = 0; i < 200 && session.turn(push).measurements < 20; ++i) {
  }
  const haptic::DriverAnswer& answer = session.turn(push);
  EXPECT_GE(answer.measurements, 20u);
  EXPECT_NEAR(answer.state.position[0], 0.02, 1e-4);
  EXPECT_NE(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
  session.close();
  EXPECT_EQ(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
}

TEST_F(FalconUsbfs, UnpluggedWhileItPushes) {
  MockUsbfs mock(falcon);
  haptic::DriverSession session(driver, "");
  ASSERT_EQ(session.open().status, Status::kOk);
  session.turn({});
  falcon.gone = true;
  Status status = Status::kOk;
  for (int i = 0; i < 300 && status == Status::kOk; ++i) status = session.turn({}).status;
  EXPECT_EQ(status, Status::kVanished);
}

TEST_F(FalconUsbfs, InUseByAnotherProgram) {
  MockUsbfs mock(falcon);
  mock.in_use = true;
  Problem problem;
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kInUse) << problem.found;
}

TEST_F(FalconUsbfs, AFileThatMayNotBeOpenedIsSaidWithItsFix) {
  MockUsbfs mock(falcon);
  mock.forbid();
  Found found[2];
  Problem problem;
  ASSERT_EQ(driver.find(found, 2, problem), 1u);
  EXPECT_EQ(found[0].problem.status, Status::kNoPermission);
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNoPermission) << problem.found;
  EXPECT_NE(std::strstr(problem.fix, "udevadm"), nullptr);
}

TEST_F(FalconUsbfs, ItsPresenceTellsThatItCameAndWentAndMayBeOpened) {
  const std::uint64_t none = driver.presence();
  EXPECT_EQ(driver.presence(), none);
  EXPECT_NE(none, 0u);
  {
    MockUsbfs mock(falcon);
    const std::uint64_t there = driver.presence();
    EXPECT_NE(there, none);
    EXPECT_EQ(driver.presence(), there);
    mock.forbid();
    EXPECT_NE(driver.presence(), there) << "permission is part of what is listed";
  }
  EXPECT_EQ(driver.presence(), none);
}

}  // namespace
}  // namespace hapticell::driver

int main(int count, char** words) {
  // Root may open everything: these tests are those of an ordinary user.
  if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) return 1;
  testing::InitGoogleTest(&count, words);
  return RUN_ALL_TESTS();
}
