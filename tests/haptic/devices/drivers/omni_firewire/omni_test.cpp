// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <numbers>

#include "haptic/devices/driver_device.h"
#include "haptic/devices/driver_session.h"
#include "haptic/devices/driver_support.h"
#include "haptic/devices/drivers/omni_firewire/omni_driver.h"
#include "tests/haptic/devices/contact_rig.h"

namespace hapticell::driver {
namespace {

using ::testing::HasSubstr;

/// A packet as the device sends it.
std::vector<std::uint8_t> packet(const std::array<int, 3>& encoders, std::uint8_t status) {
  std::vector<std::uint8_t> bytes(64, 0);
  const auto put = [&](std::size_t at, int value) {
    bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
    bytes[at + 1] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    put(4 + 2 * i, encoders[i]);
    put(10 + 2 * i, 2048);
    put(22 + 2 * i, 2048);
  }
  bytes[19] = status;
  put(32, 7);
  return bytes;
}

constexpr std::uint8_t kFree = 0x07, kDockedBits = 0x03;  // Buttons are 0 while pressed; bit 2 is 1 out of the inkwell.

TEST(OmniPackets, ReadTheirFields) {
  const auto reading = readOmniPacket(packet({100, -200, 300}, 0x06));
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->encoders, (std::array<int, 3>{100, -200, 300}));
  EXPECT_TRUE(reading->button1);
  EXPECT_FALSE(reading->button2);
  EXPECT_FALSE(reading->docked);
  EXPECT_EQ(reading->gimbal_ratios[1], 0.5);
  EXPECT_EQ(reading->packet, 7u);
  std::vector<std::uint8_t> cut = packet({0, 0, 0}, kFree);
  cut.resize(30);
  EXPECT_FALSE(readOmniPacket(cut));
  EXPECT_FALSE(readOmniPacket(std::vector<std::uint8_t>(64, 0)));
}

RC_GTEST_PROP(OmniPackets, AnyBytesDoNoHarm, (const std::vector<std::uint8_t>& bytes)) {
  readOmniPacket(bytes);
}

TEST(OmniPackets, AreWrittenAsThePublishedLayoutSays) {
  const auto off = makeOmniPacket({1.0, 1.0, 1.0}, false, false);
  EXPECT_EQ(off[0] | off[1] << 8, 0x7FF);  // Without motors every command is zero.
  EXPECT_EQ(off[6] | off[7] << 8, 0x53C0);
  const auto on = makeOmniPacket({1.0, -1.0, std::nan("")}, true, true);
  EXPECT_EQ(on[0] | on[1] << 8, 4095);
  EXPECT_EQ(on[2] | on[3] << 8, 0);
  EXPECT_EQ(on[4] | on[5] << 8, 0x7FF);
  EXPECT_EQ(on[6] | on[7] << 8, 0x53CB);
  for (std::size_t i = 8; i < 16; ++i) EXPECT_EQ(on[i], 0);
}

TEST(OmniArm, StandsInItsInkwellAtHome) {
  OmniArm arm;
  arm.home({123, -456, 789});
  const dvec3 q = arm.joints({123, -456, 789});
  EXPECT_NEAR(q.x, 0.0, 1e-12);
  EXPECT_NEAR(q.y, 0.23, 1e-12);
  EXPECT_NEAR(q.z - q.y, -0.60, 1e-12);  // The published q3 counts from the upper arm.
  // Low and near the base, where the inkwell is.
  OmniReading reading;
  reading.encoders = {123, -456, 789};
  reading.gimbal_ratios = {0.5, 0.5, 0.5};
  const Pose X_DS = arm.X_DS(reading);
  EXPECT_NEAR(X_DS.p.x, 0.0, 1e-9);
  EXPECT_GT(X_DS.p.y, 0.0);
  EXPECT_TRUE(X_DS.isValid());
}

std::array<int, 3> anyCounts() {
  return {*rc::gen::inRange(-1500, 1501), *rc::gen::inRange(-1500, 1501), *rc::gen::inRange(-1500, 1501)};
}

/// Two bars one after another, each turned by rotations: not the formula of the code.
RC_GTEST_PROP(OmniArm, TipIsWhereTheBarsOfItsLinkageEnd, ()) {
  OmniArm arm;
  arm.home({0, 0, 0});
  const dvec3 q = arm.joints(anyCounts());
  const dquat waist = quaternionFromRotationVector({0.0, 0.0, q.x});
  const dvec3 upper = quaternionFromRotationVector({0.0, -q.y, 0.0}) * dvec3(0.135, 0.0, 0.0);
  const dvec3 fore = quaternionFromRotationVector({0.0, -q.z, 0.0}) * dvec3(0.0, 0.0, -0.135);
  const dvec3 tip_A = waist * (upper + fore);
  const dvec3 tip_D = arm.arm().shoulder() + dvec3(tip_A.y, -tip_A.x, tip_A.z);
  RC_ASSERT(glm::length(tip_D - arm.arm().tip(q)) < 1e-12);
}

/// From the encoders' counts to the tip that is told, the signs and the coupling of the elbow included.
RC_GTEST_PROP(OmniArm, JacobianAgreesWithDifferencesOfTheEncoders, ()) {
  OmniArm arm;
  arm.home({12, -34, 56});
  OmniReading reading;
  reading.encoders = anyCounts();
  const dmat3 J = arm.arm().jacobian(arm.joints(reading.encoders));
  const double count = 2.0 * std::numbers::pi / 15000.0, sense[3]{1.0, -1.0, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    OmniReading more = reading, less = reading;
    ++more.encoders[i];
    --less.encoders[i];
    const dvec3 column = sense[i] * (arm.X_DS(more).p - arm.X_DS(less).p) / (2.0 * count);
    RC_ASSERT(glm::length(column - J[static_cast<int>(i)]) < 1e-7);
  }
}

RC_GTEST_PROP(OmniCommands, SaturatedTheForceKeepsItsDirection, ()) {
  OmniArm arm;
  arm.home({0, 0, 0});
  const dvec3 q = arm.joints(anyCounts());
  const dmat3 J = arm.arm().jacobian(q);
  RC_PRE(std::abs(glm::determinant(J)) > 1e-5);
  const dvec3 force(*rc::gen::inRange(-50, 51), *rc::gen::inRange(-50, 51), *rc::gen::inRange(-50, 51));
  RC_PRE(glm::length(force) > 20.0);
  const double unit = 0.1;  // N m of a full command.
  const dvec3 commands = omniCommands(arm.torques(q, force), unit);
  for (int i = 0; i < 3; ++i) RC_ASSERT(std::abs(commands[i]) <= 1.0 + 1e-12);
  // The force that these torques exert: F = J^-T tau.
  const dvec3 exerted = glm::inverse(glm::transpose(J)) * (unit * commands);
  RC_ASSERT(glm::dot(glm::normalize(exerted), glm::normalize(force)) > 1.0 - 1e-9);
  RC_ASSERT(glm::length(exerted) < glm::length(force));
}

RC_GTEST_PROP(OmniArm, TorquesDoTheForcesWork, ()) {
  OmniArm arm;
  arm.home({0, 0, 0});
  const std::array<int, 3> at{*rc::gen::inRange(-1500, 1501), *rc::gen::inRange(-1500, 1501),
                              *rc::gen::inRange(-1500, 1501)};
  const dvec3 force(*rc::gen::inRange(-30, 31) * 0.1, *rc::gen::inRange(-30, 31) * 0.1,
                    *rc::gen::inRange(-30, 31) * 0.1);
  const dvec3 q = arm.joints(at);
  const dvec3 torques = arm.torques(q, force);
  // The tip's motion by differences, a joint at a time.
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    dvec3 more = q, less = q;
    more[i] += h;
    less[i] -= h;
    const dvec3 column = (arm.arm().tip(more) - arm.arm().tip(less)) / (2.0 * h);
    RC_ASSERT(std::abs(torques[i] - glm::dot(column, force)) < 1e-7);
  }
}

