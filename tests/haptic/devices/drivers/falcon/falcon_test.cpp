// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "haptic/devices/driver_device.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/falcon/falcon_arm.h"
#include "haptic/devices/drivers/falcon/falcon_driver.h"
#include "haptic/devices/drivers/falcon/falcon_firmware.h"
#include "tests/haptic/devices/contact_rig.h"
#include "tests/haptic/devices/drivers/falcon/fake_falcon.h"
#include "tests/support/test_data.h"

namespace hapticell::driver {
namespace {

using ::testing::HasSubstr;

dvec3 anyPlace() {
  const auto coordinate = [] { return *rc::gen::inRange(-40000, 40001) * 1e-6; };
  return FalconArm::middle() + dvec3(coordinate(), coordinate(), coordinate());
}

RC_GTEST_PROP(FalconArm, PositionUndoesAngles, ()) {
  const dvec3 p = anyPlace();
  const auto angles = FalconArm::angles(p);
  RC_ASSERT(angles.has_value());
  const auto back = FalconArm::position(*angles, FalconArm::middle());
  RC_ASSERT(back.has_value());
  RC_ASSERT(glm::length(*back - p) < 1e-6);
}

RC_GTEST_PROP(FalconArm, JacobianAgreesWithDifferences, ()) {
  const dvec3 p = anyPlace();
  const auto J = FalconArm::jacobian(p);
  RC_ASSERT(J.has_value());
  const dvec3 angles = *FalconArm::angles(p);
  const double h = 1e-5;
  for (int i = 0; i < 3; ++i) {
    dvec3 more = angles, less = angles;
    more[i] += h;
    less[i] -= h;
    const dvec3 column = (*FalconArm::position(more, p) - *FalconArm::position(less, p)) / (2.0 * h);
    RC_ASSERT(glm::length(column - (*J)[i]) < 1e-5);
  }
}

RC_GTEST_PROP(FalconArm, TorquesDoTheForcesWork, ()) {
  const dvec3 p = anyPlace();
  const auto J = *FalconArm::jacobian(p);
  const dvec3 force(*rc::gen::inRange(-900, 901) * 0.01, *rc::gen::inRange(-900, 901) * 0.01,
                    *rc::gen::inRange(-900, 901) * 0.01);
  const dvec3 turn(*rc::gen::inRange(-100, 101) * 0.01, *rc::gen::inRange(-100, 101) * 0.01,
                   *rc::gen::inRange(-100, 101) * 0.01);
  RC_ASSERT(std::abs(glm::dot(FalconArm::torques(J, force), turn) - glm::dot(force, J * turn)) < 1e-9);
}

RC_GTEST_PROP(FalconMotors, SaturationKeepsTheDirection, ()) {
  const dvec3 p = anyPlace();
  const dvec3 force(*rc::gen::inRange(-100, 101), *rc::gen::inRange(-100, 101), *rc::gen::inRange(-100, 101));
  RC_PRE(glm::length(force) > 20.0);
  bool saturated = false;
  const auto motors = falconMotors(p, force, &saturated);
  for (const int motor : motors) RC_ASSERT(std::abs(motor) <= 4096);
  RC_PRE(saturated);
  // The force that these motors exert: F = J^-T tau.
  const dvec3 torque = -1e-4 * dvec3(motors[0], motors[1], motors[2]);
  const dvec3 exerted = glm::inverse(glm::transpose(*FalconArm::jacobian(p))) * torque;
  RC_ASSERT(glm::dot(glm::normalize(exerted), glm::normalize(force)) > 1.0 - 1e-5);
  RC_ASSERT(glm::length(exerted) < glm::length(force));
}

TEST(FalconArm, OutOfReachIsSaid) {
  EXPECT_FALSE(FalconArm::angles({0.0, 0.0, 0.5}));
  EXPECT_FALSE(FalconArm::jacobian({0.3, 0.0, 0.1}));
  EXPECT_FALSE(FalconArm::position({3.0, 0.0, -3.0}, FalconArm::middle()));
}

TEST(FalconArm, ThreeEqualAnglesAreStraightAhead) {
  // By symmetry of the three legs the grip is then on the axis.
  const auto p = FalconArm::position(dvec3(FalconArm::angleOf(0)), FalconArm::middle());
  ASSERT_TRUE(p);
  EXPECT_NEAR(std::hypot(p->x, p->y), 0.0, 1e-9);
  EXPECT_GT(p->z, 0.08);
  EXPECT_LT(p->z, 0.18);
}

TEST(FalconPackets, AreWrittenAsThePublishedLayoutSays) {
  const auto bytes = encodeFalcon({{0x1234, -1, 0}, kFalconBlue});
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "<EDCBPPPPAAAAEA>");
}

RC_GTEST_PROP(FalconPackets, RoundTripByteByByteBehindNoise, ()) {
  FalconPacket packet;
  for (auto& value : packet.values) value = *rc::gen::arbitrary<std::int16_t>();
  packet.bits = *rc::gen::inRange<std::uint8_t>(0, 0x7F);
  FalconReader reader;
  const auto noise = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::inRange<std::uint8_t>('A', 'Q'));
  reader.take(noise);
  std::optional<FalconPacket> got;
  for (const std::uint8_t byte : encodeFalcon(packet)) {
    if (const auto one = reader.take(std::span(&byte, 1))) got = one;
  }
  RC_ASSERT(got.has_value());
  RC_ASSERT(got->values == packet.values);
  RC_ASSERT(got->bits == packet.bits);
}

