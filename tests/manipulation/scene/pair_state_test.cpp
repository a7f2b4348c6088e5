// SPDX-License-Identifier: Apache-2.0
#include "manipulation/scene/pair_state.h"

#include <gtest/gtest.h>

#include "manipulation/engine/snapshot_maker.h"

namespace hapticell::manipulation {
namespace {

TEST(PairState, SaysWhatWasMeasured) {
  HeldPair pair;
  pair.owner = 3;
  pair.other = 4;
  pair.moved_part = "link_5";
  pair.near_miss = 0.02;
  collision::DistanceResult measured;
  measured.distance = 0.02;
  measured.p_WA = {1.0, 0.0, 0.0};
  measured.p_WB = {1.0, 0.0, 0.02};
  const PairState far = shownPair(pair, measured, false);
  EXPECT_EQ(far.moved, 3U);
  EXPECT_EQ(far.other, 4U);
  EXPECT_EQ(far.moved_part, "link_5");
  EXPECT_TRUE(far.other_part.empty()) << "a solid";
  EXPECT_EQ(far.p_WA, measured.p_WA);
  EXPECT_EQ(far.p_WB, measured.p_WB);
  EXPECT_EQ(far.near_miss_distance, 0.02);
  EXPECT_FALSE(far.near_miss) << "just as far as its near miss begins";
  EXPECT_FALSE(far.contact);
  measured.distance = 0.0199;
  EXPECT_TRUE(shownPair(pair, measured, false).near_miss);
  EXPECT_TRUE(shownPair(pair, measured, true).contact) << "at its safety boundary";
  measured.distance = 0.0;
  measured.colliding = true;
  EXPECT_TRUE(shownPair(pair, measured, false).contact) << "whatever the boundary";
}

}  // namespace
}  // namespace hapticell::manipulation
