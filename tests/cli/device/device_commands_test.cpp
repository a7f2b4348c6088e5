// SPDX-License-Identifier: Apache-2.0
#include "cli/device/device_commands.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "cli/device/device_list.h"
#include "cli/device/health_check.h"
#include "cli/device/program_answer.h"
#include "cli/device/typed_code.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/system_access.h"
#include "tests/cli/kit/kept_words.h"

namespace hapticell::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(DeviceCommands, TakeTheirWords) {
  test::expectRefusals({addDevicesCommand, addDoctorCommand, addPairCommand},
                       {{{"devices", "--watch"}, ""},
                        {{"devices", "stylus"}, "stylus"},
                        {{"doctor", "--config", "own.toml"}, ""},
                        {{"doctor", "--watch"}, "--watch"},
                        {{"pair"}, "server is required"},
                        {{"pair", "station:4711", "-", "--unchecked"}, ""}});
}

TEST(DeviceCommands, WhatCannotBePairedIsASentence) {
  test::OneCommand pair({addPairCommand});
  EXPECT_THAT(pair.error({"pair", ":80", "abc", "--unchecked"}), HasSubstr("HOST:PORT"));
  EXPECT_THAT(pair.error({"pair", "station", "no code", "--unchecked"}), Not(IsEmpty()));
}

/// A driver in this process: sees two devices, or crashes.
class TestDriver final : public driver::Driver {
 public:
  const driver::Information& information() const noexcept override { return information_; }
  std::uint32_t find(driver::Found* found, std::uint32_t room, driver::Problem&) noexcept override {
    if (crashes) std::_Exit(3);
    if (room < 2) return 0;
    driver::copyText(found[0].id, "7");
    driver::copyText(found[0].name, "Arm\x1b[2J");
    driver::copyText(found[0].place, "usb 1-4");
    driver::refuse(found[1].problem, driver::Status::kFault, "no answer", "Switch it on.");
    found[1].kind = driver::Kind::kGlove;
    return 2;
  }
  driver::Device* open(const char*, driver::Problem&) noexcept override { return nullptr; }
  void close(driver::Device*) noexcept override {}
  bool crashes = false;

 private:
  driver::Information information_{"own", "Own arm", "3", "", "Untested."};
};

TEST(DeviceList, ADriverIsAskedApart) {
  TestDriver driver;
  const DriverEntries entries = entriesAskedApart({"/lib/own.so", &driver, {}});
  EXPECT_EQ(entries.driver["name"], "own");
  EXPECT_EQ(entries.driver["usable"], true);
  EXPECT_TRUE(entries.driver["library"].is_null());
  EXPECT_EQ(entries.driver["note"], "Untested.");
  ASSERT_EQ(entries.devices.size(), 2U);
  EXPECT_EQ(entries.devices[0]["device"], "own:7");
  EXPECT_EQ(entries.devices[0]["kind"], "stylus");
  EXPECT_EQ(entries.devices[0]["place"], "usb 1-4");
  EXPECT_EQ(entries.devices[0]["usable"], true);
  EXPECT_TRUE(entries.devices[0]["problem"].is_null());
  EXPECT_THAT(entries.devices[0]["name"].get<std::string>(), Not(HasSubstr("\x1b")));
  EXPECT_EQ(entries.devices[1]["device"], "own") << "without an id";
  EXPECT_EQ(entries.devices[1]["kind"], "glove");
  EXPECT_EQ(entries.devices[1]["usable"], false);
  EXPECT_EQ(entries.devices[1]["reason"], "fault");
  EXPECT_EQ(entries.devices[1]["fix"], "Switch it on.");
}

TEST(DeviceList, ACrashIsTheDriversProblem) {
  TestDriver driver;
  driver.crashes = true;
  const DriverEntries entries = entriesAskedApart({"/lib/own.so", &driver, {}});
  EXPECT_EQ(entries.driver["usable"], false);
  EXPECT_EQ(entries.driver["reason"], "fault");
  EXPECT_THAT(entries.driver["problem"].get<std::string>(), HasSubstr("it crashed"));
  EXPECT_THAT(entries.driver["fix"].get<std::string>(), HasSubstr("/lib/own.so"));
  EXPECT_TRUE(entries.devices.empty());
  const DriverEntries missing = entriesAskedApart({"/lib/other.so", nullptr, {.found = "libX is missing", .fix = "Get it."}});
  EXPECT_EQ(missing.driver["name"], "other");
  EXPECT_EQ(missing.driver["reason"], "missing_library");
  EXPECT_EQ(missing.driver["problem"], "libX is missing");
  EXPECT_EQ(missing.driver["fix"], "Get it.");
}