RC_GTEST_PROP(FalconPackets, AnyBytesDoNoHarm, ()) {
  FalconReader reader;
  reader.take(*rc::gen::arbitrary<std::vector<std::uint8_t>>());
  reader.clear();
  const auto bytes = encodeFalcon({{1, 2, 3}, 0});
  RC_ASSERT(reader.take(bytes).has_value());
}

TEST(FalconPackets, AShortPacketIsNotReadAsHomed) {
  FalconReader reader;
  const std::string cut = "<AAAAAAAAAAAA>";  // 14 bytes: what libnifalcon took for buttons and homed flags.
  EXPECT_FALSE(reader.take({reinterpret_cast<const std::uint8_t*>(cut.data()), cut.size()}));
  EXPECT_TRUE(reader.take(encodeFalcon({})));
  EXPECT_EQ(reader.garbled(), 1u);
}

class Falcon : public ::testing::Test {
 protected:
  Falcon()
      : driver([this] { return devices; },
               [this](const UsbDevice&, Problem& problem) -> std::unique_ptr<FtdiPort> {
                 problem = refuses;
                 if (problem.status != Status::kOk) return nullptr;
                 return std::make_unique<FakeFalconPort>(falcon);
               },
               "fake") {
    UsbDevice usb;
    usb.vendor = 0x0403;
    usb.product = 0xCB48;
    usb.serial = "FL0042";
    usb.place = "usb 1-4";
    devices = {usb};
  }
  std::string writeFirmware() {
    for (int i = 0; i < 8001; ++i) falcon.wanted_firmware.push_back(static_cast<std::uint8_t>(i * 7 + i / 256));
    return folder.write("firmware.bin", {falcon.wanted_firmware.begin(), falcon.wanted_firmware.end()}).string();
  }

  test::TemporaryFolder folder;
  FakeFalcon falcon;
  std::vector<UsbDevice> devices;
  Problem refuses;
  FalconDriver driver;
};

TEST_F(Falcon, WantsItsFirmwareFromTheUser) {
  Problem problem;
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kMissingFile);
  EXPECT_THAT(problem.fix, HasSubstr("[driver.falcon]"));
  driver.configure("firmware", "/nowhere/firmware.bin");
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_THAT(problem.found, HasSubstr("/nowhere/firmware.bin"));
}

TEST_F(Falcon, UploadsTheFirmwareThroughEchoErrors) {
  driver.configure("firmware", writeFirmware().c_str());
  falcon.echo_errors = 3;
  Problem problem;
  Device* const device = driver.open("FL0042", problem);
  ASSERT_NE(device, nullptr) << problem.found;
  EXPECT_EQ(falcon.uploads, 4);
  EXPECT_EQ(falcon.received, falcon.wanted_firmware);
  const std::vector<std::pair<int, int>> last(falcon.controls.end() - 4, falcon.controls.end());
  EXPECT_EQ(last, (std::vector<std::pair<int, int>>{{9, 1}, {3, 2}, {0, 1}, {0, 2}}));
  driver.close(device);
}

TEST_F(Falcon, GivesUpAfterTenAttempts) {
  driver.configure("firmware", writeFirmware().c_str());
  falcon.drops_echo = true;
  Problem problem;
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kGarbled);
  EXPECT_EQ(falcon.uploads, 10);
}

