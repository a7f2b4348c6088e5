// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/label_layout.h"

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
  const KeptFree blocked{{{first[0].box.min - 2.0, first[0].box.max + 2.0}}, {}};
  const auto going = layout.place({wish}, blocked, kPictureSize, 0.01);
  EXPECT_TRUE(layout.moving());
  EXPECT_LT(glm::length(going[0].box.min - first[0].box.min), 100.0) << "it does not jump";
  layout.place({wish}, blocked, kPictureSize, 0.12);
  const auto there = layout.place({wish}, blocked, kPictureSize, 0.12);
  EXPECT_FALSE(layout.moving());
  EXPECT_FALSE(there[0].box.overlaps(blocked.boxes[0]));
}

/// Labels with and without leaders about one place, which wander while they are drawn.
RC_GTEST_PROP(LabelLayout, HoweverManyNoTwoOverlapOnTheirWayNeither, ()) {
  LabelLayout layout;
  const auto number = [](int least, int most) { return static_cast<double>(*rc::gen::inRange(least, most)); };
  const KeptFree kept{{{{0, 640}, {1200, 700}}, {{1060, 0}, {1200, 130}}}, {{{600, 350}, {700, 250}, 14.0}}};
  std::vector<LabelWish> wishes;
  const int count = *rc::gen::inRange(2, 24);
  for (int i = 0; i < count; ++i)
    wishes.push_back({static_cast<std::uint64_t>(i),
                      {number(300, 900), number(100, 600)},
                      {number(40, 260), i % 3 == 0 ? 20.0 : 44.0},
                      i % 3 == 0 ? 10.0 : 0.0});
  for (int frame = 0; frame < 6; ++frame) {
    const auto placed = layout.place(wishes, kept, kPictureSize, 0.03);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      for (const PixelBox& box : kept.boxes) RC_ASSERT(!placed[i].box.overlaps(box) || layout.moving());
      for (std::size_t j = 0; j < i; ++j) RC_ASSERT(!placed[i].box.overlaps(placed[j].box));
    }
    for (LabelWish& wish : wishes) wish.anchor += glm::dvec2(number(-40, 40), number(-40, 40));
  }
}

TEST(LabelLayout, ALabelLeavesAnArrowFreeWhereThereIsAnotherPlace) {
  LabelLayout layout;
  const LabelWish wish{1, {400, 300}, {150, 44}};
  const PixelBox usual = layout.place({wish}, {}, kPictureSize, 0.0)[0].box;
  const PixelLine arrow{{usual.min.x - 30, 300}, {usual.max.x + 30, 310}};
  EXPECT_TRUE(arrow.reaches(usual));
  const auto moved = layout.place({wish}, {{}, {arrow}}, kPictureSize, 0.0, false);
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_FALSE(arrow.reaches(moved[0].box));
  EXPECT_FALSE((PixelLine{{0, 0}, {100, 0}, 5.0}).reaches({{20, 6}, {40, 20}}));
  EXPECT_TRUE((PixelLine{{0, 0}, {100, 0}, 5.0}).reaches({{20, 4}, {40, 20}}));
}

TEST(LabelLayout, AShortTextStaysBesideItsPointOrIsNotShown) {
  LabelLayout layout;
  const LabelWish wish{1, {400, 300}, {60, 24}, 18.0};
  const PixelBox right = layout.place({wish}, {}, kPictureSize, 0.0)[0].box;
  EXPECT_NEAR(right.min.x, 418.0, 1e-9);
  const auto other = layout.place({wish}, {{right}, {}}, kPictureSize, 0.0);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_LT(glm::length(0.5 * (other[0].box.min + other[0].box.max) - wish.anchor), 90.0);
  EXPECT_TRUE(layout.place({wish}, {{{{300, 200}, {500, 400}}}, {}}, kPictureSize, 0.0).empty());
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
