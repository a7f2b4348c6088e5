// SPDX-License-Identifier: Apache-2.0
// Choosing several, the gizmo, moving in numbers and putting one part onto another, by real events.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <numbers>

#include "app/edit/move_panel.h"
#include "app/host/user_settings.h"
#include "app/viewport/tools/gizmo.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

constexpr double kHalf = 0.05;

/// Two boxes side by side on x, seen from the front above.
class EditPage : public CellPage {
 public:
  EditPage() {
    window().resize(1500, 900);
    window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window(), 20000));
    settle();
    left = addSolid("left", geometry::makeBox({0.1, 0.1, 0.1}));
    right = addSolid("right", geometry::makeBox({0.1, 0.1, 0.1}), Pose::translation({0.4, 0, 0}));
    lookAt({0.2, 0, 0}, 0.35);
  }
  QPointF pixelOf(const dvec3& p_W) {
    const ViewportWidget& viewport = window().viewport();
    const auto pixel =
        viewport.camera().project(p_W, {static_cast<double>(viewport.width()), static_cast<double>(viewport.height())});
    EXPECT_TRUE(pixel.has_value());
    return pixel ? QPointF(pixel->x, pixel->y) : QPointF();
  }
  void mouse(QEvent::Type type, const QPointF& place, Qt::KeyboardModifiers held = Qt::NoModifier) {
    ViewportWidget& viewport = window().viewport();
    const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, place, viewport.mapToGlobal(place), Qt::LeftButton, buttons, held);
    QApplication::sendEvent(&viewport, &event);
  }
  void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers held = Qt::NoModifier) {
    mouse(QEvent::MouseButtonPress, from, held);
    for (int i = 1; i <= 4; ++i) mouse(QEvent::MouseMove, from + (to - from) * (0.25 * i), held);
    mouse(QEvent::MouseButtonRelease, to, held);
    settle();
  }
  /// Where the gizmo at a point has the tip of its x arrow, and a place so many metres on.
  QPointF arrowOf(const dvec3& p_W, double further = 0.0) {
    const ViewportWidget& viewport = window().viewport();
    const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
    return pixelOf(p_W + dvec3(0.6 * 96.0 * viewport.camera().metresPerPixel(p_W, size) + further, 0, 0));
  }
  dvec3 place(workcell::EntityId id) { return document().find(id)->X_WE.p; }
  std::size_t steps() { return document().undoTexts().size(); }
  workcell::EntityId left = 0, right = 0;
};

TEST(ChoosingSeveral, ControlAddsAndTakesOut) {
  EditPage page;
  page.clickPoint({0, 0, kHalf});
  EXPECT_EQ(page.window().selection().all(), std::vector{page.left});
  const QPointF on_right = page.pixelOf({0.4, 0, kHalf});
  page.drag(on_right, on_right, Qt::ControlModifier);
  EXPECT_EQ(page.window().selection().all(), (std::vector{page.left, page.right}));
  EXPECT_EQ(page.window().selection().current(), page.right);
  page.drag(on_right, on_right, Qt::ControlModifier);
  EXPECT_EQ(page.window().selection().all(), std::vector{page.left});
}

TEST(ChoosingSeveral, ABoxFromTheLeftTakesWhatIsInsideFromTheRightWhatItTouches) {
  EditPage page;
  const QPointF outside = page.pixelOf({-0.12, 0, 0}) - QPointF(20, 90),
                middle = page.pixelOf({0.4, 0, 0}) + QPointF(0, 90);
  page.drag(outside, middle);
  EXPECT_EQ(page.window().selection().all(), std::vector{page.left}) << "the right one is only half inside";
  page.drag(middle, outside);
  EXPECT_EQ(page.window().selection().all().size(), 2u);
  page.drag(QPointF(5, 200), QPointF(15, 260));
  EXPECT_TRUE(page.window().selection().all().empty()) << "an empty box chooses nothing";
}

TEST(GizmoInTheScene, WMovesAlongAnAxisAsOneStepOfUndo) {
  EditPage page;
  page.select(page.left);
  page.key(Qt::Key_W);
  const std::size_t before = page.steps();
  page.drag(page.arrowOf({0, 0, 0}), page.arrowOf({0, 0, 0}, 0.1));
  EXPECT_NEAR(page.place(page.left).x, 0.1, 0.01);
  EXPECT_NEAR(page.place(page.left).y, 0.0, 1e-12);
  EXPECT_NEAR(page.place(page.left).z, 0.0, 1e-12);
  EXPECT_EQ(page.steps(), before + 1);
  page.trigger("actionUndo");
  EXPECT_EQ(page.place(page.left), dvec3(0.0));
}

TEST(GizmoInTheScene, SeveralGoTogetherAndEscapeTakesADragBack) {
  EditPage page;
  page.window().selection().setAll({page.right, page.left}, page.left);
  page.key(Qt::Key_W);
  const std::size_t before = page.steps();
  const QPointF from = page.arrowOf({0, 0, 0}), to = page.arrowOf({0, 0, 0}, 0.15);
  page.mouse(QEvent::MouseButtonPress, from);
  page.mouse(QEvent::MouseMove, to);
  EXPECT_NEAR(page.place(page.right).x - page.place(page.left).x, 0.4, 1e-12);
  EXPECT_GT(page.place(page.left).x, 0.1);
  page.key(Qt::Key_Escape);
  EXPECT_EQ(page.place(page.left), dvec3(0.0));
  EXPECT_EQ(page.steps(), before);
  page.mouse(QEvent::MouseButtonRelease, to);
  EXPECT_EQ(page.steps(), before);
}