TEST(OmniCommands, SaturationKeepsTheDirection) {
  const dvec3 commands = omniCommands({0.4, -0.2, 0.1}, 0.1);
  EXPECT_NEAR(commands.x, 1.0, 1e-12);
  EXPECT_NEAR(commands.y, -0.5, 1e-12);
  EXPECT_NEAR(commands.z, 0.25, 1e-12);
  EXPECT_EQ(omniCommands({1.0, 1.0, 1.0}, 0.0), dvec3(0.0));  // Not measured: none.
}

/// A bus in the hands of a test.
struct ScriptedBus {
  std::vector<FireWireNode> nodes{{0, 0, 0x000B990001234567ULL, "/dev/null"}};
  std::uint32_t identity = 0x000B9900;
  std::deque<std::vector<std::uint8_t>> packets;
  bool gone = false, no_streams = false;
  Problem refuses;
  std::vector<std::uint8_t> sent;
  std::vector<std::uint64_t> written;
};

class ScriptedPort final : public FireWirePort {
 public:
  explicit ScriptedPort(ScriptedBus& bus) : bus_(bus) {}
  std::optional<std::uint32_t> readQuadlet(std::uint64_t address) override {
    return address == 0x1006000C ? bus_.identity : 0x80000001u;
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t>) override {
    bus_.written.push_back(address);
    return true;
  }
  bool startStreams(std::uint8_t& out, std::uint8_t& in) override {
    out = 0, in = 1;
    return !bus_.no_streams;
  }
  void send(std::span<const std::uint8_t> bytes) override { bus_.sent.assign(bytes.begin(), bytes.end()); }
  std::optional<std::vector<std::uint8_t>> receive(int) override {
    if (bus_.gone) return std::nullopt;
    if (bus_.packets.empty()) return std::vector<std::uint8_t>();
    const auto bytes = bus_.packets.front();
    if (bus_.packets.size() > 1) bus_.packets.pop_front();
    return bytes;
  }

