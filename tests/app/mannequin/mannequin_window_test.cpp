// SPDX-License-Identifier: Apache-2.0
// The mannequin's dock in the whole window under a virtual display: real clicks, through MannequinPage.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QWheelEvent>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "app/controls/joint_row.h"
#include "app/host/hold_choice.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/mannequin/figure_drag.h"
#include "app/mannequin/mannequin_panel.h"
#include "app/mannequin/marker_panel.h"
#include "app/style/icon.h"
#include "geometry/shapes/shapes.h"
#include "mannequin/posture/forward_kinematics.h"
#include "tests/app/pages/mannequin_page.h"
#include "tests/support/test_data.h"
#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {
namespace {

using manipulation::MovedBy;
using mannequin::Dof;
using mannequin::Side;

workcell::Entity table() {
  workcell::Entity entity;
  entity.name = "Bench";
  entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.8, 0.6, 0.05}))};
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
  EXPECT_TRUE(page.window().findChild<QAbstractButton*>("hold2")->isChecked())
      << "the right hand, where its arrows are";
  const MovedBy ways[]{by::Whole{}, by::Hand{Side::kLeft}, by::Hand{Side::kRight}, by::BothHands{}, by::Head{}};
  for (int i = 0; i < 5; ++i) {
    page.click(QStringLiteral("hold%1").arg(i));
    EXPECT_EQ(choice.movedBy(), ways[i]);
  }
  page.click("lock0");
  page.click("lock3");
  page.click("lock2");
  EXPECT_TRUE(choice.hands().locks.trunk);
  EXPECT_TRUE(choice.hands().locks.seat);
  EXPECT_TRUE(choice.hands().may_step);
  page.segment("segmentsTwoHands", 0);
  EXPECT_TRUE(choice.hands().apart);
  EXPECT_EQ(choice.movedBy(), MovedBy(by::Head{choice.hands().locks})) << "the way that was chosen last";
}

TEST(MannequinDock, SizeIsChosenTypedAndUndone) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const double before = page.stature();
  ASSERT_TRUE(page.segmentForStep("segmentsBoundary", 0));
  EXPECT_NEAR(page.stature(), 1.525, 0.001);
  EXPECT_EQ(page.selected()->figure()->sex, mannequin::Sex::kFemale);
  ASSERT_TRUE(page.typeForStep("fieldStature", "1680"));
  EXPECT_NEAR(page.stature(), 1.680, 1e-6);
  ASSERT_TRUE(page.typeForStep("fieldMass", "80"));
  EXPECT_NEAR(page.selected()->figure()->totalMass(), 80.0, 1e-6);
  EXPECT_EQ(page.find<QLabel>("labelBody")->text(), "Woman, 1680 mm, 80 kg");
  const auto& figure = *page.selected()->figure();
  EXPECT_NEAR(page.posture().X_WR.p.z, mannequin::onFloor(figure, page.posture()).X_WR.p.z, 1e-6) << "on the floor";
  for (int i = 0; i < 3; ++i) page.trigger("actionUndo");
  EXPECT_NEAR(page.stature(), before, 1e-9);
}

TEST(MannequinDock, TheWheelScrollsThePanelAndSetsNothing) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const auto turn = [&](QWidget* widget) {
    const QPointF middle = widget->rect().center();
    QWheelEvent event(middle, widget->mapToGlobal(middle), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
    MannequinPage::settle();
  };
  auto* percentile = page.find<QSlider>("sliderPercentile");
  auto* measure = page.find<QComboBox>("comboMeasure");
  const int before = percentile->value(), chosen = measure->currentIndex();
  turn(percentile);
  turn(measure);
  EXPECT_EQ(percentile->value(), before);
  EXPECT_EQ(measure->currentIndex(), chosen);
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

TEST(MannequinDock, NothingOfItIsCutOffBesideAScrollBar) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const auto* panel = page.window().findChild<MannequinPanel*>();
  ASSERT_NE(panel, nullptr);
  constexpr int kDock = 344, kScrollBar = 12;
  std::string widest;
  for (const QWidget* child : panel->findChildren<QWidget*>())
    if (child->minimumSizeHint().width() > 250)
      widest += child->objectName().toStdString() + ' ' + std::to_string(child->minimumSizeHint().width()) + ", ";
  EXPECT_LE(panel->minimumSizeHint().width(), kDock - kScrollBar) << widest;
}