TEST(DeviceList, SimulatedStylusesComeFromTheirProfiles) {
  const DriverEntries entries = simulatedEntries();
  EXPECT_EQ(entries.driver["usable"], true);
  std::vector<std::string> names;
  for (const ordered_json& device : entries.devices) {
    names.push_back(device["device"]);
    EXPECT_EQ(device["simulated"], true);
    EXPECT_EQ(device["usable"], true) << device;
    EXPECT_TRUE(fs::is_regular_file(device["place"].get<std::string>()));
    EXPECT_NE(device["name"], device["device"]) << "the profile has a name for people";
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf({"phantom_desktop", "touch", "touch_x", "premium", "premium_6dof"}));
}

TEST(DeviceList, TheListingHasAllDevicesInOneList) {
  TestDriver driver;
  const auto own = entriesAskedApart({"/lib/own.so", &driver, {}});
  const ordered_json listing = listingOf({simulatedEntries(), own}, {"/a", "/b"});
  EXPECT_EQ(listing["drivers"].size(), 2U);
  EXPECT_EQ(listing["devices"].size(), simulatedEntries().devices.size() + 2);
  EXPECT_EQ(listing["devices"].back()["driver"], "own");
  EXPECT_EQ(listing["driver_folders"], ordered_json({"/a", "/b"}));
  EXPECT_EQ(listing["versions"]["driver_interface"], driver::kInterfaceVersion);
  EXPECT_EQ(listing["permissions"].size(), haptic::systemGrants().size());
}

TEST(HealthCheck, ADriverWithoutItsLibraryIsOnlyANote) {
  TestDriver driver;
  const auto own = entriesAskedApart({"/lib/own.so", &driver, {}});
  const auto missing = entriesAskedApart({"/lib/other.so", nullptr, {.found = "libX is missing", .fix = "Get it."}});
  driver.crashes = true;
  const auto crashed = entriesAskedApart({"/lib/own.so", &driver, {}});
  const auto checks = deviceChecks({own, missing, crashed});
  ASSERT_THAT(checks, SizeIs(4)) << "two devices, two drivers";
  EXPECT_EQ(checks[0].what, "device own:7");
  EXPECT_EQ(checks[0].health, Health::kGood);
  EXPECT_EQ(checks[1].health, Health::kProblem);
  EXPECT_THAT(checks[1].found, HasSubstr("no answer"));
  EXPECT_EQ(checks[1].fix, "Switch it on.");
  EXPECT_EQ(checks[2].what, "driver other");
  EXPECT_EQ(checks[2].health, Health::kNote);
  EXPECT_EQ(checks[3].health, Health::kProblem);
  for (const auto& drivers : {std::vector<DriverEntries>{}, std::vector{missing}}) {
    const auto none = deviceChecks(drivers);
    EXPECT_EQ(none.back().what, "devices");
    EXPECT_EQ(none.back().health, Health::kNote);
    EXPECT_THAT(none.back().fix, HasSubstr("hapticell-cli devices"));
  }
}

TEST(HealthCheck, GrantsAndProgramsAreThoseOfTheSystem) {
  const auto grants = haptic::systemGrants();
  const auto checks = grantChecks();
  ASSERT_EQ(checks.size(), grants.size());
  for (std::size_t i = 0; i < checks.size(); ++i) {
    EXPECT_EQ(checks[i].what, grants[i].what);
    EXPECT_EQ(checks[i].health == Health::kGood, grants[i].granted);
    EXPECT_EQ(checks[i].fix.empty(), grants[i].granted) << "what is missing has a command that fixes it";
  }
  for (const HealthCheck& check : programChecks()) {
    const fs::path program = siblingProgram(check.what);
    EXPECT_EQ(check.health == Health::kGood, !program.empty()) << check.what;
    EXPECT_EQ(check.fix.empty(), !program.empty());
  }
  for (const HealthCheck& check : graphicsChecks()) {
    EXPECT_THAT(check.found, Not(IsEmpty())) << check.what;
    EXPECT_EQ(check.found.find('\n'), std::string::npos) << check.found;
  }
}

TEST(HealthCheck, APortThatIsTakenAndSilentIsAProblem) {
  const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listening, 1), 0);
  ASSERT_EQ(getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size), 0);
  config::Configuration configuration;
  configuration.server.port = ntohs(address.sin_port);
  const std::string port = std::to_string(configuration.server.port);
  const HealthCheck taken = portCheck(configuration);
  EXPECT_EQ(taken.what, "port " + port);
  EXPECT_EQ(taken.health, Health::kProblem);
  EXPECT_THAT(taken.fix, HasSubstr("sport = :" + port));
  close(listening);
  EXPECT_EQ(portCheck(configuration).health, Health::kGood);
}

