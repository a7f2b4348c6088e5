// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/driver_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "config/configuration.h"
#include "haptic/devices/device_choice.h"
#include "haptic/devices/device_node.h"
#include "tests/haptic/devices/scripted_driver.h"
#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kExamples = HAPTICELL_EXAMPLE_DRIVERS;

TEST(DriverLibrary, LoadsTheExampleAndDrivesIt) {
  const auto driver = loadDriver(kExamples / "orbit.so");
  ASSERT_TRUE(driver) << driver.error().message();
  EXPECT_STREQ((*driver)->information().name, "orbit");
  const DriverView view = look(**driver);
  ASSERT_EQ(view.found.size(), 1u);
  EXPECT_EQ(view.found[0].problem.status, driver::Status::kOk);
  driver::Problem problem;
  EXPECT_EQ((*driver)->open("second", problem), nullptr);
  EXPECT_EQ(problem.status, driver::Status::kNotFound);
  driver::Device* const device = (*driver)->open("", problem);
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(look(**driver).found[0].problem.status, driver::Status::kInUse);
  driver::State state;
  EXPECT_EQ(device->read(state), driver::Status::kOk);
  EXPECT_NEAR(std::hypot(state.position[0], state.position[1]), 0.03, 1e-12);
  (*driver)->close(device);
}

TEST(DriverLibrary, RefusesWhatIsNoDriver) {
  const test::TemporaryFolder folder;
  const auto text = loadDriver(folder.write("text.so", "this is no library"));
  ASSERT_FALSE(text);
  EXPECT_THAT(text.error().message(), HasSubstr("text.so"));
  const auto empty = loadDriver(kExamples / "no_driver.so");
  ASSERT_FALSE(empty);
  EXPECT_THAT(empty.error().message(), HasSubstr("hapticell_driver"));
  const auto lacking = loadDriver(kExamples / "lacks_library.so");
  ASSERT_FALSE(lacking);
  EXPECT_THAT(lacking.error().message(), HasSubstr("a_function_that_nobody_has"));
  const auto old = loadDriver(kExamples / "old_version.so");
  ASSERT_FALSE(old);
  EXPECT_THAT(old.error().message(), HasSubstr("another version"));
}

TEST(DriverLibrary, LoadsNothingThatOthersMayHaveWritten) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const fs::path own = folder.path() / "drivers", file = own / "orbit.so";
  fs::create_directory(own);
  fs::copy_file(kExamples / "orbit.so", file);
  const auto refusal = [&] {
    const auto driver = loadDriver(file);
    return driver ? std::string() : driver.error().message();
  };
  fs::permissions(file, fs::perms::all);
  EXPECT_THAT(refusal(), HasSubstr("other users can write to it"));
  fs::permissions(file, fs::perms::owner_all);
  fs::permissions(own, fs::perms::all);
  EXPECT_THAT(refusal(), HasSubstr("drivers: other users can write to it"));
  fs::permissions(own, fs::perms::owner_all);
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(file.c_str(), 12345, 0), 0);
    EXPECT_THAT(refusal(), HasSubstr("it belongs to user 12345"));
    ASSERT_EQ(::chown(file.c_str(), 0, 0), 0);
  }
  EXPECT_EQ(refusal(), "");
  EXPECT_THAT(loadDriver("orbit.so").error().message(), HasSubstr("not an absolute path"));
}

TEST(DriverLibrary, LooksNowhereBelowTheCurrentFolder) {
  const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
  for (const char* value : {"", "home", "."}) {
    setenv("HOME", value, 1);
    setenv("HAPTICELL_DRIVERS", "drivers:./x::", 1);
    for (const auto& folder : driverFolders()) EXPECT_TRUE(folder.is_absolute()) << folder;
  }
  unsetenv("HAPTICELL_DRIVERS");
  setenv("HOME", home.c_str(), 1);
}

TEST(DriverLibrary, ListsTheGoodAndTheBadOfAFolder) {
  const std::vector<LoadedDriver> drivers =
      loadDrivers({kExamples, kExamples / "nowhere"}, {{"orbit", {{"speed", "2"}}}});
  int good = 0, bad = 0;
  for (const LoadedDriver& driver : drivers) (driver.driver != nullptr ? good : bad) += 1;
  EXPECT_EQ(good, 4);  // orbit, and needy, counted, handy that other tests use
  EXPECT_EQ(bad, 3);
}

TEST(DriverLibrary, ADriverThatDoesNotAnswerIsLeftToItself) {
  class Silent final : public driver::Driver {
   public:
    const driver::Information& information() const noexcept override { return about; }
    std::uint32_t find(driver::Found*, std::uint32_t, driver::Problem&) noexcept override {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return may_go; });
      gone = true;
      changed.notify_all();
      return 0;
    }
    driver::Device* open(const char*, driver::Problem&) noexcept override { return nullptr; }
    void close(driver::Device*) noexcept override {}
    driver::Information about{};
    std::mutex mutex;
    std::condition_variable changed;
    bool may_go = false, gone = false;
  } silent;
  EXPECT_EQ(look(silent, 0.0).problem.status, driver::Status::kFault);
  std::unique_lock lock(silent.mutex);
  silent.may_go = true;
  silent.changed.notify_all();
  silent.changed.wait(lock, [&] { return silent.gone; });
}

TEST(DeviceChoice, ANameIsAProfileOrADriver) {
  EXPECT_EQ(parseDeviceName("touch").driver, "");
  EXPECT_EQ(parseDeviceName("falcon").driver, "falcon");
  EXPECT_EQ(parseDeviceName("haply:ws://127.0.0.1:10001").id, "ws://127.0.0.1:10001");
  const auto none = makeDevice("no_such_device", {});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), HasSubstr("phantom_desktop"));
}

TEST(DeviceChoice, MakesADeviceOfAPlugIn) {
  setenv("HAPTICELL_DRIVERS", kExamples.c_str(), 1);
  const auto device = makeDevice("orbit", {});
  unsetenv("HAPTICELL_DRIVERS");
  ASSERT_TRUE(device) << device.error().message();
  ASSERT_TRUE((*device)->open());
  EXPECT_EQ((*device)->capabilities().name, "Orbit");
  (*device)->close();
}

TEST(DeviceNode, SaysWhatMendsIt) {
  EXPECT_EQ(driver::nodeProblem("/dev/null").status, driver::Status::kOk);
  EXPECT_EQ(driver::nodeProblem("/dev/no_such_node").status, driver::Status::kNotFound);
  EXPECT_EQ(driver::nodeProblem("/dev/null", EBUSY).status, driver::Status::kInUse);
  const driver::Problem denied = driver::nodeProblem("/dev/null", EACCES);
  EXPECT_EQ(denied.status, driver::Status::kNoPermission);
  EXPECT_THAT(denied.fix, HasSubstr("udevadm control --reload"));
  EXPECT_THAT(denied.fix, HasSubstr("70-hapticell.rules"));
}

TEST(Settings, OfDriversAreTakenAsTheyStand) {
  config::Configuration configuration;
  ASSERT_TRUE(config::setValue(configuration, "driver.cyberglove.port", "/dev/ttyUSB3"));
  EXPECT_EQ(configuration.drivers["cyberglove"]["port"], "/dev/ttyUSB3");
  EXPECT_FALSE(config::setValue(configuration, "driver.cyberglove", "x"));
}

}  // namespace
}  // namespace hapticell::haptic