TEST(MannequinDock, TheUsersOwnPosturesStandInTheMenu) {
  QStandardPaths::setTestModeEnabled(true);
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  auto* panel = page.window().findChild<MannequinPanel*>();
  ASSERT_NE(panel, nullptr);
  ASSERT_TRUE(page.choose("buttonPostures", "posture_overhead"));
  const mannequin::Posture overhead = page.posture();
  ASSERT_TRUE(QDir().mkpath(MannequinPanel::postureFolder()));
  const QString file = MannequinPanel::postureFolder() + "/above_the_shelf.json";
  ASSERT_TRUE(panel->savePostureFile(file));
  ASSERT_TRUE(page.choose("buttonPostures", "posture_standing"));
  ASSERT_TRUE(page.choose("buttonPostures", "own_posture_above_the_shelf"));
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i)
    EXPECT_NEAR(page.posture().angles[i], overhead.angles[i], 1e-9) << i;
  QFile::remove(file);
  QStandardPaths::setTestModeEnabled(false);
}

TEST(MannequinDock, TheEyesLookWhereTheyAreTurned) {
  MannequinPage page;
  const auto bench = page.add(table());
  ASSERT_TRUE(page.addMannequin());
  const auto mannequin = page.window().selection().current();
  auto* row = page.find<JointRow>("joint_gaze_yaw");
  auto* part = page.find<QComboBox>("comboBodyPart");
  part->setCurrentIndex(1);
  emit part->activated(1);
  MannequinPage::settle();
  ASSERT_TRUE(row->isVisible());
  const std::size_t before = page.steps();
  QTest::mousePress(row, Qt::LeftButton, Qt::NoModifier, QPoint(row->pixelOf(0), row->height() / 2));
  QTest::mouseMove(row, QPoint(row->pixelOf(20), row->height() / 2));
  QTest::mouseRelease(row, Qt::LeftButton, Qt::NoModifier, QPoint(row->pixelOf(20), row->height() / 2));
  EXPECT_EQ(page.steps(), before + 1);
  EXPECT_NEAR(page.posture().gaze.yaw, 20.0 * std::numbers::pi / 180.0, 0.02);
  page.window().selection().set(bench);  // What it is to look at.
  MannequinPage::settle();
  page.window().selection().set(mannequin);
  ASSERT_TRUE(page.clickForStep("buttonLookAt"));
  EXPECT_GT(page.posture().gaze.pitch, 0.3) << "down to the bench";
  page.trigger("actionUndo");
  EXPECT_NEAR(page.posture().gaze.yaw, 20.0 * std::numbers::pi / 180.0, 0.02);
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

TEST(MannequinDock, OffersToTheHandWhatMayBeMovedBeforeWhatIsLocked) {
  MannequinPage page;
  workcell::Entity bench = table();
  bench.locked = true;
  page.add(bench);
  ASSERT_TRUE(page.addMannequin());
  workcell::Entity housing = table();
  housing.name = "Housing";
  page.add(housing);
  page.settle();
  auto* parts = page.find<QComboBox>("comboCarried");
  ASSERT_EQ(parts->count(), 2);
  EXPECT_EQ(parts->currentText(), "Housing");
  EXPECT_EQ(parts->itemText(1).toStdString(), bench.name);
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
  EXPECT_NEAR(page.posture()[Dof::kRightElbowFlexion], std::numbers::pi / 2.0, 0.06);
}

/// The right hand forward, or both as they hang, seen from the right: the arrow upwards, and how far it is.
class HandArrow {
 public:
  explicit HandArrow(MannequinPage& page, const MovedBy& held = by::Hand{Side::kRight}) : page_(page), held_(held) {
    const bool both = std::holds_alternative<by::BothHands>(held);
    EXPECT_TRUE(page.addMannequin());
    EXPECT_TRUE(page.choose("buttonPostures", both ? "posture_standing" : "posture_both_hands_forward"));
    page.click(both ? "hold3" : "hold2");
    page.window().viewport().setStandardView(StandardView::kRight);
    page.window().viewport().fitAll(false);
    page.settle();
  }
  dvec3 grip() const {
    const workcell::Entity& figure = *page_.selected();
    return movedFrame_W(figure, {figure.X_WE, figure.joints()}, held_).p;
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
  MovedBy held_;
};

TEST(MannequinGizmo, BothHandsDrawnUpFromHangingGetToTheShoulders) {
  MannequinPage page;
  HandArrow hands(page, by::BothHands{});
  const dvec3 start = hands.grip();
  ASSERT_TRUE(hands.drag(0.5, 20));
  EXPECT_LT(glm::length(hands.grip() - start - dvec3(0.0, 0.0, 0.5)), 0.01) << page.words("labelReach").toStdString();
}

TEST(MannequinGizmo, DrawsTheHandByTheMouseAndSaysWhatIsMissing) {
  MannequinPage page;
  HandArrow hand(page);
  const dvec3 start = hand.grip();
  ASSERT_TRUE(hand.drag(0.12, 8));
  EXPECT_LT(glm::length(hand.grip() - start - dvec3(0.0, 0.0, 0.12)), 0.005);
  ASSERT_TRUE(hand.drag(1.2, 8));
  EXPECT_TRUE(page.words("labelReach").contains(" short of the target")) << page.words("labelReach").toStdString();
  page.trigger("actionUndo");
  EXPECT_FALSE(page.words("labelReach").contains(" short of the target")) << page.words("labelReach").toStdString();
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

TEST(MannequinGizmo, AHandLiftedByItsArrowBendsTheElbowAndNotTheBack) {
  MannequinPage page;
  HandArrow hand(page);
  const dvec3 start = hand.grip();
  ASSERT_TRUE(hand.drag(0.30, 8));
  EXPECT_LT(glm::length(hand.grip() - start - dvec3(0.0, 0.0, 0.30)), 0.005);
  const auto pose = mannequin::forwardKinematics(*page.selected()->figure(), page.posture());
  const dvec3 back = pose[mannequin::Segment::kThorax].p_WS - pose[mannequin::Segment::kPelvis].p_WS;
  EXPECT_LT(std::acos(glm::normalize(back).z), 10.0 * std::numbers::pi / 180.0);
}

/// A mannequin with a crate on its own before it, seen from the left above.
struct CratePage : MannequinPage {
  bool open(double ahead) {
    if (!addMannequin()) return false;
    figure = selected()->id;
    const Pose X_WR = posture().X_WR;
    workcell::Entity entity;
    entity.name = "Crate";
    entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.25, 0.35, 0.25}))};
    entity.X_WE = X_WR * Pose::translation({ahead, 0.0, 0.0});
    entity.X_WE.p.z = 1.05;
    crate = add(entity);
    geometry::Bounds bounds;
    bounds.add(document().document().find(crate)->X_WE.p - dvec3(0.9));
    bounds.add(document().document().find(crate)->X_WE.p + dvec3(0.9));
    window().viewport().fit(bounds, false);
    window().viewport().finishedPicture();
    settle();
    return crate != 0;
  }
  /// A click of the right button on the crate's lid, and an entry of the menu that it opens.
  bool chooseAtCrate(const char* name, const dvec3& p_E = {0.08, 0.0, 0.125}) {
    while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    ViewportWidget& viewport = window().viewport();
    const dvec3 lid = document().document().find(crate)->X_WE * p_E;
    const auto pixel =
        viewport.camera().project(lid, {static_cast<double>(viewport.width()), static_cast<double>(viewport.height())});
    if (!pixel) return false;
    const QPointF place(pixel->x, pixel->y);
    for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      QMouseEvent event(type, place, viewport.mapToGlobal(place), Qt::RightButton,
                        type == QEvent::MouseButtonPress ? Qt::RightButton : Qt::NoButton, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
    }
    settle();
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    auto* action = window().findChild<QAction*>(name);
    if (!menu || !action || !menu->actions().contains(action) || !action->isVisible()) return false;
    const std::size_t before = steps();
    QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(action).center());
    return until([&] { return steps() == before + 1; }, kPatience);
  }
  dvec3 gripInCrate(mannequin::Side side) {
    const auto* entity = document().document().find(figure);
    const auto pose = mannequin::forwardKinematics(*entity->figure(), postureOf(*entity));
    const dvec3 grip = mannequin::handPose(pose, side) * entity->figure()->p_HandGrip[static_cast<std::size_t>(side)];
    return document().document().find(crate)->X_WE.inverse() * grip;
  }
  workcell::EntityId figure = 0, crate = 0;
};