 private:
  ScriptedBus& bus_;
};

class ScriptedFireWire final : public FireWireBus {
 public:
  explicit ScriptedFireWire(ScriptedBus& bus) : bus_(bus) {}
  std::vector<FireWireNode> nodes(Problem&) override { return bus_.nodes; }
  std::unique_ptr<FireWirePort> open(const FireWireNode&, Problem& problem) override {
    problem = bus_.refuses;
    if (problem.status != Status::kOk) return nullptr;
    return std::make_unique<ScriptedPort>(bus_);
  }

 private:
  ScriptedBus& bus_;
};

class Omni : public ::testing::Test {
 protected:
  Omni()
      : driver(std::make_unique<ScriptedFireWire>(bus)),
        session(driver, "", {.reopen_turns = 4, .now = [] { return std::int64_t{1}; }}) {
    push.motors = true;
    push.force[2] = 1.0;
  }
  int command(std::size_t axis) const { return bus.sent[2 * axis] | bus.sent[2 * axis + 1] << 8; }
  bool motors() const { return (bus.sent[6] & 8) != 0; }

  ScriptedBus bus;
  OmniDriver driver;
  haptic::DriverSession session;
  Command push;
};

TEST_F(Omni, IsListedAndStarted) {
  Found found[2];
  Problem problem;
  bus.nodes.push_back({0, 1, 0x0050C50012345678ULL, "/dev/fw2"});  // A hard disk.
  ASSERT_EQ(driver.find(found, 2, problem), 1u);
  EXPECT_STREQ(found[0].id, "000b990001234567");
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_EQ(bus.written, (std::vector<std::uint64_t>{0x1000, 0x1001, 0x20010, 0x1087}));
  EXPECT_TRUE(session.capabilities().experimental);
  EXPECT_EQ(session.capabilities().driven_axes, 0u);
}

TEST_F(Omni, ItsPresenceTellsThatItCameAndWent) {
  const std::uint64_t there = driver.presence();
  EXPECT_EQ(driver.presence(), there);
  bus.nodes.push_back({0, 1, 0x0050C50012345678ULL, "/dev/fw2"});
  EXPECT_EQ(driver.presence(), there) << "a hard disk is none of its devices";
  bus.nodes.clear();
  EXPECT_NE(driver.presence(), there);
  EXPECT_TRUE(bus.written.empty()) << "it was only looked at";
}

TEST_F(Omni, NoForceUntilItIsMeasured) {
  bus.packets = {packet({0, 0, 0}, kDockedBits)};
  ASSERT_EQ(session.open().status, Status::kOk);
  for (int i = 0; i < 10; ++i) session.turn(push);
  EXPECT_FALSE(motors());
  EXPECT_EQ(command(2), 0x7FF);
}

