// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/overlay_labels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/viewport/scene/pen_look.h"
#include "app/viewport/overlay/pen_tags.h"

namespace hapticell::app {
namespace {

SceneModel sceneWith(manipulation::SceneSnapshot snapshot) {
  SceneModel scene;
  workcell::Entity gripper;
  gripper.id = 1;
  gripper.name = "Gripper G2";
  workcell::Entity tower;
  tower.id = 2;
  tower.name = "Clamp tower B";
  scene.setEntities({gripper, tower});
  scene.setSnapshot(snapshot);
  return scene;
}

manipulation::PairState pair(double distance, bool contact) {
  manipulation::PairState result;
  result.moved = 1;
  result.other = 2;
  result.distance = distance;
  result.contact = contact;
  result.near_miss = true;
  result.p_WB = dvec3(distance, 0, 0);
  return result;
}

Text limitOf(const char* joint, double degrees) {
  return Text("%1 is %2 from its limit", joint, Text::Angle{degrees * std::numbers::pi / 180.0});
}

TEST(OverlayLabels, OneEachOfContactNearMissAndLimit) {
  manipulation::SceneSnapshot snapshot;
  for (int i = 0; i < 4; ++i) snapshot.pairs.push_back(pair(0.001 * i, i < 2));
  snapshot.limits = {{limitOf("A5", 1.2), 4}, {limitOf("A3", 0.1), 2}};
  const auto labels = overlayLabels(sceneWith(snapshot));
  ASSERT_EQ(labels.size(), 3u);
  EXPECT_EQ(labels[0].mark, Mark::kContact);
  EXPECT_EQ(labels[0].names, "Gripper G2 – Clamp tower B");
  EXPECT_EQ(labels[1].number, "2.0 mm");
  EXPECT_EQ(labels[2].names, "A5 is 1.2° from its limit");
}

TEST(OverlayLabels, TheNearestFreePairIsNamedUnlessSomethingTouches) {
  manipulation::SceneSnapshot snapshot;
  snapshot.pairs = {pair(0.0326, false)};
  snapshot.pairs[0].near_miss = false;
  const auto labels = overlayLabels(sceneWith(snapshot));
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].mark, Mark::kNone);
  EXPECT_EQ(labels[0].number, "32.6 mm");
  snapshot.pairs.push_back(pair(0.0, true));
  EXPECT_EQ(overlayLabels(sceneWith(snapshot)).size(), 1u);
  EXPECT_EQ(overlayLabels(sceneWith(snapshot))[0].mark, Mark::kContact);
}

TEST(PenLook, IsAFifthOfTheViewsHeightWithinBounds) {
  EXPECT_DOUBLE_EQ(penPixels({1600.0, 600.0}), 120.0);
  EXPECT_DOUBLE_EQ(penPixels({1600.0, 1200.0}), 150.0);
  EXPECT_DOUBLE_EQ(penPixels({400.0, 200.0}), 70.0);
}

/// A number at each pen's end while there are two; where they would cover each other the second gives way.
TEST(PenTags, StandAtTheEndsOfTwoPens) {
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.connected = true;
  snapshot.second.emplace();
  const auto tagsOf = [](const manipulation::SceneSnapshot& shown) {
    const SceneModel scene = sceneWith(shown);
    Overlay overlay;
    overlay.scene = &scene;
    overlay.size = {800.0, 600.0};
    overlay.camera.distance = 1.0;
    return penTags(overlay);
  };
  EXPECT_TRUE(tagsOf(snapshot).empty()) << "the second is not connected";
  snapshot.second->connected = true;
  const auto covering = tagsOf(snapshot);
  ASSERT_EQ(covering.size(), 2u);
  EXPECT_EQ(covering[0].number, 1);
  EXPECT_EQ(covering[1].number, 2);
  EXPECT_FALSE(covering[0].box.intersects(covering[1].box));
  snapshot.second->X_WStylus.p = {0.1, 0.0, 0.0};
  const auto apart = tagsOf(snapshot);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].box, covering[0].box);
  EXPECT_FALSE(apart[0].box.intersects(apart[1].box));
  snapshot.second->X_WStylus.p = {9.0, 0.0, 0.0};
  for (const PenTag& tag : tagsOf(snapshot)) EXPECT_TRUE(QRectF(0, 0, 800, 600).contains(tag.box)) << tag.number;
}

TEST(OverlayLabels, NoneWithoutASnapshot) {
  EXPECT_TRUE(overlayLabels(SceneModel()).empty());
}

TEST(ForceArrow, LengthAndOpacityAreAsTheVisualLanguageSays) {
  EXPECT_DOUBLE_EQ(forceArrowLength(1.0), 120.0);
  EXPECT_DOUBLE_EQ(forceArrowLength(6.4), 200.0);
  EXPECT_DOUBLE_EQ(forceArrowOpacity(0.05), 1.0);
  EXPECT_DOUBLE_EQ(forceArrowOpacity(0.0), 0.0);
}

TEST(ForceArrow, StartsAtTheContact) {
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.X_WStylus = Pose::translation({9, 9, 9});
  EXPECT_EQ(forceArrowStart_W(snapshot), dvec3(9, 9, 9));
  snapshot.pairs = {pair(0.004, false), pair(0.5, true)};
  EXPECT_EQ(forceArrowStart_W(snapshot), dvec3(0.5, 0, 0));
}

}  // namespace
}  // namespace hapticell::app