TEST(GizmoInTheScene, StepsKeepToTheGridAndControlSnapsToTheOtherPart) {
  EditPage page;
  page.showDock("dockMove");
  page.press("switchGrid");
  page.type("fieldGrid", "40");
  page.lookAt({0.2, 0, 0}, 0.35);
  page.select(page.left);
  page.key(Qt::Key_W);
  page.drag(page.arrowOf({0, 0, 0}), page.arrowOf({0, 0, 0}, 0.09));
  EXPECT_NEAR(page.place(page.left).x, 0.08, 1e-9);
  page.press("switchGrid");
  // The origin goes to where the other's corner is along the axis.
  page.drag(page.arrowOf(page.place(page.left)), page.pixelOf({0.35, -kHalf, kHalf}), Qt::ControlModifier);
  EXPECT_NEAR(page.place(page.left).x, 0.35, 1e-9);
}

TEST(GizmoInTheScene, IsGoneWhileAHandHasThePartAndBackWhereItWasPut) {
  EditPage page;
  page.select(page.left);
  page.key(Qt::Key_W);
  const auto arrows = [&] {
    std::vector<dvec3> tips;
    const SceneModel& scene = page.window().viewport().scene();
    const dvec3 origin = scene.placement_W(*scene.find(page.left)).p;  // There the axes of the part's marks begin.
    for (const SceneCurve& curve : page.window().viewport().allCurves())
      if (curve.text == "X" && curve.points_W.size() == 2 && glm::length(curve.points_W.front() - origin) > 1e-6)
        tips.push_back(curve.points_W.back());
    return tips;
  };
  ASSERT_EQ(arrows().size(), 1u);
  const dvec3 before = arrows().front();
  manipulation::SceneSnapshot snapshot;  // It hangs on what is held: held is another entity.
  snapshot.stylus.held = page.right;
  snapshot.entities.push_back({page.left, Pose::translation({0, 0.1, 0}), {}});
  page.window().setSnapshot(snapshot);
  EXPECT_TRUE(arrows().empty());
  page.window().documentModel().execute(workcell::SetPlacement{page.left, Pose::translation({0, 0.1, 0})});
  page.window().setSnapshot(manipulation::SceneSnapshot{});
  ASSERT_EQ(arrows().size(), 1u);
  EXPECT_LT(glm::length(arrows().front() - before - dvec3(0, 0.1, 0)), 0.01);
}

TEST(GizmoInTheScene, LockedPartsHaveNone) {
  EditPage page;
  page.window().documentModel().execute(workcell::SetProperties{.id = page.left, .locked = true});
  page.select(page.left);
  page.key(Qt::Key_W);
  page.drag(page.arrowOf({0, 0, 0}), page.arrowOf({0, 0, 0}, 0.1));
  EXPECT_EQ(page.place(page.left), dvec3(0.0));
}

TEST(MoveInNumbers, GoesAlongTheAxesThatAreChosen) {
  EditPage page;
  page.window().documentModel().execute(
      workcell::SetPlacement{page.left, {{0, 0, 0}, glm::angleAxis(0.5 * std::numbers::pi, dvec3(0, 0, 1))}});
  page.select(page.left);
  page.showDock("dockMove");
  page.type("fieldMoveX", "25");
  page.press("buttonMoveBy");
  EXPECT_NEAR(page.place(page.left).x, 0.025, 1e-9);
  page.chooseSegment("segmentsEditAxes", 2);
  page.press("buttonMoveBy");
  EXPECT_NEAR(page.place(page.left).x, 0.025, 1e-9);
  EXPECT_NEAR(page.place(page.left).y, 0.025, 1e-9) << "its own x looks along the world's y";
  EXPECT_EQ(page.document().undoText(), "Move left");
}

TEST(MoveInNumbers, TakesUnitsBehindTheNumber) {
  EditPage page;
  page.select(page.left);
  page.showDock("dockMove");
  page.type("fieldMoveZ", "2in");
  page.press("buttonMoveBy");
  EXPECT_NEAR(page.place(page.left).z, 0.0508, 1e-9);
}

TEST(PutOnto, LaysAFaceFlatOnAFace) {
  EditPage page;
  page.select(page.left);
  page.showDock("dockMove");
  page.press("buttonOnto");
  page.lookAt({0, 0, kHalf}, 0.1);  // Near enough to hit the face beside its edges.
  page.clickPoint({0.02, 0.01, kHalf});
  ASSERT_TRUE(page.window().viewport().isPicking()) << "the second is asked for";
  page.lookAt({0.4, 0, kHalf}, 0.1);
  page.clickPoint({0.41, 0.01, kHalf});
  EXPECT_FALSE(page.window().viewport().isPicking());
  const Pose X_WE = page.document().find(page.left)->X_WE;
  EXPECT_NEAR(X_WE.p.z, 0.1, 1e-6) << "upside down on top of the other: " << page.document().undoText();
  EXPECT_NEAR(X_WE.rotate({0, 0, 1}).z, -1.0, 1e-6);
  page.trigger("actionUndo");
  EXPECT_EQ(page.place(page.left), dvec3(0.0));
}

TEST(MoveSettings, AreRemembered) {
  EditPage page;
  page.showDock("dockMove");
  page.press("switchAngle");
  page.type("fieldAngle", "30");
  page.chooseSegment("segmentsEditAxes", 1);
  const UserSettings& settings = page.window().userSettings();
  EXPECT_TRUE(settings.value("edit/angle_on").toBool());
  EXPECT_DOUBLE_EQ(settings.value("edit/angle_deg").toDouble(), 30.0);
  EXPECT_EQ(settings.value("edit/axes").toInt(), 1);
}

}  // namespace
}  // namespace hapticell::app