TEST_F(Omni, MeasuredItPushesAfterItsInkwellWithAThirdOfItsRange) {
  driver.configure("newtons_per_unit", "3.0");
  bus.packets = {packet({0, 0, 0}, kFree)};
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_NEAR(session.capabilities().peak_force, 0.9, 1e-9);
  for (int i = 0; i < 10; ++i) session.turn(push);
  EXPECT_FALSE(motors()) << "it was never in its inkwell";
  bus.packets = {packet({0, 0, 0}, kDockedBits), packet({50, 0, 200}, kFree)};
  session.turn({});  // Whoever pushes knows that it may.
  std::vector<bool> armed;
  for (int i = 0; i < 5; ++i) {
    session.turn(push);
    armed.push_back(motors());
  }
  EXPECT_EQ(armed, (std::vector<bool>{true, false, true, true, true}));  // The maker's way of arming.
  push.force[2] = 100.0;
  session.turn(push);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(command(axis) - 0x7FF), 2048 * 0.3 + 1);
  session.turn({});
  EXPECT_FALSE(motors());
}

TEST_F(Omni, UnpluggedGarbledSilentAndBack) {
  bus.packets = {packet({0, 0, 0}, kDockedBits)};
  ASSERT_EQ(session.open().status, Status::kOk);
  EXPECT_EQ(session.turn({}).status, Status::kOk);
  bus.gone = true;
  EXPECT_EQ(session.turn({}).status, Status::kVanished);
  bus.gone = false;
  for (int i = 0; i < 5; ++i) session.turn({});
  EXPECT_EQ(session.turn({}).status, Status::kOk);
  bus.packets = {std::vector<std::uint8_t>(5, 1)};
  int turns = 0;
  while (session.turn({}).status == Status::kOk && turns < 100) ++turns;
  EXPECT_LT(turns, 100);
  bus.packets.clear();
  haptic::DriverSession silent(driver, "");
  ASSERT_EQ(silent.open().status, Status::kOk);
  for (int i = 0; i < OmniDevice::kPatience - 1; ++i) EXPECT_EQ(silent.turn({}).status, Status::kOk);
  EXPECT_EQ(silent.turn({}).status, Status::kVanished);
}

/// A whole force loop on it: contact, the cable is pulled out, nothing is left; plugged in again nothing comes back by
/// itself.
TEST_F(Omni, UnpluggedInContactAndPluggedInAgain) {
  driver.configure("newtons_per_unit", "3.0");
  bus.packets = {packet({0, 0, 0}, kDockedBits), packet({50, 0, 200}, kFree)};
  haptic::DriverDeviceOptions options{.calls = haptic::DriverCalls::kInline};
  options.session.reopen_turns = 50;
  haptic::DriverDevice device(driver, "", options);
  ASSERT_TRUE(device.open());
  haptic::ContactRig rig(device);
  rig.run(10);
  const dvec3 p_DS = rig.loop.current().X_DS.p;
  rig.link.sendControl({.forces_enabled = true});
  rig.link.sendSet(haptic::floorSet(1, p_DS.z - 0.002, p_DS));
  rig.run(1500);
  rig.link.sendSet(haptic::floorSet(2, p_DS.z + 0.002, p_DS));  // The floor rises under the stylus.
  rig.run(1500);
  EXPECT_GT(rig.force(), 0.3);
  EXPECT_TRUE(motors());
  EXPECT_NE(command(1), 0x7FF);

  bus.gone = true;
  refuse(bus.refuses, Status::kNotFound, "it is not there");
  rig.run(1);
  EXPECT_EQ(rig.force(), 0.0);
  EXPECT_FALSE(motors());
  EXPECT_TRUE(rig.loop.current().device_fault);
  rig.run(200);
  bus.gone = false;
  bus.refuses = {};
  bus.packets = {packet({0, 0, 0}, kDockedBits), packet({50, 0, 200}, kFree)};
  rig.run(200);
  EXPECT_FALSE(rig.loop.current().device_fault);
  EXPECT_EQ(rig.force(), 0.0) << "a force came back by itself";
  EXPECT_FALSE(motors());
}

TEST_F(Omni, WhatCannotBeOpened) {
  bus.identity = 0x12345678;
  EXPECT_EQ(session.open().status, Status::kGarbled);
  bus.identity = 0x000B9900;
  bus.no_streams = true;
  EXPECT_EQ(session.open().status, Status::kFault);
  refuse(bus.refuses, Status::kNoPermission, "/dev/fw1 may not be opened");
  EXPECT_EQ(session.open().status, Status::kNoPermission);
  bus.nodes.clear();
  bus.refuses = {};
  EXPECT_THAT(session.open().found, HasSubstr("no Phantom Omni"));
}

}  // namespace
}  // namespace hapticell::driver
