// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene/strip_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace hapticell::app {
namespace {

manipulation::PairState pair(double distance, bool contact, bool near_miss) {
  manipulation::PairState result;
  result.distance = distance;
  result.contact = contact;
  result.near_miss = near_miss;
  return result;
}

TEST(StripText, NumbersHaveUnitsAndNoMinusZero) {
  EXPECT_EQ(millimetres(0.0064), "6.4 mm");
  EXPECT_EQ(millimetres(-0.00001), "0.0 mm");
  EXPECT_EQ(millimetres(12.345), "12.35 m");
  EXPECT_EQ(millimetres(std::numeric_limits<double>::infinity()), "none");
  EXPECT_EQ(newtons(-0.01), "0.0 N");
  EXPECT_EQ(newtons(6.37), "6.4 N");
}

TEST(StripText, ScaleReadsAsCellToHand) {
  EXPECT_EQ(scaleText(0.25), "1 : 4");
  EXPECT_EQ(scaleText(4.0), "4 : 1");
  EXPECT_EQ(scaleText(1.0), "1 : 1");
  EXPECT_EQ(scaleText(0.0), "none");
}

TEST(StripText, ContactAndFreeGapAreToldApart) {
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.forces_on = true;
  snapshot.stylus.force_n = 1.1;
  snapshot.stylus.device_edge_m = 0.031;
  snapshot.pairs = {pair(0.001, true, true), pair(0.0064, false, true)};
  const auto cells = stripCells(snapshot, {});
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_EQ(cells[0].value, "6.4 mm");
  EXPECT_EQ(cells[0].mark, Mark::kNearMiss);
  EXPECT_EQ(cells[1].value, "1.1 N");
  EXPECT_EQ(cells[1].mark, Mark::kContact);
  EXPECT_EQ(cells[5].value, "31 mm");
  EXPECT_EQ(cells[5].mark, Mark::kNone);
}

TEST(StripText, NothingNearAndForcesOffAreSaid) {
  manipulation::SceneSnapshot snapshot;
  snapshot.clutched = true;
  const auto cells = stripCells(snapshot, {});
  EXPECT_EQ(cells[0].value, "nothing held");
  EXPECT_EQ(cells[1].value, "off");
  EXPECT_EQ(cells[4].value, "Clutch");
  EXPECT_EQ(cells[5].mark, Mark::kLimit) << "the device's edge is reached";
}

TEST(StripText, TheClearanceOfWhatIsHeldSaysWhyThereIsNoDistance) {
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.held = 7;
  EXPECT_EQ(stripCells(snapshot, {})[0].value, "none nearby");
  snapshot.pairs = {pair(0.0, true, false)};
  EXPECT_EQ(stripCells(snapshot, {})[0].value, "contact");
  EXPECT_EQ(stripCells(snapshot, {})[0].mark, Mark::kContact);
}

}  // namespace
}  // namespace hapticell::app
