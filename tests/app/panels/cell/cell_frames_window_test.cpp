// SPDX-License-Identifier: Apache-2.0
// Frames of the cell in the window, by real events: placed, picked, moved, renamed, copied, removed; as reference for
// typed places, the gizmo and the jog.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QMenu>
#include <numbers>

#include "app/controls/pose_text.h"
#include "app/panels/cell/workcell_panel.h"
#include "app/style/segmented.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {
namespace {

class FramePage : public RobotPage {
 public:
  FramePage() {
    window().viewport().setMotion(false);
    look();
  }
  ~FramePage() {
    while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    settle();
  }
  void look() {
    geometry::Bounds bounds;
    bounds.add(dvec3(-0.6, -0.6, -0.3));
    bounds.add(dvec3(0.6, 0.6, 0.9));
    window().viewport().fit(bounds, false);
    window().viewport().finishedPicture();
    settle();
  }
  const workcell::DocumentState& state() { return document().document().state(); }
  const workcell::Entity* named(const char* name) { return state().findByName(name); }
  workcell::EntityId addFrame(const char* name, const Pose& X_W) { return add(workcell::makeFrame(name, X_W)); }
  workcell::EntityId addCube(const char* name, const Pose& X_W) {
    Diagnostics notes;
    workcell::Entity cube = workcell::EntityLoader(".").load("box:0.2,0.2,0.2", 0.0, notes).value();
    cube.name = name;
    cube.X_WE = X_W;
    return add(std::move(cube));
  }
  /// The scene's own lines that bear this text.
  int linesCalled(const std::string& text) {
    const auto curves = window().viewport().allCurves();
    return static_cast<int>(
        std::count_if(curves.begin(), curves.end(), [&](const SceneCurve& curve) { return curve.text == text; }));
  }
  bool chooseReference(const char* combo, const QString& text) {
    auto* choice = find<QComboBox>(combo);
    const int index = choice->findText(text);
    if (index < 0) return false;
    choice->setCurrentIndex(index);
    emit choice->activated(index);
    settle();
    return true;
  }
  double number(const char* field) { return find<ValueField>(field)->value(); }
  void drag(const QPoint& from, const QPoint& to) {
    ViewportWidget& scene = window().viewport();
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, at, scene.mapToGlobal(at), button, held, Qt::NoModifier);
      QApplication::sendEvent(&scene, &event);
    };
    send(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= 5; ++i)
      send(QEvent::MouseMove, QPointF(from) + QPointF(to - from) * i / 5.0, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    settle();
  }
};

TEST(CellFrames, AreInsertedWhereTheSceneIsClicked) {
  FramePage page;
  page.trigger("actionInsertFrame");
  ASSERT_TRUE(page.window().viewport().isPicking());
  const dvec3 place(0.2, -0.3, 0.0);
  page.overScene(page.pixelOfPoint(place), true);
  ASSERT_EQ(page.entities(), 1u);
  EXPECT_FALSE(page.window().viewport().isPicking());
  const workcell::Entity* frame = page.selected();
  ASSERT_NE(frame, nullptr) << "it is chosen, to be typed to its place";
  EXPECT_EQ(frame->kind(), workcell::EntityKind::kFrame);
  EXPECT_EQ(frame->name, "Frame");
  EXPECT_LT(glm::length(frame->X_WE.p - place), 0.01);
  EXPECT_EQ(page.linesCalled("Frame"), 1) << "its name stands beside it";
  EXPECT_EQ(page.steps(), 1u);
  // Onto a corner of a part.
  page.addCube("cube", Pose::translation({0, 0, 0.1}));
  ViewportWidget& scene = page.window().viewport();
  ASSERT_TRUE(FramePage::until([&] { return scene.hasWhole(scene.scene().revision()); }, FramePage::kPatience));
  page.trigger("actionInsertFrame");
  const dvec3 corner(0.1, -0.1, 0.2);
  page.overScene(page.pixelOfPoint(corner) + QPoint(-2, 3), true);
  ASSERT_EQ(page.entities(), 3u);
  EXPECT_LT(glm::length(page.selected()->X_WE.p - corner), 1e-6) << "the corner, not the pointer";
  EXPECT_EQ(page.selected()->name, "Frame 2");
  // Escape makes none.
  page.trigger("actionInsertFrame");
  QTest::keyClick(&scene, Qt::Key_Escape);
  page.settle();
  EXPECT_FALSE(scene.isPicking());
  EXPECT_EQ(page.entities(), 3u);
  for (int k = 0; k < 3; ++k) page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
}

