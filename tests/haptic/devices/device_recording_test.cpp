// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/device_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "haptic/devices/device_choice.h"
#include "haptic/devices/simulated_device.h"
#include "tests/haptic/devices/contact_rig.h"
#include "tests/support/same_bits.h"
#include "tests/support/test_data.h"

namespace hapticell::haptic {
namespace {

using ::testing::HasSubstr;

/// The same client with any device: forces on, a floor, and what was commanded tick by tick.
std::vector<dvec3> play(Device& device, bool moves_hand) {
  ContactRig rig(device);
  std::vector<dvec3> forces;
  rig.link.sendControl({.forces_enabled = true});
  rig.link.sendSet(floorSet(1));
  for (int i = 0; i < 2500; ++i) {
    const double height = i < 1500 ? 0.005 : std::max(-0.008, 0.005 - 1e-4 * (i - 1500));
    if (moves_hand) rig.link.sendHandTarget({true, Pose::translation(dvec3(0.0, 0.0, height)), i > 2000 ? 1u : 0u});
    rig.run(1);
    forces.push_back(rig.loop.current().force_D);
  }
  rig.loop.shutDown();
  return forces;
}

TEST(DeviceRecording, AReplayGivesBitEqualForces) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "session.hdev";
  std::vector<dvec3> first;
  {
    auto simulated = std::make_unique<SimulatedDevice>();
    simulated->place(Pose::translation(dvec3(0.0, 0.0, 0.005)));
    RecordingDevice device(std::move(simulated), file);
    ASSERT_TRUE(device.open());
    first = play(device, true);
  }
  const double most = glm::length(*std::max_element(
      first.begin(), first.end(), [](const dvec3& a, const dvec3& b) { return glm::length(a) < glm::length(b); }));
  EXPECT_GT(most, 1.0);  // It did touch.
  auto device = makeDevice("replay:" + file.string(), {});
  ASSERT_TRUE(device) << device.error().message();
  ASSERT_TRUE((*device)->open());
  EXPECT_FALSE((*device)->capabilities().simulated);
  const std::vector<dvec3> second = play(**device, false);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_TRUE(test::sameBits(first[i], second[i])) << "tick " << i;
  }
  const auto recording = readDeviceRecording(file);
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->ticks.back().buttons, 1u);
  EXPECT_EQ(recording->capabilities.name, SimulatedDevice().capabilities().name);
}

/// Measures every third tick, and exerts forces from the tenth on.
class Seldom final : public Device {
 public:
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  Expected<void> open() override { return {}; }
  DeviceStatus read(DeviceReading& reading) noexcept override {
    reading.fresh = ticks_ % 3 == 0;
    reading.takes_force = ticks_++ >= 10;
    return DeviceStatus::kOk;
  }
  DeviceStatus write(const dvec3&, const dvec3&) noexcept override { return DeviceStatus::kOk; }
  void close() noexcept override {}

 private:
  DeviceCapabilities capabilities_;
  int ticks_ = 0;
};

/// A force loop that reads a replay must know it too, else it would decide otherwise.
TEST(DeviceRecording, WhatWasNotFreshAndTookNoForceComesBackSo) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "seldom.hdev";
  DeviceReading reading;
  {
    RecordingDevice device(std::make_unique<Seldom>(), file);
    ASSERT_TRUE(device.open());
    for (int i = 0; i < 20; ++i) {
      device.read(reading);
      device.write(dvec3(0.0), dvec3(0.0));
    }
  }
  const auto recording = readDeviceRecording(file);
  ASSERT_TRUE(recording) << recording.error().message();
  ReplayDevice replay(*recording);
  ASSERT_TRUE(replay.open());
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(replay.read(reading), DeviceStatus::kOk);
    EXPECT_EQ(reading.fresh, i % 3 == 0) << i;
    EXPECT_EQ(reading.takes_force, i >= 10) << i;
    replay.write(dvec3(0.0), dvec3(0.0));
  }
}

TEST(DeviceRecording, ACutFileKeepsItsWholeTicks) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "cut.hdev";
  {
    RecordingDevice device(std::make_unique<SimulatedDevice>(), file);
    ASSERT_TRUE(device.open());
    DeviceReading reading;
    for (int i = 0; i < 10; ++i) {
      device.read(reading);
      device.write(dvec3(0.1 * i, 0.0, 0.0), dvec3(0.0));
    }
  }
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 50);
  const auto recording = readDeviceRecording(file);
  ASSERT_TRUE(recording) << recording.error().message();
  ASSERT_EQ(recording->ticks.size(), 9u);
  EXPECT_EQ(recording->ticks[8].force_D.x, 0.1 * 8);
}

TEST(DeviceRecording, HasItsNameWhenItIsWholeAndTellsWhereItCannotBe) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("below/session.hdev", "old");
  RecordingDevice device(std::make_unique<SimulatedDevice>(), file);
  ASSERT_TRUE(device.open());
  DeviceReading reading;
  device.read(reading);
  device.write(dvec3(0.0), dvec3(0.0));
  EXPECT_EQ(std::filesystem::file_size(file), 3u) << "the old one stands until then";
  ASSERT_TRUE(device.finish());
  EXPECT_TRUE(readDeviceRecording(file));
  device.close();
  ASSERT_TRUE(device.open());
  device.write(dvec3(0.0), dvec3(0.0));
  std::filesystem::remove_all(file.parent_path());
  device.close();
  const auto finished = device.finish();
  ASSERT_FALSE(finished) << "who asks after the end is told too";
  EXPECT_THAT(finished.error().message(), HasSubstr("session.hdev"));
}

TEST(DeviceRecording, RefusesWhatIsNone) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(readDeviceRecording(folder.path() / "missing.hdev"));
  EXPECT_FALSE(readDeviceRecording(folder.write("text.hdev", "HCELDEV2 and more of it")));
  std::string bytes = "HCELDEV1";
  bytes += std::string("\x02\0\0\0{}", 6);
  const auto lacking = readDeviceRecording(folder.write("header.hdev", bytes));
  ASSERT_FALSE(lacking);
  EXPECT_THAT(lacking.error().message(), HasSubstr("header"));
  bytes = "HCELDEV1";
  bytes += std::string("\xFF\xFF\xFF\x7F", 4);
  EXPECT_FALSE(readDeviceRecording(folder.write("long.hdev", bytes)));
}

TEST(DeviceRecording, AtItsEndItStaysWithoutButtons) {
  DeviceRecording recording;
  recording.ticks.resize(2);
  recording.ticks[1].buttons = 1;
  recording.ticks[1].X_DS = Pose::translation(dvec3(0.01, 0.0, 0.0));
  ReplayDevice device(recording);
  DeviceReading reading;
  EXPECT_EQ(device.read(reading), DeviceStatus::kNotOpen);
  ASSERT_TRUE(device.open());
  for (int i = 0; i < 2; ++i) {
    device.read(reading);
    device.write(dvec3(0.0), dvec3(0.0));
  }
  EXPECT_EQ(reading.buttons, 1u);
  device.read(reading);
  EXPECT_EQ(reading.buttons, 0u);
  EXPECT_EQ(reading.X_DS.p.x, 0.01);
  EXPECT_FALSE(ReplayDevice(DeviceRecording{}).open());
}

}  // namespace
}  // namespace hapticell::haptic
