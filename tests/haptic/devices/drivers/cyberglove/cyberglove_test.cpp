// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "haptic/devices/driver_session.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/cyberglove/cyberglove_driver.h"
#include "mannequin/motion/glove_mapping.h"
#include "tests/haptic/devices/drivers/cyberglove/fake_glove.h"

namespace hapticell::driver {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint8_t> narrowFrame(std::size_t sensors, int first, int status) {
  std::vector<std::uint8_t> bytes{'S'};
  for (std::size_t i = 0; i < sensors; ++i) bytes.push_back(static_cast<std::uint8_t>(first + static_cast<int>(i)));
  if (status >= 0) bytes.push_back(static_cast<std::uint8_t>(status));
  bytes.push_back(0);
  return bytes;
}

std::vector<std::uint8_t> wideFrame(unsigned first) {
  std::vector<std::uint8_t> bytes{0x0D, 0x0A, 0x00};
  for (const char letter : std::string("12:34:56.7890S")) bytes.push_back(static_cast<std::uint8_t>(letter));
  for (unsigned i = 0; i < 22; ++i) {
    bytes.push_back(static_cast<std::uint8_t>((first + i) >> 8));
    bytes.push_back(static_cast<std::uint8_t>((first + i) & 0xFF));
  }
  return bytes;
}

TEST(GloveFrames, EighteenAndTwentyTwoSensorsByteByByte) {
  for (const std::size_t sensors : {18u, 22u}) {
    GloveFrames frames({.sensors = sensors, .status = true});
    GloveSample sample;
    int found = 0;
    for (const std::uint8_t byte : narrowFrame(sensors, 60, 2))
      found += frames.take(std::span(&byte, 1), sample) ? 1 : 0;
    EXPECT_EQ(found, 1);
    EXPECT_EQ(sample.count, sensors);
    EXPECT_EQ(sample.readings[0], 60.0);
    EXPECT_EQ(sample.readings[sensors - 1], 60.0 + static_cast<double>(sensors) - 1.0);
    EXPECT_TRUE(sample.switch_on);
    EXPECT_EQ(frames.garbled(), 0u);
  }
}

TEST(GloveFrames, AFrameThatLacksAByteIsLostAndTheNextIsNot) {
  GloveFrames frames({.sensors = 22});
  std::vector<std::uint8_t> bytes = narrowFrame(22, 100, -1);
  bytes.erase(bytes.begin() + 7);
  for (const std::uint8_t noise : {0x11, 0x22, 0x00, 0x00}) bytes.push_back(noise);
  const std::vector<std::uint8_t> good = narrowFrame(22, 50, -1);
  bytes.insert(bytes.end(), good.begin(), good.end());
  GloveSample sample;
  EXPECT_TRUE(frames.take(bytes, sample));
  EXPECT_EQ(sample.readings[0], 50.0);
  EXPECT_EQ(frames.garbled(), 3u);
}

TEST(GloveFrames, SixteenBitsAlsoWhereTheDataLookLikeASync) {
  GloveFrames frames({.wide = true});
  std::vector<std::uint8_t> bytes = wideFrame(0x0D0A);  // Its first readings hold 0D 0A 0D 0B.
  bytes[3 + 14 + 2] = 0x00;                             // 0D 0A 00 in the middle of the readings.
  bytes[3 + 14 + 3] = 0x0B;
  const std::vector<std::uint8_t> next = wideFrame(1000);
  bytes.insert(bytes.end(), next.begin(), next.end());
  GloveSample sample;
  int found = 0;
  for (const std::uint8_t byte : bytes) found += frames.take(std::span(&byte, 1), sample) ? 1 : 0;
  EXPECT_EQ(found, 2);
  EXPECT_NEAR(sample.readings[0], 1000.0 * 255.0 / 4095.0, 1e-12);
  std::vector<std::uint8_t> bad = wideFrame(1000);
  bad[3 + 14 + 6] = 0xFF;  // 0xFFxx is beyond 4094.
  EXPECT_FALSE(frames.take(bad, sample));
}

/// Turns until `good` holds; a glove's thread has to be waited for.
template <typename Condition>
bool turnUntil(haptic::DriverSession& session, const Command& command, Condition&& good) {
  for (int i = 0; i < 30000; ++i) {
    if (good(session.turn(command))) return true;
  }
  return false;
}

TEST(CyberGlove, IsAskedWhatItIsAndStreams) {
  FakeGlove glove;
  CyberGloveDriver driver;
  driver.configure("port", glove.path().c_str());
  haptic::DriverSession session(driver, "");
  const Problem problem = session.open();
  ASSERT_EQ(problem.status, Status::kOk) << problem.found;
  EXPECT_EQ(session.capabilities().sensors, 22u);
  EXPECT_EQ(session.capabilities().vibrators, 6u);
  EXPECT_THAT(session.capabilities().name, HasSubstr("right hand"));
  ASSERT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.measurements > 0; }));
  glove.first = 77;
  glove.send(glove.frame('S'));
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.state.sensors[0] == 77.0; }));
  EXPECT_EQ(session.turn({}).state.buttons, 1u);
}

