// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/grasp_keeper.h"

#include <gtest/gtest.h>

namespace hapticell::manipulation {
namespace {

constexpr workcell::EntityId kGrasper = 7, kRack = 8, kCarried = 9;

PairState touch(const char* link, workcell::EntityId other, bool hand_moves = true) {
  PairState pair;
  pair.moved = hand_moves ? kGrasper : other;
  pair.other = hand_moves ? other : kGrasper;
  (hand_moves ? pair.moved_part : pair.other_part) = link;
  pair.contact = true;
  return pair;
}

TEST(GraspKeeper, TakesWhatThumbAndFingerTouchAndLetsItGoWhenTheyOpen) {
  const auto any = [](workcell::EntityId) { return true; };
  const auto none = [](workcell::EntityId) { return false; };
  const GraspKeeper::Bend bent{0.4, 0.8, 0.8, 0.8, 0.8}, flat{};
  std::vector<PairState> pairs{touch("r_index2", kCarried), touch("r_middle2", kCarried)};
  GraspKeeper keeper;
  const auto look = [&](const GraspKeeper::Bend& bend, const auto& may) {
    return keeper.look({pairs, kGrasper, mannequin::Side::kRight, bend}, may);
  };
  EXPECT_EQ(look(bent, any).taken, 0u) << "fingers alone";
  pairs.push_back(touch("l_thumb3", kCarried));
  EXPECT_EQ(look(bent, any).taken, 0u) << "the other hand's thumb";
  pairs.push_back(touch("r_thumb3", kRack));
  EXPECT_EQ(look(bent, any).taken, 0u) << "the thumb on something else";
  pairs.push_back(touch("r_thumb3", kCarried, false));
  EXPECT_EQ(look(bent, none).taken, 0u) << "it may not be carried off";
  EXPECT_EQ(look(flat, any).taken, 0u) << "a flat hand rests on it";
  EXPECT_EQ(look(bent, any).taken, kCarried);
  EXPECT_EQ(keeper.held(), kCarried);
  pairs.clear();  // What hangs on the hand is not told as touching any more.
  EXPECT_EQ(look(bent, any).let_go, 0u);
  EXPECT_EQ(look({0.4, 0.7, 0.7, 0.7, 0.7}, any).let_go, 0u) << "a little is a tremble";
  EXPECT_EQ(look({0.4, 0.4, 0.4, 0.4, 0.4}, any).let_go, kCarried);
  EXPECT_EQ(keeper.held(), 0u);
}

}  // namespace
}  // namespace hapticell::manipulation
