// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/finger_contact.h"

#include <gtest/gtest.h>

#include "mannequin/shape/hand_shape.h"

namespace hapticell::app {
namespace {

using mannequin::Side;

constexpr workcell::EntityId kWorker = 7, kTable = 3;

manipulation::PairState touch(workcell::EntityId moved, const std::string& moved_part, workcell::EntityId other,
                              const std::string& other_part, bool contact = true) {
  manipulation::PairState pair;
  pair.moved = moved;
  pair.moved_part = moved_part;
  pair.other = other;
  pair.other_part = other_part;
  pair.contact = contact;
  pair.near_miss = true;
  return pair;
}

TEST(FingerContact, EachPhalanxShakesItsOwnFinger) {
  for (int digit = 0; digit < 5; ++digit) {
    for (std::size_t phalanx = 0; phalanx < 3; ++phalanx) {
      manipulation::SceneSnapshot now;
      now.pairs = {touch(kWorker, mannequin::phalanxName(Side::kRight, static_cast<mannequin::Digit>(digit), phalanx),
                         kTable, "")};
      const FingerVibration right = fingerVibration(now, kWorker, Side::kRight, 8.0);
      for (int i = 0; i < 6; ++i) EXPECT_EQ(right[static_cast<std::size_t>(i)] > 0.0, i == digit) << digit << i;
      EXPECT_EQ(fingerVibration(now, kWorker, Side::kLeft, 8.0), FingerVibration{}) << "the other hand";
    }
  }
}

TEST(FingerContact, PressedHarderItShakesMoreAndNeverOverItsStrength) {
  manipulation::SceneSnapshot now;
  now.pairs = {touch(kTable, "", kWorker, "l_index3"), touch(kWorker, "l_wrist", kTable, "")};
  const double light = fingerVibration(now, kWorker, Side::kLeft, 8.0)[1];
  now.stylus.forces_on = true;
  now.stylus.force_n = 4.0;
  const double firm = fingerVibration(now, kWorker, Side::kLeft, 8.0)[1];
  now.stylus.force_n = 40.0;
  const FingerVibration hard = fingerVibration(now, kWorker, Side::kLeft, 8.0);
  EXPECT_GT(light, 0.0);
  EXPECT_GT(firm, light);
  EXPECT_DOUBLE_EQ(hard[1], 1.0);
  EXPECT_DOUBLE_EQ(hard[5], 1.0) << "the palm has its own";
  EXPECT_EQ(hard[0], 0.0);
}

TEST(FingerContact, NearMissesAndOthersContactsShakeNothing) {
  manipulation::SceneSnapshot now;
  now.pairs = {touch(kWorker, "r_index3", kTable, "", false), touch(kTable, "r_index3", 9, ""),
               touch(kWorker, "r_forearm", kTable, "")};
  EXPECT_EQ(fingerVibration(now, kWorker, Side::kRight, 8.0), FingerVibration{});
}

}  // namespace
}  // namespace hapticell::app
