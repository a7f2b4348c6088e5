// SPDX-License-Identifier: Apache-2.0
// The mannequin's dock in the whole window under a virtual display: real clicks, through MannequinPage.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/host/hold_choice.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/mannequin_panel.h"
#include "app/mannequin/marker_panel.h"
#include "app/panels/joint_row.h"
#include "app/style/icon.h"
#include "geometry/shapes.h"
#include "tests/app/mannequin_page.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

using mannequin::Dof;
using Kind = manipulation::MovedBy::Kind;

workcell::Entity table() {
  workcell::Entity entity;
  entity.name = "Bench";
  entity.mesh = std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.8, 0.6, 0.05}));
  entity.X_WE.p = {0.0, 0.0, 0.9};
  return entity;
}

TEST(MannequinDock, AddsOneFromTheMenuWithUndo) {
  MannequinPage page;
  EXPECT_FALSE(page.isShown("dockMannequin"));
  ASSERT_TRUE(page.addMannequin());
  EXPECT_TRUE(page.isShown("dockMannequin"));
  EXPECT_EQ(page.words("labelMannequin"), "Operator");
  ASSERT_TRUE(page.addMannequin());
  EXPECT_EQ(page.words("labelMannequin"), "Operator 2");
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(MannequinDock, WhatIsHeldAndLockedGoesToTheStylus) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  HoldChoice& choice = page.window().holdChoice();
  const Kind kinds[]{Kind::kWhole, Kind::kLeftHand, Kind::kRightHand, Kind::kBothHands, Kind::kHead};
  for (int i = 0; i < 5; ++i) {
    page.click(QStringLiteral("hold%1").arg(i));
    EXPECT_EQ(choice.kind(), kinds[i]);
  }
  page.click("lock0");
  page.click("lock3");
  page.click("lock2");
  EXPECT_TRUE(choice.locks().trunk);
  EXPECT_TRUE(choice.locks().seat);
  EXPECT_FALSE(choice.locks().feet);
  EXPECT_TRUE(choice.movedBy().may_step);
  page.segment("segmentsTwoHands", 0);
  EXPECT_TRUE(choice.movedBy().hands_apart);
}

TEST(MannequinDock, SizeIsChosenTypedAndUndone) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const double before = page.stature();
  ASSERT_TRUE(page.segmentForStep("segmentsBoundary", 0));
  EXPECT_NEAR(page.stature(), 1.525, 0.001);
  EXPECT_EQ(page.selected()->figure->sex, mannequin::Sex::kFemale);
  ASSERT_TRUE(page.typeForStep("fieldStature", "1680"));
  EXPECT_NEAR(page.stature(), 1.680, 1e-6);
  ASSERT_TRUE(page.typeForStep("fieldMass", "80"));
  EXPECT_NEAR(page.selected()->figure->totalMass(), 80.0, 1e-6);
  const auto& figure = *page.selected()->figure;
  EXPECT_NEAR(page.posture().X_WR.p.z, mannequin::onFloor(figure, page.posture()).X_WR.p.z, 1e-6) << "on the floor";
  for (int i = 0; i < 3; ++i) page.trigger("actionUndo");
  EXPECT_NEAR(page.stature(), before, 1e-9);
}

TEST(MannequinDock, PosturesOfTheLibraryMirrorAndSwap) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  ASSERT_TRUE(page.choose("buttonPostures", "posture_reaching"));
  const mannequin::Posture reaching = page.posture();
  ASSERT_TRUE(page.clickForStep("buttonSwapHands"));
  EXPECT_NEAR(page.posture()[Dof::kLeftElbowFlexion], reaching[Dof::kRightElbowFlexion], 1e-9);
  ASSERT_TRUE(page.clickForStep("buttonMirror"));
  EXPECT_NEAR(page.posture()[Dof::kRightElbowFlexion], reaching[Dof::kRightElbowFlexion], 1e-9);
}

TEST(MannequinDock, PostureFilesComeBackAndBadOnesChangeNothing) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  ASSERT_TRUE(page.choose("buttonPostures", "posture_kneeling"));
  const mannequin::Posture kneeling = page.posture();
  const auto folder = std::filesystem::temp_directory_path() / "hapticell_posture_test";
  std::filesystem::create_directories(folder);
  const QString file = QString::fromStdString((folder / "kneeling.json").string());
  auto* panel = page.window().findChild<MannequinPanel*>();
  ASSERT_NE(panel, nullptr);
  ASSERT_TRUE(panel->savePostureFile(file));
  ASSERT_TRUE(panel->savePostureFile(QString::fromStdString((folder / "kneeling.x3d").string())));
  page.trigger("actionUndo");
  ASSERT_TRUE(panel->openPostureFile(file));
  EXPECT_NEAR(page.posture()[Dof::kLeftKneeFlexion], kneeling[Dof::kLeftKneeFlexion], 1e-6);
  const std::size_t steps = page.steps();
  EXPECT_FALSE(panel->openPostureFile(QString::fromStdString((folder / "nothing.json").string())));
  EXPECT_FALSE(panel->savePostureFile("/nowhere/x.json"));
  EXPECT_EQ(page.steps(), steps);
  std::filesystem::remove_all(folder);
}

TEST(MannequinDock, GraspsCurlTheChosenHand) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  page.click("hold1");
  const double right = page.posture()[Dof::kRightFingersCurl];
  ASSERT_TRUE(page.segmentForStep("segmentsGrasp", 0));
  EXPECT_GT(page.posture()[Dof::kLeftFingersCurl], 0.5);
  EXPECT_NEAR(page.posture()[Dof::kRightFingersCurl], right, 1e-12);
}