TEST(CellFrames, ArePickedMovedCopiedRenamedAndRemoved) {
  FramePage page;
  const auto id = page.addFrame("station", Pose::translation({0.3, 0.0, 0.2}));
  page.window().selection().set(0);
  // By a click on an axis of it; the scene is empty behind.
  const double length = 0.05;
  const QPoint on_axis = page.pixelOfPoint(dvec3(0.3, 0.0, 0.2 + length));
  page.overScene(on_axis, true);
  EXPECT_EQ(page.window().selection().current(), id);
  EXPECT_EQ(page.window().viewport().hoverName(), "station");
  page.overScene(on_axis + QPoint(200, 0), true);
  EXPECT_EQ(page.window().selection().current(), 0u);
  // By its row in the tree, as any entity.
  auto* tree = page.window().findChild<WorkcellPanel*>();
  ASSERT_TRUE(tree->model().indexOf(id).isValid());
  EXPECT_EQ(tree->model().indexOf(id).data(WorkcellTreeModel::kIconRole).toString(), "frame");
  page.window().selection().set(id);
  page.settle();
  // By numbers, and by the gizmo.
  page.type("field_place_X", "450");
  EXPECT_NEAR(page.selected()->X_WE.p.x, 0.45, 1e-12);
  page.trigger("actionMove");
  const dvec3 p = page.selected()->X_WE.p;
  const ViewportWidget& scene = page.window().viewport();
  const double pixel =
      scene.camera().metresPerPixel(p, {static_cast<double>(scene.width()), static_cast<double>(scene.height())});
  page.drag(page.pixelOfPoint(p + dvec3(0, 0, 80 * pixel)), page.pixelOfPoint(p + dvec3(0, 0, 80 * pixel + 0.2)));
  EXPECT_NEAR(page.selected()->X_WE.p.z, 0.4, 0.01);
  EXPECT_NEAR(page.selected()->X_WE.p.x, 0.45, 1e-9) << "along its arrow only";
  page.trigger("actionSelect");
  ASSERT_TRUE(tree->model().setData(tree->model().indexOf(id), "pick", Qt::EditRole));
  EXPECT_NE(page.named("pick"), nullptr);
  page.trigger("actionCopy");
  page.trigger("actionPaste");
  ASSERT_NE(page.named("pick 2"), nullptr);
  EXPECT_EQ(page.named("pick 2")->kind(), workcell::EntityKind::kFrame);
  page.trigger("actionRemove");
  EXPECT_EQ(page.named("pick 2"), nullptr);
  for (int k = 0; k < 5; ++k) page.trigger("actionUndo");
  EXPECT_EQ(page.named("station")->X_WE.p, dvec3(0.3, 0.0, 0.2));
}