TEST(HandsToPart, BothGoToOppositeSidesFromTheScenesMenuAsOneStep) {
  CratePage page;
  ASSERT_TRUE(page.open(0.45));
  const auto before = postureOf(*page.document().document().find(page.figure)).angles;
  ASSERT_TRUE(page.chooseAtCrate("actionBothHandsHere"));
  const dvec3 left = page.gripInCrate(mannequin::Side::kLeft), right = page.gripInCrate(mannequin::Side::kRight);
  EXPECT_NEAR(left.y, 0.175, 3e-3);
  EXPECT_NEAR(right.y, -0.175, 3e-3);
  EXPECT_NEAR(left.x, right.x, 5e-3);
  page.trigger("actionUndo");
  EXPECT_EQ(postureOf(*page.document().document().find(page.figure)).angles, before);
}

TEST(HandsToPart, OneGoesToThePlaceAndAFarOneIsSaidWithByHowMuch) {
  CratePage page;
  ASSERT_TRUE(page.open(0.45));
  ASSERT_TRUE(page.chooseAtCrate("actionRightHandHere"));
  EXPECT_LT(glm::length(page.gripInCrate(mannequin::Side::kRight) - dvec3(0.08, 0.0, 0.125)), 0.02);
  page.trigger("actionUndo");
  Pose far = page.document().document().find(page.crate)->X_WE;
  far.p += page.document().document().find(page.figure)->X_WE.rotate({0.9, 0.0, 0.0});
  ASSERT_TRUE(page.document().execute(workcell::SetPlacement{page.crate, far}));
  page.settle();
  ASSERT_TRUE(page.chooseAtCrate("actionRightHandHere"));
  const auto& told = page.window().messages().messages().back();
  EXPECT_EQ(told.title, "Crate is out of reach");
  EXPECT_TRUE(told.text.contains("The right hand is") && told.text.contains("short")) << told.text.toStdString();
}

