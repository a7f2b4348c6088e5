// SPDX-License-Identifier: Apache-2.0
// The whole window under a virtual display, driven through WindowPage.
#include <gtest/gtest.h>

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/style/proxy_style.h"
#include "app/style/theme.h"
#include "tests/app/pages/picture_compare.h"
#include "tests/app/pages/window_page.h"

namespace hapticell::app {
namespace {

/// A tetrahedron with edges of a decimetre as an ASCII OFF file.
QString writeSolid(const QTemporaryDir& folder, const char* name) {
  const QString path = folder.filePath(name);
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("OFF\n4 4 6\n0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  return path;
}

TEST(Window, AnEmptyCellSaysHowToBegin) {
  WindowPage page;
  EXPECT_EQ(page.sentence(), "The cell is empty.");
  EXPECT_FALSE(page.enabled("actionUndo"));
}

TEST(Window, ImportIsOneStepOfUndo) {
  QTemporaryDir folder;
  WindowPage page;
  ASSERT_TRUE(page.add(writeSolid(folder, "corner.off")));
  EXPECT_EQ(page.entities(), 1u);
  EXPECT_NE(page.window().selection().current(), 0u);
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 0u);
  EXPECT_EQ(page.window().selection().current(), 0u) << "what is gone is not selected";
  page.trigger("actionRedo");
  EXPECT_EQ(page.entities(), 1u);
}

TEST(Window, ABadFileIsASentenceAndTheCellIsAsItWas) {
  QTemporaryDir folder;
  WindowPage page;
  page.add(writeSolid(folder, "corner.off"));
  QFile bad(folder.filePath("broken.stl"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("solid broken\nfacet normal 0 0 1\nouter loop\nvertex 0 0");
  bad.close();
  EXPECT_FALSE(page.add(bad.fileName()));
  EXPECT_EQ(page.entities(), 1u);
  ASSERT_FALSE(page.window().messages().messages().empty());
  const Message& told = page.window().messages().messages().back();
  EXPECT_EQ(told.severity, Severity::kProblem);
  EXPECT_TRUE(told.text.contains("broken.stl")) << told.text.toStdString();
}

TEST(Window, SavesAndOpensAgain) {
  QTemporaryDir folder;
  const QString path = folder.filePath("cell.hcell");
  {
    WindowPage page;
    page.add(writeSolid(folder, "corner.off"));
    ASSERT_TRUE(page.window().documentModel().save(path));
  }
  WindowPage page;
  ASSERT_TRUE(page.open(path));
  EXPECT_EQ(page.entities(), 1u);
  EXPECT_FALSE(page.window().documentModel().document().isDirty());
  EXPECT_FALSE(page.open(folder.filePath("missing.hcell")));
  EXPECT_EQ(page.entities(), 1u);
}

TEST(Window, ThePictureShowsThePartAndAClickFindsIt) {
  QTemporaryDir folder;
  WindowPage page;
  page.window().viewport().setMotion(false);
  page.add(writeSolid(folder, "corner.off"));
  const QImage empty = [] {
    WindowPage other;
    return other.window().viewport().finishedPicture();
  }();
  const QImage picture = page.window().viewport().finishedPicture();
  ASSERT_EQ(picture.size(), empty.size());
  const ViewportWidget& viewport = page.window().viewport();
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  const auto inside = viewport.camera().project(dvec3(0.02), size);
  ASSERT_TRUE(inside.has_value());
  const QPoint place(static_cast<int>(inside->x), static_cast<int>(inside->y));
  EXPECT_NE(picture.pixel(place), empty.pixel(place));
  const workcell::EntityId solid = page.window().selection().current();
  page.window().selection().set(0);
  page.clickScene(inside->x / size.width, inside->y / size.height);
  EXPECT_EQ(page.window().selection().current(), solid);
  page.clickScene(0.02, 0.3);
  EXPECT_EQ(page.window().selection().current(), 0u) << "a click beside it selects nothing";
}

TEST(Window, FrameTimesFallFromFullToBoxes) {
  QTemporaryDir folder;
  WindowPage page;
  page.add(writeSolid(folder, "corner.off"));
  const auto medians = page.window().viewport().measureFrames(3);
  ASSERT_EQ(medians.size(), 6u);
  for (const double seconds : medians) EXPECT_GT(seconds, 0.0);
}

TEST(Window, WorksWithoutModulesAndStartsTheOneThatIsThere) {
  config::Configuration configuration;
  configuration.server.port = 47479;  // Not one that a user's server listens on.
  WindowPage page(configuration);
  page.window().loadModules({"/nowhere"});
  EXPECT_FALSE(page.window().startModule("Virtual Desktop"));
  page.window().loadModules(ModuleLoader::defaultFolders());
  // The test stands beside the program, so the modules' folder is there too.
  if (page.window().startModule("Virtual Desktop")) {
    EXPECT_TRUE(page.hasDock("dockVirtualDesktop"));
    EXPECT_FALSE(page.window().snapshot() && page.window().snapshot()->stylus.forces_on)
        << "forces are never on by a start";
  } else {
    ADD_FAILURE() << "the module was not found";
  }
}

TEST(Window, TheSectionPlaneCutsTheSceneOpenAndClosesAgain) {
  QTemporaryDir folder;
  WindowPage page;
  ViewportWidget& viewport = page.window().viewport();
  viewport.setMotion(false);
  page.add(writeSolid(folder, "corner.off"));
  WindowPage::settle();
  const QImage whole = viewport.finishedPicture();
  page.trigger("actionSection");
  ASSERT_TRUE(viewport.section());
  const QString open = viewport.viewStrip().cells().back().text;
  EXPECT_TRUE(open.startsWith("Section ")) << "the strip says which way it cuts";
  EXPECT_NE(viewport.finishedPicture(), whole);
  page.trigger("actionSection");
  EXPECT_FALSE(viewport.section());
  EXPECT_EQ(viewport.viewStrip().cells().back().text, "Section off");
  // From the strip too, which way at once.
  viewport.viewStrip().cells().back().menu->actions().at(2)->trigger();
  ASSERT_TRUE(viewport.section());
  EXPECT_EQ(viewport.viewStrip().cells().back().text, "Section Z");
  EXPECT_NE(viewport.finishedPicture(), whole);
}

TEST(Window, ResizedAtRestTheSceneIsDrawnAnew) {
  QTemporaryDir folder;
  WindowPage page;
  ViewportWidget& viewport = page.window().viewport();
  viewport.setMotion(false);
  page.setFinePictures();
  page.add(writeSolid(folder, "corner.off"));
  page.window().selection().set(0);
  const auto rests = [&] { return WindowPage::until([&] { return viewport.isFinished(); }, 120000); };
  ASSERT_TRUE(rests());
  // As a layout with other panels does, and back again: neither picture is the old one, stretched or darkened.
  QSize before = viewport.size();
  for (const QSize& size : {QSize(1380, 880), QSize(1200, 800)}) {
    page.window().resize(size);
    ASSERT_TRUE(WindowPage::until([&] { return page.window().size() == size; }, 10000));
    ASSERT_TRUE(rests());
    EXPECT_NE(viewport.size(), before);
    before = viewport.size();
    const QImage shown = viewport.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    const QImage fresh = viewport.finishedPicture().convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(shown.size(), fresh.size());
    EXPECT_LT(test::meanSquareError(shown, fresh), 1e-3);
  }
}

/// A gap, a contact and a force at one place, beside the gizmo of the part.
TEST(Window, LabelsOverlapNeitherEachOtherNorTheArrowsOfTheGizmo) {
  QTemporaryDir folder;
  WindowPage page;
  ViewportWidget& viewport = page.window().viewport();
  viewport.setMotion(false);
  page.window().resize(1380, 880);
  WindowPage::settle();
  page.add(writeSolid(folder, "corner.off"));
  const workcell::EntityId part = page.window().selection().current();
  viewport.fit(viewport.scene().bounds_W(), false);
  page.trigger("actionMove");
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.connected = true;
  snapshot.stylus.X_WStylus = Pose::translation({0.02, 0.02, 0.02});
  manipulation::PairState near;
  near.moved = near.other = part;
  near.distance = 0.0461;
  near.near_miss = true;
  near.p_WA = near.p_WB = dvec3(0.03, 0.02, 0.02);
  manipulation::PairState contact = near;
  contact.contact = true;
  contact.p_WB = dvec3(0.02);
  snapshot.pairs = {near, contact};
  snapshot.stylus.forces_on = true;
  snapshot.stylus.force_n = 1.4;
  for (int degrees = 0; degrees < 360; degrees += 30) {
    const double angle = degrees * std::numbers::pi / 180.0;
    snapshot.stylus.force_W =
        1.4 * (std::cos(angle) * viewport.camera().right_W() + std::sin(angle) * viewport.camera().up_W());
    snapshot.stylus.X_WStylus.p.x += 1e-3;  // Seen: it is drawn anew.
    page.window().setSnapshot(snapshot);
    viewport.grabFramebuffer();
    const std::vector<PlacedLabel>& labels = viewport.drawnLabels();
    const auto has = [&](std::uint64_t key) {
      return std::any_of(labels.begin(), labels.end(), [key](const PlacedLabel& label) { return label.key == key; });
    };
    EXPECT_TRUE(has(kForceKey) && has(1)) << "the force and the contact are told, at " << degrees;
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(labels[i].box.overlaps(labels[j].box)) << labels[i].key << " and " << labels[j].key;
    for (const SceneCurve& curve : viewport.allCurves()) {
      if (curve.points_W.size() != 2 || curve.text.empty()) continue;
      const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
      const PixelLine shaft{*viewport.camera().project(curve.points_W[0], size),
                            *viewport.camera().project(curve.points_W[1], size), 2.0};
      for (const PlacedLabel& label : labels)
        EXPECT_FALSE(label.key < kForceKey && shaft.reaches(label.box)) << curve.text << ", label " << label.key;
    }
  }
}

TEST(Window, NamesWhatThePointerIsOver) {
  QTemporaryDir folder;
  WindowPage page;
  ViewportWidget& viewport = page.window().viewport();
  viewport.setMotion(false);
  ASSERT_TRUE(page.add(writeSolid(folder, "corner.off")));
  viewport.fitAll(false);
  const auto moveTo = [&viewport](double right, double down) {
    const QPointF place(right * viewport.width(), down * viewport.height());
    QMouseEvent event(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&viewport, &event);
  };
  // What is under the pointer is known once the part is drawn.
  const auto isFound = [&] {
    for (double right = 0.3; right < 0.71; right += 0.1)
      for (double down = 0.3; down < 0.71 && viewport.hoverName() != "corner"; down += 0.1) moveTo(right, down);
    return viewport.hoverName() == "corner";
  };
  EXPECT_TRUE(WindowPage::until(isFound, 30000));
  moveTo(0.02, 0.5);
  EXPECT_TRUE(viewport.hoverName().isEmpty());
}

TEST(Window, TheMenusStandInTheirOrder) {
  WindowPage page;
  QStringList names;
  for (const QAction* action : page.window().menuBar()->actions())
    if (action->menu()) names << action->menu()->objectName();
  EXPECT_EQ(names.join(' ').toStdString(),
            "menuFile menuEdit menuView menuInsert menuRobot menuMannequin menuCollision menuTrajectory "
            "menuApplications menuWindow menuHelp");
  for (const char* name : {"menuInsert", "menuCollision"}) {
    const auto* menu = page.window().findChild<QMenu*>(name);
    ASSERT_NE(menu, nullptr) << name;
    EXPECT_GE(menu->actions().size(), 2) << name;
  }
}

TEST(Window, GoesBackToWhereThePartStood) {
  QTemporaryDir folder;
  WindowPage page;
  ASSERT_TRUE(page.add(writeSolid(folder, "corner.off")));
  DocumentModel& model = page.window().documentModel();
  const auto id = page.window().selection().current();
  Pose moved = model.document().find(id)->X_WE;
  const double before = moved.p.x;
  moved.p.x += 0.25;
  ASSERT_TRUE(model.execute(workcell::SetPlacement{id, moved}));
  page.trigger("actionGoBack");
  EXPECT_EQ(model.document().find(id)->X_WE.p.x, before);
  page.trigger("actionUndo");
  EXPECT_EQ(model.document().find(id)->X_WE.p.x, moved.p.x);
}

TEST(Window, ThemesChangeAllColours) {
  WindowPage page;
  page.window().setTheme(false);
  WindowPage::settle();
  EXPECT_FALSE(themeOf(page.window().viewport().palette()).dark);
  page.window().setTheme(true);
  WindowPage::settle();
  EXPECT_TRUE(themeOf(page.window().viewport().palette()).dark);
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