TEST(CellFrames, AreFixedToALinkAndGoWithIt) {
  FramePage page;
  const auto robot = page.addRobot("kuka_kr16_2");
  const auto frame = page.addFrame("grip", Pose::translation({0.5, 0.0, 0.5}));
  const std::string tip = page.document().document().find(robot)->jointed().tip_link;
  const QString robot_name = QString::fromStdString(page.document().document().find(robot)->name);
  EXPECT_FALSE(page.find<QWidget>("comboFrameCarrier")->isHidden());
  const std::size_t before = page.steps();
  ASSERT_TRUE(page.chooseReference("comboFrameCarrier", robot_name + " · " + QString::fromStdString(tip)));
  EXPECT_EQ(page.selected()->attachment.to, robot_name.toStdString());
  EXPECT_EQ(page.selected()->attachment.link, tip);
  EXPECT_EQ(page.steps(), before + 1);
  auto* tree = page.window().findChild<WorkcellPanel*>();
  EXPECT_EQ(tree->model().indexOf(frame).parent(), tree->model().indexOf(robot));
  std::vector<double> q = page.document().document().find(robot)->joints();
  q[0] += 0.5;
  ASSERT_TRUE(page.document().execute(workcell::SetJoints{robot, q}));
  page.settle();
  EXPECT_GT(glm::length(page.selected()->X_WE.p - dvec3(0.5, 0.0, 0.5)), 0.1);
  ASSERT_TRUE(page.chooseReference("comboFrameCarrier", "World"));
  EXPECT_TRUE(page.selected()->attachment.to.empty());
}

TEST(CellFrames, ArePlacesThatNumbersAreGivenIn) {
  FramePage page;
  const Pose X_WF{{0.3, 0.1, 0.0}, quaternionFromRotationVector({0, 0, 0.5 * std::numbers::pi})};
  const auto cube = page.addCube("cube", Pose::translation({0.3, 0.4, 0.1}));
  auto* reference = page.find<QComboBox>("comboReference");
  EXPECT_TRUE(reference->isHidden() || !reference->isVisibleTo(&page.window())) << "no frame, no choice";
  page.addFrame("station", X_WF);
  page.window().selection().set(cube);
  page.settle();
  ASSERT_TRUE(page.chooseReference("comboReference", "station"));
  EXPECT_NEAR(page.number("field_place_X"), 300.0, 1e-6) << "0.3 m along the frame's x, which is the world's y";
  EXPECT_NEAR(page.number("field_place_Y"), 0.0, 1e-6);
  page.type("field_place_Y", "50");
  EXPECT_LT(glm::length(page.named("cube")->X_WE.p - dvec3(0.25, 0.4, 0.1)), 1e-9);
  // The frame moves, the part stays: other numbers.
  ASSERT_TRUE(
      page.document().execute(workcell::SetPlacement{page.named("station")->id, {X_WF.p + dvec3(0, 0.1, 0), X_WF.q}}));
  page.settle();
  EXPECT_NEAR(page.number("field_place_X"), 200.0, 1e-6);
  // In the dock Solid too.
  auto* solid = page.window().findChild<QDockWidget*>("dockSolid");
  solid->show();
  solid->raise();
  page.settle();
  page.find<Segmented>("segmentsPlaceIn")->button(2)->click();
  page.settle();
  EXPECT_NEAR(page.number("fieldSolidX"), 200.0, 1e-6);
  page.type("fieldSolidX", "100");
  EXPECT_LT(glm::length(page.named("cube")->X_WE.p - dvec3(0.25, 0.3, 0.1)), 1e-9);
  // Gone, it is chosen no longer.
  ASSERT_TRUE(page.document().execute(workcell::RemoveEntity{page.named("station")->id}));
  page.settle();
  EXPECT_EQ(reference->currentText(), "World");
  EXPECT_NEAR(page.number("field_place_X"), 250.0, 1e-6);
  EXPECT_EQ(page.find<Segmented>("segmentsPlaceIn")->current(), 0);
}