TEST(MannequinDock, TakesAPartIntoTheHandAndLetsItGo) {
  MannequinPage page;
  const auto bench = page.add(table());
  ASSERT_TRUE(page.addMannequin());
  const auto hand = [&] { return page.document().document().find(bench)->attachment; };
  page.click("buttonCarry");
  EXPECT_EQ(hand().to, "Operator");
  EXPECT_EQ(hand().link, "r_hand");
  page.click("buttonCarry");
  EXPECT_TRUE(hand().to.empty());
}

TEST(MannequinDock, AJointIsDraggedWithinItsLimitsAsOneStep) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  auto* row = page.find<JointRow>("joint_r_elbow_flexion");
  ASSERT_NE(row, nullptr);
  const std::size_t before = page.steps();
  QTest::mousePress(row, Qt::LeftButton, Qt::NoModifier, QPoint(row->pixelOf(30), row->height() / 2));
  QTest::mouseMove(row, QPoint(row->pixelOf(90), row->height() / 2));
  QTest::mouseRelease(row, Qt::LeftButton, Qt::NoModifier, QPoint(row->pixelOf(90), row->height() / 2));
  page.settle();
  EXPECT_EQ(page.steps(), before + 1);
  EXPECT_NEAR(page.posture()[Dof::kRightElbowFlexion], M_PI / 2.0, 0.06);
}

/// The right hand forward, seen from the right: its arrow upwards, and how far the hand is.
class HandArrow {
 public:
  explicit HandArrow(MannequinPage& page) : page_(page) {
    EXPECT_TRUE(page.addMannequin());
    EXPECT_TRUE(page.choose("buttonPostures", "posture_both_hands_forward"));
    page.click("hold2");
    page.window().viewport().setStandardView(StandardView::kRight);
    page.window().viewport().fitAll(false);
    page.settle();
  }
  dvec3 grip() const {
    const workcell::Entity& figure = *page_.selected();
    return movedFrame_W(figure, {figure.X_WE, figure.joints}, Kind::kRightHand).p;
  }
  /// Draws it up by the mouse and waits until that is one step.
  bool drag(double up, int moves) {
    const ViewportWidget& viewport = page_.window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    const dvec3 arrow = grip() + dvec3(0.0, 0.0, 60.0 * viewport.camera().metresPerPixel(grip(), size));
    const std::size_t before = page_.steps();
    page_.dragScene(arrow, arrow + dvec3(0.0, 0.0, up), moves);
    return page_.until([&] { return page_.steps() == before + 1 && !page_.document().document().inCompound(); },
                       MannequinPage::kPatience);
  }

 private:
  MannequinPage& page_;
};

TEST(MannequinGizmo, DrawsTheHandByTheMouseAndSaysWhatIsMissing) {
  MannequinPage page;
  HandArrow hand(page);
  const dvec3 start = hand.grip();
  ASSERT_TRUE(hand.drag(0.12, 8));
  EXPECT_LT(glm::length(hand.grip() - start - dvec3(0.0, 0.0, 0.12)), 0.005);
  ASSERT_TRUE(hand.drag(1.2, 8));
  EXPECT_TRUE(page.words("labelReach").contains(" short of the target")) << page.words("labelReach").toStdString();
  page.trigger("actionUndo");
  page.trigger("actionUndo");
  EXPECT_LT(glm::length(hand.grip() - start), 1e-9);
}

TEST(MannequinGizmo, EndsWhereTheMouseLetGoHoweverLittleOfTheWayWasHeard) {
  MannequinPage page;
  HandArrow hand(page);
  const dvec3 start = hand.grip();
  for (const int moves : {0, 3}) {
    ASSERT_TRUE(hand.drag(0.12, moves));
    EXPECT_LT(glm::length(hand.grip() - start - dvec3(0.0, 0.0, 0.12)), 0.005) << moves;
    page.trigger("actionUndo");
  }
}

TEST(MannequinSkin, AFigureAtRestIsDrawnInOneSkin) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const auto drawn = [&] { return page.window().viewport().scene().items({}).size(); };
  ASSERT_TRUE(page.until([&] { return drawn() == 6; }, 3 * MannequinPage::kPatience))
      << "trousers, shirt, skin, shoes, hair and hands: " << drawn();
  ASSERT_TRUE(page.choose("buttonPostures", "posture_both_hands_forward"));
  ASSERT_TRUE(page.until([&] { return drawn() == 6; }, 3 * MannequinPage::kPatience))
      << "and again in the next posture";
}

TEST(Markers, AreShownMomentByMoment) {
  HAPTICELL_SHARED_DATA_OR_SKIP(file, "mocap/cmu_02_05.c3d");
  MannequinPage page;
  page.bringDock("actionMarkers");
  auto* panel = page.window().findChild<MarkerPanel*>();
  ASSERT_NE(panel, nullptr);
  panel->open(QString::fromStdString(file.string()));
  const auto drawn = [&] { return page.window().viewport().scene().items({}).size(); };
  ASSERT_TRUE(page.until([&] { return drawn() > 0; }, MannequinPage::kPatience));
  EXPECT_TRUE(page.words("labelMarkers").contains("41 markers, 15.4")) << page.words("labelMarkers").toStdString();
  const auto where = page.window().viewport().scene().items({}).front().X_WM.p;
  panel->setFrame(900);
  EXPECT_GT(glm::length(page.window().viewport().scene().items({}).front().X_WM.p - where), 0.01);
  page.window().findChild<QDockWidget*>("dockMarkers")->hide();
  EXPECT_EQ(drawn(), 0u);
}

TEST(MannequinTree, HasItsOwnIcon) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  EXPECT_EQ(page.selected()->kind, workcell::EntityKind::kMannequin);
  EXPECT_FALSE(icon("mannequin").pixmap(16, 16).toImage().isNull());
}

}  // namespace
}  // namespace hapticell::app
