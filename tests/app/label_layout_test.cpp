// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/label_layout.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace hapticell::app {
namespace {

constexpr ViewSize kPictureSize{1200.0, 700.0};

std::vector<LabelWish> threeAt(const glm::dvec2& place) {
  return {
      {1, place, {150, 44}}, {2, place + glm::dvec2(30, 10), {180, 44}}, {3, place - glm::dvec2(20, 40), {120, 44}}};
}

RC_GTEST_PROP(LabelLayout, LabelsCoverNeitherEachOtherNorTheirPoints, ()) {
  LabelLayout layout;
  const glm::dvec2 place(*rc::gen::inRange(350, 850), *rc::gen::inRange(200, 500));
  const std::vector<LabelWish> wishes = threeAt(place);
  const auto placed = layout.place(wishes, {}, kPictureSize, 1.0, false);
  RC_ASSERT(placed.size() == 3u);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (const LabelWish& wish : wishes) RC_ASSERT(!placed[i].box.contains(wish.anchor));
    for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!placed[i].box.overlaps(placed[j].box));
    RC_ASSERT(placed[i].box.min.x >= 0.0 && placed[i].box.max.x <= kPictureSize.width);
  }
}

TEST(LabelLayout, ALabelStaysOnItsSideWhileItsPointMovesALittle) {
  LabelLayout layout;
  const auto first = layout.place({{1, {590, 300}, {150, 44}}}, {}, kPictureSize, 0.0);
  const auto second = layout.place({{1, {615, 305}, {150, 44}}}, {}, kPictureSize, 0.016);
  EXPECT_EQ(first[0].right_of_point, second[0].right_of_point);
  EXPECT_NEAR(second[0].box.min.x - first[0].box.min.x, 25.0, 1e-9) << "it moves with its point";
  EXPECT_FALSE(layout.moving());
}

TEST(LabelLayout, ANewPlaceIsReachedSmoothlyAndInTime) {
  LabelLayout layout;
  const LabelWish wish{1, {400, 300}, {150, 44}};
  const auto first = layout.place({wish}, {}, kPictureSize, 0.0);
  const std::vector<PixelBox> blocked{{first[0].box.min - 2.0, first[0].box.max + 2.0}};
  const auto going = layout.place({wish}, blocked, kPictureSize, 0.01);
  EXPECT_TRUE(layout.moving());
  EXPECT_LT(glm::length(going[0].box.min - first[0].box.min), 100.0) << "it does not jump";
  layout.place({wish}, blocked, kPictureSize, 0.12);
  const auto there = layout.place({wish}, blocked, kPictureSize, 0.12);
  EXPECT_FALSE(layout.moving());
  EXPECT_FALSE(there[0].box.overlaps(blocked[0]));
}

TEST(LabelLayout, LeaderEndsAtThePoint) {
  const PlacedLabel label{1, {{500, 100}, {600, 144}}, {420, 200}, true};
  const auto leader = leaderOf(label);
  ASSERT_GE(leader.size(), 2u);
  EXPECT_EQ(leader.front(), glm::dvec2(500, 122));
  EXPECT_EQ(leader.back(), label.anchor);
}

}  // namespace
}  // namespace hapticell::app
