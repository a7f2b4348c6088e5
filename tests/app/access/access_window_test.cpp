// SPDX-License-Identifier: Apache-2.0
// Access for maintenance in the whole window under a virtual display: real clicks, through AccessPage.
#include <gtest/gtest.h>

#include "app/host/recording_hub.h"
#include "tests/app/pages/access_page.h"

namespace hapticell::app {
namespace {

constexpr int kNobody = 3;

TEST(AccessDock, StepsAreFoundDrawnKeptLaidAsideAndFelt) {
  AccessPage page;
  ASSERT_TRUE(page.openGearbox());
  page.trigger("actionAccess");
  EXPECT_FALSE(page.find<QAbstractButton>("buttonAccessAsk")->isEnabled()) << "no part is chosen";
  page.choosePart("gear 1");
  page.choosePersons(kNobody);
  const std::size_t before = page.RobotPage::steps();
  ASSERT_TRUE(page.ask());
  EXPECT_EQ(page.RobotPage::steps(), before) << "asking leaves the document alone";
  // The order that docs/user/access.md gives: four screws, four rings, cover, wheel and spacer, gear.
  ASSERT_EQ(page.steps().count(), 12) << page.words("labelAccessResult").toStdString();
  EXPECT_TRUE(page.stepLine(11).contains("gear 1")) << page.stepLine(11).toStdString();
  EXPECT_TRUE(page.words("labelAccessResult").contains("cover")) << page.words("labelAccessResult").toStdString();
  const workcell::Entity gear = *page.document().document().findByName("gear 1");
  page.chooseStep(11);
  ASSERT_TRUE(page.ghost().has_value());
  EXPECT_GT(glm::length(page.ghost()->p - gear.X_WE.p), 0.01) << "the slider is at the end of the way";
  page.find<QSlider>("sliderAccessWay")->setValue(0);
  page.settle();
  EXPECT_LT(glm::length(page.ghost()->p - gear.X_WE.p), 1e-9) << "and at its begin, the part where it stands";

  page.click("buttonAccessKeep");
  // It is measured first.
  ASSERT_TRUE(AccessPage::until([&] { return page.motions().motions().size() == 1; }, AccessPage::kAnswerPatience))
      << page.words("labelAccessResult").toStdString();
  EXPECT_TRUE(page.words("labelAccessResult").contains("Trajectory")) << page.words("labelAccessResult").toStdString();
  EXPECT_EQ(page.RobotPage::steps(), before + 1) << "one step of undo";
  EXPECT_EQ(page.motions().motions()[0].trajectory->entity, "gear 1");

  page.click("buttonAccessFeel");
  ASSERT_TRUE(page.window().recording().guide().has_value());
  EXPECT_EQ(page.window().recording().guide()->entity, "gear 1");
  EXPECT_LT(glm::length(page.window().recording().guide()->path.front() - gear.X_WE.p), 1e-9);
  page.click("buttonAccessFeel");
  EXPECT_FALSE(page.window().recording().guide().has_value());

  page.click("buttonAccessAside");
  EXPECT_EQ(page.RobotPage::steps(), before + 2);
  EXPECT_LT(glm::length(page.document().document().findByName("gear 1")->X_WE.p - gear.X_WE.p), 1e-12);
  EXPECT_FALSE(page.words("labelAccessResult").contains("changed")) << "parts that go first may be gone";
}

TEST(AccessDock, AShownWayIsCheckedAndReplacesTheStep) {
  AccessPage page;
  ASSERT_TRUE(page.openGearbox());
  page.choosePart("gear 1");
  page.choosePersons(kNobody);
  ASSERT_TRUE(page.ask());
  ASSERT_EQ(page.steps().count(), 12);
  page.chooseStep(11);
  page.click("buttonAccessByHand");
  EXPECT_TRUE(page.words("labelAccessResult").contains("Record gear 1")) << "nothing is recorded yet";
  const Pose rest = page.document().document().findByName("gear 1")->X_WE;
  const auto shown = [&](const dvec3& end_W) {
    trajectory::Trajectory motion;
    motion.entity = "gear 1";
    motion.moved = "self_origin";
    motion.addFrame({0.0, rest});
    motion.addFrame({2.0, {rest.p + end_W, rest.q}});
    page.motions().add("shown", {{page.motions().uniqueName("by hand"), motion}});
    page.click("buttonAccessByHand");
    EXPECT_TRUE(AccessPage::until(
        [&] { return page.find<QAbstractButton>("buttonAccessAsk")->text() == "Find the way out"; },
        AccessPage::kAnswerPatience));
  };
  shown({1.0, 0.0, 0.0});
  EXPECT_FALSE(page.stepLine(11).contains("by hand")) << "through the wall";
  EXPECT_TRUE(page.words("labelAccessResult").contains("it meets")) << page.words("labelAccessResult").toStdString();
  page.chooseStep(0);
  page.chooseStep(11);
  page.find<QSlider>("sliderAccessWay")->setValue(1000);
  const dvec3 way = page.ghost()->p - rest.p;
  shown(way);
  EXPECT_TRUE(page.stepLine(11).contains("shown by hand")) << page.words("labelAccessResult").toStdString();
}

TEST(AccessDock, WhatCannotBeTakenOutIsSaid) {
  AccessPage page;
  ASSERT_TRUE(page.openGearbox());
  page.choosePart("housing floor");
  ASSERT_TRUE(page.ask());
  EXPECT_FALSE(page.words("labelAccessResult").isEmpty());
  EXPECT_EQ(page.steps().count(), 0);
  EXPECT_FALSE(page.find<QAbstractButton>("buttonAccessReport")->isEnabled());
}

}  // namespace
}  // namespace hapticell::app
