// SPDX-License-Identifier: Apache-2.0
// Guides and the dialog of a solid in the window.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <numbers>

#include "app/guides/detents_text.h"
#include "app/host/hold_choice.h"
#include "app/kit/switch_list.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

using workcell::GuideKind;

/// A door beside a post; the post is round.
struct GuidesPage : CellPage {
  GuidesPage() {
    door = addSolid("door", geometry::makeBox({0.4, 0.03, 0.3}), Pose::translation({0.25, 0, 0.15}));
    post = addSolid("post", geometry::makeCylinder(0.03, 0.4, 48), Pose::translation({0, 0, 0.2}));
    lookAt({0.15, 0, 0.15}, 0.3);
    showDock("dockGuides");
  }
  void pickPost() {
    const dvec3 to_eye = -window().viewport().camera().forward_W();
    const dvec3 out = glm::normalize(dvec3(to_eye.x, to_eye.y, 0.0));
    clickPoint(dvec3(0, 0, 0.25) + 0.03 * out);
  }
  const workcell::Guide& guide() { return state().guides.back(); }
  workcell::EntityId door = 0, post = 0;
};

TEST(GuidesPanel, TheCarDoorAHingeOnARoundPostWithStopsAndDetent) {
  GuidesPage page;
  page.select(page.door);
  page.press("kindHinge");
  page.press("buttonNewGuide");
  ASSERT_TRUE(page.window().viewport().isPicking());
  page.pickPost();
  ASSERT_EQ(page.state().guides.size(), 1u);
  EXPECT_EQ(page.guide().kind, GuideKind::kHinge);
  EXPECT_EQ(page.guide().entity, "door");
  EXPECT_NEAR(std::abs(page.guide().X_WG.rotate({0, 0, 1}).z), 1.0, 1e-9) << "the post's axis";
  EXPECT_NEAR(std::hypot(page.guide().X_WG.p.x, page.guide().X_WG.p.y), 0.0, 1e-7);

  page.press("checkLower");
  ASSERT_TRUE(page.guide().lower.has_value());
  EXPECT_EQ(*page.guide().lower, 0.0);
  page.press("checkUpper");
  page.type("fieldUpperDegrees", "72");
  EXPECT_NEAR(*page.guide().upper, 72.0 * std::numbers::pi / 180.0, 1e-9);
  auto* detents = page.find<QLineEdit>("fieldDetents");
  detents->setFocus();
  QTest::keyClicks(detents, "0 68");
  QTest::keyClick(detents, Qt::Key_Return);
  ASSERT_EQ(page.guide().detents.size(), 2u);
  EXPECT_NEAR(page.guide().detents[1], 68.0 * std::numbers::pi / 180.0, 1e-9);
  detents->clearFocus();
  EXPECT_EQ(detents->text(), "0.0 68.0 °");
  const std::vector<double> uneven{0.0, 0.35}, typed{0.5, 1.25};
  EXPECT_EQ(detentsText(uneven, true), "0.0 20.1 °");
  EXPECT_EQ(readDetents("0.0 20.1 °", true, uneven), uneven) << "what is shown rounded is no edit";
  EXPECT_EQ(readDetents("0,5 1.25 rad", true, uneven), typed);
  EXPECT_EQ(readDetents("500mm; 1250mm", false, {}), typed);
  page.type("fieldFriction", "0.8");
  EXPECT_NEAR(page.guide().friction, 0.8, 1e-12);
  while (page.enabled("actionUndo") && !page.state().guides.empty()) page.trigger("actionUndo");
  EXPECT_TRUE(page.state().guides.empty()) << "every edit is a step";
  EXPECT_EQ(page.state().entities.size(), 2u);
}

TEST(GuidesPanel, WhatCannotBeThatKindIsRefusedWithASentenceAndAskedAgain) {
  GuidesPage page;
  page.select(page.door);
  page.press("kindCircle");
  page.press("buttonNewGuide");
  page.clickPoint({0.27, -0.015, 0.17});
  EXPECT_TRUE(page.state().guides.empty());
  EXPECT_TRUE(page.window().viewport().isPicking());
  EXPECT_TRUE(page.window().messages().messages().back().title.contains("Circle"));
  page.pickPost();
  ASSERT_EQ(page.state().guides.size(), 1u);
  EXPECT_NEAR(page.guide().radius, 0.03, 1e-6);
}