TEST(CellFrames, TheRobotIsJoggedAlongTheirAxes) {
  FramePage page;
  const auto robot = page.addRobot("kuka_kr16_2");
  page.find<Segmented>("segmentsJog")->button(1)->click();
  page.settle();
  auto* frames = page.find<Segmented>("segmentsJogFrame");
  EXPECT_FALSE(frames->button(3)->isEnabled()) << "there is none yet";
  const Pose X_WF{{0.2, 0.3, 0.1}, quaternionFromRotationVector({0.3, -0.4, 0.5})};
  page.addFrame("station", X_WF);
  page.window().selection().set(robot);
  page.settle();
  ASSERT_TRUE(frames->button(3)->isEnabled());
  frames->button(3)->click();
  page.settle();
  const auto tool = [&] { return tcpPose_W(*page.selected(), page.selected()->X_WE, page.joints()); };
  const Pose before = tool();
  const dvec3 p_F = X_WF.inverse() * before.p;
  EXPECT_NEAR(page.number("jogPoseX"), 1000.0 * p_F.x, 1e-6);
  ASSERT_TRUE(page.clickForStep("jogYMore")) << page.words("labelStop").toStdString();
  EXPECT_LT(glm::length(tool().p - before.p - 0.001 * X_WF.rotate(dvec3(0, 1, 0))), 2e-6)
      << "a millimetre along the frame's y";
  const dvec3 wanted = p_F + dvec3(0.0, 0.001, 0.02);
  ASSERT_TRUE(page.typeForStep("jogPoseZ", QString::number(1000.0 * wanted.z, 'f', 6)));
  EXPECT_LT(glm::length(X_WF.inverse() * tool().p - wanted), 1e-5);
  ASSERT_TRUE(page.document().execute(workcell::RemoveEntity{page.named("station")->id}));
  page.settle();
  EXPECT_EQ(frames->current(), 0) << "the base's axes again";
}

TEST(CellFrames, TheGizmoGoesAlongTheirAxes) {
  FramePage page;
  const Pose X_WF{{0, 0, 0}, quaternionFromRotationVector({0, 0, 0.6})};
  const auto cube = page.addCube("cube", Pose::translation({0.1, 0, 0.1}));
  page.addFrame("station", X_WF);
  page.window().selection().set(cube);
  page.trigger("actionMoveBy");
  page.find<Segmented>("segmentsEditAxes")->button(3)->click();
  page.settle();
  page.type("fieldMoveX", "100");
  page.click("buttonMoveBy");
  EXPECT_LT(glm::length(page.named("cube")->X_WE.p - dvec3(0.1, 0, 0.1) - X_WF.rotate(dvec3(0.1, 0, 0))), 1e-9);
}

TEST(CellFrames, AnOwnFrameOfAPartIsRenamedAndRemovedInTheTree) {
  FramePage page;
  const auto cube = page.addCube("cube", Pose::translation({0, 0, 0.1}));
  ASSERT_TRUE(page.document().execute(workcell::SetFrames{
      cube, {{"grip", Pose::translation({0, 0, 0.1})}, {"seat", Pose::translation({0, 0, -0.1})}}}));
  page.settle();
  auto* panel = page.window().findChild<WorkcellPanel*>();
  const auto rows = [&] {
    std::vector<QModelIndex> found;
    const QModelIndex parent = panel->model().indexOf(cube);
    for (int row = 0; row < panel->model().rowCount(parent); ++row)
      found.push_back(panel->model().index(row, 0, parent));
    return found;
  };
  ASSERT_EQ(rows().size(), 2u);
  ASSERT_TRUE(panel->model().setData(rows()[0], "handle", Qt::EditRole));
  EXPECT_EQ(page.named("cube")->frames[0].name, "handle");
  auto* filter = qobject_cast<QSortFilterProxyModel*>(panel->tree().model());
  QMenu menu;
  panel->fillMenu(menu, filter->mapFromSource(rows()[1]));
  for (QAction* action : menu.actions())
    if (action->text() == "Remove this frame") action->trigger();
  ASSERT_EQ(page.named("cube")->frames.size(), 1u);
  EXPECT_EQ(page.named("cube")->frames[0].name, "handle");
  EXPECT_TRUE(page.chooseReference("comboReference", "cube · handle") == false) << "nothing is given in itself";
}

}  // namespace
}  // namespace hapticell::app
