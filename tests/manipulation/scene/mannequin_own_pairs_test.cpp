// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "manipulation/scene/mannequin_own_pairs.h"
#include "tests/manipulation/manipulators/worker.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::box;
using test::worker;

TEST(MannequinOwnPairs, HandsMeetTheBodyButNotTheirOwnArm) {
  EXPECT_TRUE(isOwnPairOfMannequin("l_hand", mannequin::segmentInfo(mannequin::Segment::kThorax).name));
  EXPECT_TRUE(isOwnPairOfMannequin(mannequin::segmentInfo(mannequin::Segment::kHead).name, "r_hand"));
  EXPECT_TRUE(isOwnPairOfMannequin("l_hand", "r_hand"));
  for (const auto segment :
       {mannequin::Segment::kPelvis, mannequin::Segment::kLeftThigh, mannequin::Segment::kRightFoot}) {
    EXPECT_TRUE(isOwnPairOfMannequin("l_hand", mannequin::segmentInfo(segment).name));
    EXPECT_TRUE(isOwnPairOfMannequin(mannequin::segmentInfo(segment).name, "l_index3"));
  }
  EXPECT_TRUE(isOwnPairOfMannequin("l_index3", "r_hand"));
  EXPECT_FALSE(isOwnPairOfMannequin("l_index3", "l_hand"));
  EXPECT_FALSE(isOwnPairOfMannequin("l_index3", "r_index3"));
  const char* upper = mannequin::segmentInfo(mannequin::Segment::kLeftUpperArm).name;
  EXPECT_FALSE(isOwnPairOfMannequin("l_hand", upper));
  EXPECT_FALSE(isOwnPairOfMannequin(upper, mannequin::segmentInfo(mannequin::Segment::kThorax).name));
}

}  // namespace
}  // namespace hapticell::manipulation