TEST_F(Falcon, NoForceBeforeHoming) {
  falcon.running = true;
  haptic::DriverSession session(driver, "", {.now = [] { return std::int64_t{1}; }});
  ASSERT_EQ(session.open().status, Status::kOk);
  Command push;
  push.motors = true;
  push.force[2] = 3.0;
  for (int i = 0; i < 5; ++i) session.turn(push);
  EXPECT_EQ(falcon.last_out.bits, kFalconRed | kFalconHoming);
  EXPECT_EQ(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
  falcon.homed = true;
  falcon.buttons = 4;
  falcon.p_F = FalconArm::middle() + dvec3(0.01, 0.02, -0.03);
  for (int i = 0; i < 3; ++i) session.turn(push);
  EXPECT_EQ(falcon.last_out.values, (std::array<std::int16_t, 3>{})) << "not in one step";
  session.turn({});
  for (int i = 0; i < 3; ++i) session.turn(push);
  EXPECT_EQ(falcon.last_out.bits, kFalconBlue);
  EXPECT_NE(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
  const State& state = session.turn(push).state;
  EXPECT_NEAR(state.position[0], 0.01, 1e-4);  // A count is up to 60 um.
  EXPECT_NEAR(state.position[1], 0.03, 1e-4);
  EXPECT_NEAR(state.position[2], 0.02, 1e-4);
  EXPECT_EQ(state.buttons, 1u);
}

TEST_F(Falcon, SaysOnceThatItWantsHomingAndThatItIsHomed) {
  falcon.running = true;
  std::vector<std::string> told;
  haptic::DriverSession session(driver, "", {.report = [&](const std::string& text) { told.push_back(text); }});
  ASSERT_EQ(session.open().status, Status::kOk);
  for (int i = 0; i < 20; ++i) session.turn({});
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0], HasSubstr("Pull the grip out"));
  falcon.homed = true;
  for (int i = 0; i < 20; ++i) session.turn({});
  ASSERT_EQ(told.size(), 2u);
  EXPECT_THAT(told[1], HasSubstr("is calibrated"));
}

TEST_F(Falcon, SomeGarbageAndShortPacketsAreBorne) {
  falcon.running = falcon.homed = true;
  haptic::DriverSession session(driver, "");
  ASSERT_EQ(session.open().status, Status::kOk);
  session.turn({});
  falcon.garbage = 4;
  falcon.short_packets = 4;
  for (int i = 0; i < 40; ++i) EXPECT_EQ(session.turn({}).status, Status::kOk);
  EXPECT_GT(session.turn({}).measurements, 10u);
}

/// Its answer does not come: the motors are told zero all the same, 20 ms later.
TEST_F(Falcon, SilentItIsToldZero) {
  falcon.running = falcon.homed = true;
  std::int64_t now = 1;
  haptic::DriverSession session(driver, "", {.now = [&] { return now += 1'000'000; }});
  ASSERT_EQ(session.open().status, Status::kOk);
  for (int i = 0; i < 4; ++i) session.turn({});
  Command push;
  push.motors = true;
  push.force[2] = 1.0;
  for (int i = 0; i < 4; ++i) session.turn(push);
  ASSERT_NE(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
  falcon.silent = true;
  for (int i = 0; i < 30; ++i) session.turn(push);
  EXPECT_EQ(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
}

TEST_F(Falcon, SilenceIsAskedAgainAndThenGivenUp) {
  falcon.running = falcon.homed = true;
  haptic::DriverSession session(driver, "");
  ASSERT_EQ(session.open().status, Status::kOk);
  session.turn({});
  falcon.silent = true;
  const int before = falcon.packets;
  int turns = 0;
  while (session.turn({}).status == Status::kOk && turns < 1000) ++turns;
  EXPECT_GE(falcon.packets - before, FalconDevice::kMostLost - 1);
  EXPECT_LT(turns, 250);
}

TEST_F(Falcon, ListsWhatIsSeenAndSaysWhatIsInTheWay) {
  devices[0].bus_node = "/dev/no_such_bus/001/002";
  Found found[2];
  Problem problem;
  ASSERT_EQ(driver.find(found, 2, problem), 1u);
  EXPECT_STREQ(found[0].id, "FL0042");
  EXPECT_EQ(found[0].problem.status, Status::kNotFound);
  refuse(refuses, Status::kInUse, "another program has it");
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kInUse);
  devices.clear();
  EXPECT_EQ(driver.open("", problem), nullptr);
  EXPECT_EQ(problem.status, Status::kNotFound);
}

TEST_F(Falcon, UnpluggedInContactAndPluggedInAgain) {
  falcon.running = falcon.homed = true;
  falcon.p_F = FalconArm::middle() + dvec3(0.0, 0.005, 0.0);
  haptic::DriverDeviceOptions options{.calls = haptic::DriverCalls::kInline};
  options.session.reopen_turns = 40;
  std::vector<std::string> told;
  options.session.report = [&](const std::string& text) { told.push_back(text); };
  haptic::DriverDevice device(driver, "", options);
  ASSERT_TRUE(device.open());
  haptic::ContactRig rig(device);
  rig.engage(0.0);
  rig.run(90, [&] { falcon.p_F.y -= 1e-4; });
  rig.run(100);
  EXPECT_GT(rig.force(), 0.5);
  EXPECT_LE(rig.max_step, 1.0 + 1e-9);

  falcon.gone = true;
  devices.clear();
  rig.run(1);
  EXPECT_EQ(rig.force(), 0.0);
  EXPECT_TRUE(rig.loop.current().device_fault);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0], HasSubstr("unplugged"));
  rig.run(100);

  falcon.gone = false;
  falcon.homed = false;  // It has lost its power: homing is needed anew.
  UsbDevice usb;
  usb.vendor = 0x0403;
  usb.product = 0xCB48;
  devices = {usb};
  rig.run(100);
  EXPECT_FALSE(rig.loop.current().device_fault);
  EXPECT_EQ(falcon.last_out.values, (std::array<std::int16_t, 3>{}));
  falcon.homed = true;
  falcon.p_F = FalconArm::middle() + dvec3(0.0, 0.005, 0.0);
  rig.run(20);
  rig.switchOnAgain(0.0);
  rig.run(90, [&] { falcon.p_F.y -= 1e-4; });
  rig.run(100);
  EXPECT_GT(rig.force(), 0.5);
}