TEST(CyberGlove, IsPolledWhereThatIsWanted) {
  FakeGlove glove;
  glove.sensors = 18;
  CyberGloveDriver driver;
  driver.configure("mode", "poll");
  haptic::DriverSession session(driver, glove.path());
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.measurements >= 20; }));
  EXPECT_GE(glove.polls, 20);
  EXPECT_EQ(session.capabilities().sensors, 18u);
}

TEST(CyberGlove, VibratesOnContact) {
  FakeGlove glove;
  CyberGloveDriver driver;
  haptic::DriverSession session(driver, glove.path());
  ASSERT_EQ(session.open().status, Status::kOk);
  Command command;
  command.vibration[0] = 1.0;
  command.vibration[5] = 0.5;
  EXPECT_TRUE(turnUntil(session, command, [&](const auto&) { return !glove.vibrations().empty(); }));
  EXPECT_EQ(glove.vibrations()[0], (std::vector<std::uint8_t>{255, 0, 0, 0, 0, 128}));
}

TEST(CyberGlove, NoGloveAtTheBoxAndNobodyThere) {
  FakeGlove box;
  box.connected = 1;
  CyberGloveDriver driver;
  haptic::DriverSession session(driver, box.path());
  EXPECT_THAT(session.open().found, HasSubstr("no glove is connected"));
  box.silent = true;
  EXPECT_THAT(session.open().found, HasSubstr("no glove answers"));
  CyberGloveDriver nowhere;
  haptic::DriverSession lost(nowhere, "/dev/no_such_port");
  EXPECT_EQ(lost.open().status, Status::kNotFound);
  haptic::DriverSession no_port(nowhere, "/dev/null");
  EXPECT_THAT(no_port.open().found, HasSubstr("is no serial port"));
}

TEST(CyberGlove, APortThatAnotherProgramHas) {
  FakeGlove glove;
  Problem problem;
  const auto other = SerialPort::open(glove.path(), problem);
  ASSERT_NE(other, nullptr);
  CyberGloveDriver driver;
  driver.configure("port", glove.path().c_str());
  Found found[4];
  ASSERT_EQ(driver.find(found, 4, problem), 1u);
  EXPECT_EQ(found[0].problem.status, Status::kInUse);
  haptic::DriverSession session(driver, "");
  EXPECT_EQ(session.open().status, Status::kInUse);
}

TEST(CyberGlove, UnpluggedWhileInUse) {
  FakeGlove glove;
  CyberGloveDriver driver;
  std::string told;
  haptic::DriverSession session(driver, glove.path(), {.report = [&](const std::string& text) { told = text; }});
  ASSERT_EQ(session.open().status, Status::kOk);
  glove.unplug();
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kVanished; }));
  EXPECT_THAT(told, HasSubstr("serial port has gone"));
}

TEST(CyberGlove, PluggedInAgainItIsReadAgain) {
  auto glove = std::make_unique<FakeGlove>();
  const std::string link = ::testing::TempDir() + "hapticell-glove-" + std::to_string(getpid());
  unlink(link.c_str());
  ASSERT_EQ(symlink(glove->path().c_str(), link.c_str()), 0);
  CyberGloveDriver driver;
  std::vector<std::string> told;
  haptic::DriverSession session(driver, link,
                                {.reopen_turns = 5, .report = [&](const std::string& text) { told.push_back(text); }});
  ASSERT_EQ(session.open().status, Status::kOk);
  glove->unplug();
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kVanished; }));
  unlink(link.c_str());
  for (int i = 0; i < 50; ++i) session.turn({});
  EXPECT_FALSE(session.isOpen());
  glove = std::make_unique<FakeGlove>();
  glove->first = 77;
  ASSERT_EQ(symlink(glove->path().c_str(), link.c_str()), 0);  // As udev names it again.
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.state.sensors[0] == 77.0; }));
  EXPECT_THAT(told.back(), HasSubstr("answers again"));
  unlink(link.c_str());
}