TEST(GuidesPanel, EveryKindIsMadeOnPickedGeometry) {
  GuidesPage page;
  for (const std::string name :
       {"Point", "Line", "Plane", "Circle", "Hinge", "Slider", "Screw", "Tube", "Surface", "Lock"}) {
    page.select(page.door);
    page.press(("kind" + name).c_str());
    page.press("buttonNewGuide");
    if (name == "Tube")
      page.clickPoint({0.25, -0.015, 0.3});  // The door's upper edge.
    else if (name == "Plane" || name == "Surface" || name == "Point" || name == "Lock")
      page.clickPoint({0.27, -0.015, 0.17});
    else
      page.pickPost();
    ASSERT_EQ(page.state().guides.size(), 1u) << name;
    EXPECT_EQ(page.guide().name, name);
    EXPECT_EQ(page.guide().entity, "door");
    if (name == "Tube") {
      EXPECT_EQ(page.guide().path.size(), 2u);
    }
    if (name == "Surface") {
      EXPECT_EQ(page.guide().surface, "door");
    }
    if (name == "Plane") {
      EXPECT_NEAR(std::abs(page.guide().X_WG.rotate({0, 0, 1}).y), 1.0, 1e-9);
    }
    page.press("buttonRemoveGuide");
    ASSERT_TRUE(page.state().guides.empty());
  }
}

TEST(GuidesPanel, SwitchedOffChosenAndRemovedInTheList) {
  GuidesPage page;
  for (const char* name : {"first", "second"}) {
    workcell::Guide guide;
    guide.name = name;
    guide.entity = "door";
    ASSERT_TRUE(page.window().documentModel().execute(workcell::AddGuide{guide}));
  }
  auto* list = page.find<SwitchList>("listGuides");
  page.click(list, QPoint(24, 12));
  EXPECT_FALSE(page.state().guides[0].enabled);
  EXPECT_EQ(page.find<QLineEdit>("fieldGeometry")->text(), "Axis at 0.0, 0.0, 0.0");
  page.press("buttonRemoveGuide");
  ASSERT_EQ(page.state().guides.size(), 1u);
  EXPECT_EQ(page.state().guides[0].name, "second");
}

TEST(SolidPanel, TurnsAboutTheCentreAndFeelsAsChosen) {
  GuidesPage page;
  page.showDock("dockSolid");
  page.select(page.door);
  EXPECT_EQ(page.find<QLabel>("labelSolid")->text(), "door");
  page.chooseSegment("segmentsTurns", 1);
  EXPECT_TRUE(page.window().holdChoice().is<by::Center>());
  page.chooseSegment("segmentsSolidForce", 2);
  EXPECT_EQ(page.document().find(page.door)->contact.force_class, workcell::ForceClass::kDynamics);
  page.type("fieldSolidMass", "2.35");
  EXPECT_NEAR(page.document().find(page.door)->contact.mass, 2.35, 1e-12);
  page.chooseSegment("segmentsSolidOnContact", 0);
  EXPECT_EQ(page.document().find(page.door)->contact.on_contact, workcell::OnContact::kStop);
  page.press("switchChecked");
  EXPECT_FALSE(page.document().find(page.door)->checked);
  page.trigger("actionUndo");
  EXPECT_TRUE(page.document().find(page.door)->checked);
}

TEST(SolidPanel, IsPlacedByTypedNumbersAndGetsAFrameOnPickedGeometry) {
  GuidesPage page;
  page.showDock("dockSolid");
  page.select(page.door);
  page.type("fieldSolidZ", "200");
  EXPECT_NEAR(page.document().find(page.door)->X_WE.p.z, 0.2, 1e-12);
  EXPECT_NEAR(page.document().find(page.door)->X_WE.p.x, 0.25, 1e-12);
  page.window().viewport().finishedPicture();
  page.press("buttonNewFrame");
  page.clickPoint({0.27, -0.015, 0.22});
  const workcell::Entity* door = page.document().find(page.door);
  ASSERT_EQ(door->frames.size(), 1u);
  EXPECT_NEAR((door->X_WE * door->frames[0].X_EF).p.y, -0.015, 1e-6) << "on the face";
  EXPECT_TRUE(page.window().holdChoice().is<by::Frame>());
  EXPECT_EQ(page.window().holdChoice().frame(), "frame 1");
  page.select(page.post);
  page.select(0);
  EXPECT_FALSE(page.find<QLabel>("labelSolid")->isVisible()) << "nothing is selected";
}

}  // namespace
}  // namespace hapticell::app