TEST(HealthCheck, FoldersThatAreNotThereYetAreJudgedByWhatIsAbove) {
  const test::TemporaryFolder folder;
  const std::string before = std::getenv("XDG_CONFIG_HOME") ? std::getenv("XDG_CONFIG_HOME") : "";
  setenv("XDG_CONFIG_HOME", (folder.path() / "not/yet").c_str(), 1);
  const auto checks = diskChecks();
  before.empty() ? unsetenv("XDG_CONFIG_HOME") : setenv("XDG_CONFIG_HOME", before.c_str(), 1);
  ASSERT_THAT(checks, SizeIs(3));
  EXPECT_EQ(checks[0].what, "disk, settings");
  EXPECT_THAT(checks[0].found, StartsWith((folder.path() / "not/yet").string()));
  EXPECT_THAT(checks[0].found, HasSubstr(" MB free"));
  EXPECT_FALSE(fs::exists(folder.path() / "not")) << "it only looks";
  const bool room = fs::space(folder.path()).available > 600'000'000;
  if (room) {
    EXPECT_EQ(checks[0].health, Health::kGood);
  }
}

TEST(ProgramAnswer, IsWhatGoesToStandardOutput) {
  EXPECT_EQ(answerOf("/bin/echo", {"a  b", "c"}, 30'000), "a  b c\n");
  EXPECT_EQ(answerOf("/bin/sh", {"-c", "echo aside >&2; cat; echo done"}, 30'000), "done\n") << "its input is empty";
  EXPECT_EQ(answerOf("/no/such/program", {}, 30'000), "");
  EXPECT_EQ(answerOf("/bin/sh", {"-c", "echo first; exec sleep 1000"}, 300), "first\n") << "it is not waited for";
}

TEST(ProgramAnswer, AProgramBesideThisOneIsFound) {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  EXPECT_EQ(siblingProgram(self.filename()), self);
  EXPECT_TRUE(siblingProgram("no-such-program-of-hapticell").empty());
}

/// Standard input, for a while.
class OtherInput {
 public:
  explicit OtherInput(int file) : before_(::dup(STDIN_FILENO)) { ::dup2(file, STDIN_FILENO); }
  ~OtherInput() {
    ::dup2(before_, STDIN_FILENO);
    ::close(before_);
  }
  OtherInput(const OtherInput&) = delete;
  OtherInput& operator=(const OtherInput&) = delete;

 private:
  int before_;
};

TEST(TypedCode, IsALineOfStandardInput) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string text = "abc-def\r\n" + std::string(201, 'x') + "\nlast";
  ASSERT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  close(ends[1]);
  const OtherInput input(ends[0]);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(readTypedCode("Code: ").value_or("?"), "abc-def");
  EXPECT_EQ(readTypedCode("Code: ").value_or("?"), "") << "the rest of a line that ends in CR LF";
  const auto longer = readTypedCode("Code: ");
  ASSERT_FALSE(longer);
  EXPECT_THAT(longer.error().message(), HasSubstr("over 200 characters"));
  EXPECT_EQ(readTypedCode("Code: ").value_or("?"), "") << "what was left of it";
  EXPECT_EQ(readTypedCode("Code: ").value_or("?"), "last") << "without an end of line";
  const auto none = readTypedCode("Code: ");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message(), HasSubstr("ended without a pairing code"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "nobody is asked";
  close(ends[0]);
}

TEST(TypedCode, IsNotShownOnATerminal) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  const int terminal = ::open(ptsname(master), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  const auto echoes = [&] {
    termios mode{};
    tcgetattr(terminal, &mode);
    return (mode.c_lflag & ECHO) != 0;
  };
  ASSERT_TRUE(echoes());
  ::testing::internal::CaptureStderr();
  std::thread user([&] {
    while (echoes()) std::this_thread::yield();
    EXPECT_EQ(write(master, "secret\n", 7), 7);
  });
  const auto code = [&] {
    const OtherInput input(terminal);
    return readTypedCode("Code: ");
  }();
  user.join();
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "Code: \n");
  EXPECT_EQ(code.value_or("?"), "secret");
  EXPECT_TRUE(echoes()) << "as before";
  fcntl(master, F_SETFL, O_NONBLOCK);
  char shown[100] = {};
  const ssize_t count = read(master, shown, sizeof shown - 1);
  EXPECT_EQ(std::string(shown, static_cast<std::size_t>(std::max<ssize_t>(count, 0))).find("secret"), std::string::npos);
  close(terminal);
  close(master);
}

}  // namespace
}  // namespace hapticell::cli
