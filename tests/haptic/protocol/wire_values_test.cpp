// SPDX-License-Identifier: Apache-2.0
#include "haptic/protocol/wire_values.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "haptic/protocol/codec.h"
#include "haptic/protocol/device_condition.h"
#include "tests/haptic/protocol/any_message.h"

namespace hapticell::haptic {
namespace {

bool isSame(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool isSame(const dvec3& a, const dvec3& b) {
  return isSame(a.x, b.x) && isSame(a.y, b.y) && isSame(a.z, b.z);
}

RC_GTEST_PROP(WireValues, ComeBackToTheLastBit, ()) {
  const dvec3 v = any::vector();
  RC_ASSERT(isSame(fromWire(toWire(v)), v));
  const Pose X = any::pose(), again = fromWire(toWire(X));
  RC_ASSERT(isSame(again.p, X.p) && isSame(again.q.w, X.q.w) && isSame(again.q.x, X.q.x));
  RC_ASSERT(isSame(again.q.y, X.q.y) && isSame(again.q.z, X.q.z));
  const Vector6 six = any::numbers<6>(bound::kSlope);
  RC_ASSERT(fromWire(toWire(six)) == six);
}

TEST(WireValues, NegativeZeroAndSubnormalNumbersStayWhatTheyAre) {
  const dvec3 v(-0.0, std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max());
  EXPECT_TRUE(isSame(fromWire(toWire(v)), v));
}

TEST(WireValues, EachPartHasItsOwnPlace) {
  const Pose X{{1.0, 2.0, 3.0}, dquat(0.1, 0.2, 0.3, 0.4)};
  const wire::Pose wired = toWire(X);
  EXPECT_EQ(wired.p().z(), 3.0);
  EXPECT_EQ(wired.q().w(), 0.1);
  EXPECT_EQ(wired.q().z(), 0.4);
  const wire::Vector6 six = toWire(Vector6{1, 2, 3, 4, 5, 6});
  EXPECT_EQ(six.linear().y(), 2.0);
  EXPECT_EQ(six.angular().x(), 4.0);
  EXPECT_EQ(toWire(ClientKind::kController), wire::ClientKind_Controller);
  EXPECT_EQ(toWire(ClientKind::kWatcher), wire::ClientKind_Watcher);
}

TEST(WireValues, EachMessageHasATableOfItsOwn) {
  static_assert(std::is_same_v<wireType<HapticState>, wire::State>);
  static_assert(std::is_same_v<wireType<DeviceCondition>, wire::DeviceCondition>);
  static_assert(!std::is_same_v<wireType<Hello>, wireType<Welcome>>);
  static_assert(!std::is_same_v<wireType<HapticControl>, wireType<HandTarget>>);
}

DeviceCondition overTheWire(const DeviceCondition& condition) {
  Encoder encoder;
  Message message;
  EXPECT_TRUE(decode(encoder.encode(condition).subspan(kFrameHeaderBytes), message));
  return std::get<DeviceCondition>(message);
}

TEST(DeviceCondition, WhatNobodySaysIsAReadyDevice) {
  const DeviceCondition ready;
  EXPECT_TRUE(ready.answers && ready.calibrated && !ready.docked);
  EXPECT_EQ(overTheWire(ready), ready);
}

TEST(DeviceCondition, EachPartIsKeptAndCounts) {
  const DeviceCondition whole{.answers = false,
                              .calibrated = false,
                              .docked = true,
                              .calibration = {"Put the stylus into the inkwell.", "Press both buttons."},
                              .sentence = "The device was unplugged: plug it in again."};
  EXPECT_EQ(overTheWire(whole), whole);
  for (int part = 0; part < 5; ++part) {
    DeviceCondition other = whole;
    if (part == 0) other.answers = true;
    if (part == 1) other.calibrated = true;
    if (part == 2) other.docked = false;
    if (part == 3) other.calibration.pop_back();
    if (part == 4) other.sentence.pop_back();
    EXPECT_NE(other, whole) << part;
    EXPECT_EQ(overTheWire(other), other) << part;
  }
}

TEST(DeviceCondition, TooMuchIsCutAndNotRefused) {
  DeviceCondition much;
  much.sentence = std::string(3 * kMaxTextBytes, 's');
  for (std::size_t i = 0; i < 2 * kMaxCalibrationSteps; ++i) much.calibration.push_back("step " + std::to_string(i));
  const DeviceCondition cut = overTheWire(much);
  EXPECT_EQ(cut.calibration.size(), kMaxCalibrationSteps);
  EXPECT_EQ(cut.calibration.front(), "step 0");
  EXPECT_LE(cut.sentence.size(), kMaxTextBytes);
  EXPECT_GE(cut.sentence.size(), kMaxTextBytes - 4);
}

}  // namespace
}  // namespace hapticell::haptic