/// What hangs on a port is not disturbed: a port that another program has open is looked at all the same.
TEST(CyberGlove, ItsPresenceTellsThatAPortCameAndWentAndOpensNone) {
  const std::string link = ::testing::TempDir() + "hapticell-presence-" + std::to_string(getpid());
  unlink(link.c_str());
  CyberGloveDriver driver;
  driver.configure("port", link.c_str());
  const std::uint64_t none = driver.presence();
  EXPECT_EQ(driver.presence(), none);
  FakeGlove glove;
  ASSERT_EQ(symlink(glove.path().c_str(), link.c_str()), 0);
  const std::uint64_t there = driver.presence();
  EXPECT_NE(there, none);
  Problem problem;
  const auto port = SerialPort::open(glove.path(), problem);
  ASSERT_NE(port, nullptr) << problem.found;
  EXPECT_EQ(driver.presence(), there);
  EXPECT_EQ(glove.polls, 0);
  unlink(link.c_str());
  EXPECT_EQ(driver.presence(), none);
}

TEST(CyberGlove, GarbageIsBorneAndTheNextFrameIsRead) {
  FakeGlove glove;
  CyberGloveDriver driver;
  driver.configure("mode", "poll");
  haptic::DriverSession session(driver, glove.path());
  ASSERT_EQ(session.open().status, Status::kOk);
  glove.send({0xFF, 0x00, 'G', 1, 2, 0, 0x47, 0x80, 0x00});
  glove.first = 99;
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) {
    return answer.status == Status::kOk && answer.state.sensors[0] == 99.0 && answer.state.sensors[21] == 120.0;
  }));
}

TEST(CyberGlove, APortThatThisUserMayNotOpenIsSaidWithItsFix) {
  FakeGlove glove;
  ASSERT_EQ(chmod(glove.path().c_str(), 0), 0);
  const uid_t own = geteuid();
  if (own == 0) {
    ASSERT_EQ(seteuid(65534), 0);  // Root may open everything.
  }
  CyberGloveDriver driver;
  driver.configure("port", glove.path().c_str());
  Found found[4];
  Problem problem;
  const std::uint32_t count = driver.find(found, 4, problem);
  haptic::DriverSession session(driver, "");
  const Problem refused = session.open();
  if (own == 0) {
    ASSERT_EQ(seteuid(0), 0);
  }
  ASSERT_EQ(count, 1u);
  EXPECT_EQ(found[0].problem.status, Status::kNoPermission) << found[0].problem.found;
  EXPECT_THAT(found[0].problem.fix, HasSubstr("sudo"));
  EXPECT_EQ(refused.status, Status::kNoPermission);
}

TEST(CyberGlove, ASilentGloveIsAskedAgainAndThenGivenUp) {
  FakeGlove glove;
  CyberGloveDriver driver;
  haptic::DriverSession session(driver, glove.path());
  ASSERT_EQ(session.open().status, Status::kOk);
  glove.silent = true;
  const int asked = glove.polls;
  EXPECT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.status == Status::kVanished; }));
  EXPECT_GE(glove.polls - asked, CyberGloveDevice::kMostAsked - 1);
}

/// What the driver gives is what the mannequin's hand map takes: a fist's readings close the hand.
TEST(CyberGlove, PosesTheMannequinsHand) {
  mannequin::GloveCalibrationPoses poses;
  poses.flat.fill(40.0);
  poses.fist.fill(200.0);
  poses.spread.fill(90.0);
  poses.thumb_under.fill(120.0);
  const auto calibration = mannequin::calibrateGlove(poses);
  ASSERT_TRUE(calibration);
  FakeGlove glove;
  CyberGloveDriver driver;
  haptic::DriverSession session(driver, glove.path());
  ASSERT_EQ(session.open().status, Status::kOk);
  glove.first = 178;  // 178 .. 199: nearly a fist.
  glove.send(glove.frame('S'));
  ASSERT_TRUE(turnUntil(session, {}, [](const auto& answer) { return answer.state.sensors[0] == 178.0; }));
  const auto& state = session.turn({}).state;
  const auto readings = mannequin::gloveReadings(std::span(state.sensors).first(session.capabilities().sensors));
  ASSERT_TRUE(readings);
  mannequin::Posture open, closed;
  const mannequin::Dof curl = mannequin::armDof(mannequin::Side::kRight, mannequin::Dof::kLeftFingersCurl);
  mannequin::setHandFromGlove(mannequin::gloveAngles(*calibration, poses.flat), mannequin::Side::kRight, open);
  mannequin::setHandFromGlove(mannequin::gloveAngles(*calibration, *readings), mannequin::Side::kRight, closed);
  EXPECT_GT(closed[curl], open[curl] + 0.5);
}

}  // namespace
}  // namespace hapticell::driver