TEST(HandsToPart, SitsOnAChairLookingAsTheChairDoes) {
  CratePage page;
  ASSERT_TRUE(page.open(0.7));
  auto chair = workcell::makeBuiltInPart("chair:0.42", 1.0);
  ASSERT_TRUE(chair);
  page.trigger("actionUndo");  // In the crate's place.
  chair->X_WE.p = {1.0, 0.0, 0.0};
  chair->name = "Chair";
  page.crate = page.add(std::move(*chair));
  page.window().selection().set(page.figure);
  geometry::Bounds bounds;
  bounds.add(dvec3(0.4, -0.6, 0.0));
  bounds.add(dvec3(1.6, 0.6, 1.0));
  page.window().viewport().fit(bounds, false);
  page.window().viewport().finishedPicture();
  page.settle();
  ASSERT_TRUE(page.chooseAtCrate("actionSitHere", {0.0, -0.1, 0.42}));
  const auto* figure = page.document().document().find(page.figure);
  const auto pose = mannequin::forwardKinematics(*figure->figure(), postureOf(*figure));
  EXPECT_NEAR(pose[mannequin::Segment::kPelvis].p_WS.x, 1.0, 2e-3);
  EXPECT_LT(mannequin::footPose(pose, mannequin::Side::kLeft).p.y, -0.2) << "along the chair's -y";
  EXPECT_NEAR(mannequin::footPose(pose, mannequin::Side::kLeft).p.z + figure->figure()->sole.z, 0.0, 3e-3);
  EXPECT_TRUE(page.window().holdChoice().hands().locks.seat);
}

TEST(HandsToPart, TheMenusEntriesAreThereOnlyWithAMannequin) {
  MannequinPage page;
  EXPECT_FALSE(page.window().findChild<QAction*>("actionBothHandsTo")->isEnabled());
  EXPECT_FALSE(page.window().findChild<QAction*>("actionBothHandsHere")->isVisible());
  ASSERT_TRUE(page.addMannequin());
  EXPECT_TRUE(page.window().findChild<QAction*>("actionBothHandsTo")->isEnabled());
  page.trigger("actionBothHandsTo");
  EXPECT_TRUE(page.window().viewport().isPicking());
}

TEST(MannequinSkin, AFigureIsDrawnInOneSkinAtRestAndInTheNextPosture) {
  MannequinPage page;
  ASSERT_TRUE(page.addMannequin());
  const auto drawn = [&] { return page.window().viewport().scene().items({}).size(); };
  ASSERT_TRUE(page.until([&] { return drawn() == 12; }, 12 * MannequinPage::kPatience))
      << "shirt, trousers, belt, shoes, soles, skin; hair, lids, lips, whites, irises and pupils: " << drawn();
  const auto before = page.window().viewport().scene().items({})[0].bounds_M;
  ASSERT_TRUE(page.choose("buttonPostures", "posture_both_hands_forward"));
  EXPECT_EQ(drawn(), 12u) << "the same skin at once";
  EXPECT_GT(page.window().viewport().scene().items({})[0].bounds_M.max.x, before.max.x + 0.1);
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
  EXPECT_EQ(page.selected()->kind(), workcell::EntityKind::kMannequin);
  EXPECT_FALSE(icon("mannequin").pixmap(16, 16).toImage().isNull());
}

}  // namespace
}  // namespace hapticell::app