/// Notes how much is written at once.
class MeasuredPort final : public FtdiPort {
 public:
  explicit MeasuredPort(FakeFalcon& falcon) : port_(falcon) {}
  bool control(std::uint8_t request, std::uint16_t value) override { return port_.control(request, value); }
  int read(std::span<std::uint8_t> to, int wait_ms) override { return port_.read(to, wait_ms); }
  bool write(std::span<const std::uint8_t> bytes) override {
    written.push_back(bytes.size());
    return port_.write(bytes);
  }
  std::vector<std::size_t> written;

 private:
  FakeFalconPort port_;
};

TEST(FalconFirmware, IsUploadedInBlocksWhoseEchoesAreCompared) {
  FakeFalcon falcon;
  for (int i = 0; i < 62 * 3 + 10; ++i) falcon.wanted_firmware.push_back(static_cast<std::uint8_t>(31 * i));
  falcon.echo_errors = 1;
  MeasuredPort port(falcon);
  EXPECT_FALSE(falconAnswers(port)) << "the boot loader is no firmware";
  EXPECT_EQ(uploadFalconFirmware(port, falcon.wanted_firmware).status, Status::kOk);
  EXPECT_EQ(falcon.uploads, 2) << "from the start after a wrong echo";
  EXPECT_EQ(falcon.received, falcon.wanted_firmware);
  EXPECT_TRUE(falconAnswers(port));
  EXPECT_EQ(std::count(port.written.begin(), port.written.end(), 62u), 1 + 3);
  EXPECT_EQ(std::count(port.written.begin(), port.written.end(), 10u), 1);
  EXPECT_EQ(falcon.baud, 2) << "3 MHz / 2: 1.5 Mbaud";
}

TEST(FalconFirmware, GivesUpAfterTenAttempts) {
  FakeFalcon falcon;
  falcon.wanted_firmware.assign(100, 7);
  falcon.drops_echo = true;
  FakeFalconPort port(falcon);
  const Problem problem = uploadFalconFirmware(port, falcon.wanted_firmware);
  EXPECT_EQ(problem.status, Status::kGarbled);
  EXPECT_THAT(problem.found, HasSubstr("ten attempts"));
  EXPECT_EQ(falcon.uploads, 10);
  EXPECT_FALSE(falcon.running);
}

TEST(FalconFirmware, ARunningOneIsKnownByItsAnswer) {
  FakeFalcon falcon;
  falcon.running = true;
  FakeFalconPort port(falcon);
  ASSERT_TRUE(setFalconRunning(port));
  // FTDI's requests: 1 ms of latency, the divisor of 1.5 Mbaud, both buffers emptied.
  EXPECT_EQ(falcon.controls, (std::vector<std::pair<int, int>>{{9, 1}, {3, 2}, {0, 1}, {0, 2}}));
  falcon.garbage = 2;
  EXPECT_TRUE(falconAnswers(port)) << "at the third question";
  EXPECT_EQ(falcon.last_out.values[0], 0) << "asked by a packet without force";
  falcon.silent = true;
  EXPECT_FALSE(falconAnswers(port));
  falcon.gone = true;
  EXPECT_FALSE(falconAnswers(port));
  EXPECT_FALSE(setFalconRunning(port));
}

}  // namespace
}  // namespace hapticell::driver
