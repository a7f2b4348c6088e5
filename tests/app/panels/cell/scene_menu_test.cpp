// SPDX-License-Identifier: Apache-2.0
// The right button's menu in the scene, by real events.
#include <gtest/gtest.h>

#include <QMenu>
#include <QTreeView>

#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

/// Two boxes side by side on x, seen from the front above.
struct MenuPage : CellPage {
  MenuPage() {
    window().resize(1500, 900);
    settle();
    left = addSolid("left", geometry::makeBox({0.1, 0.1, 0.1}));
    right = addSolid("right", geometry::makeBox({0.1, 0.1, 0.1}), Pose::translation({0.4, 0, 0}));
    lookAt({0.2, 0, 0}, 0.35);
    activate();
  }
  ~MenuPage() { close(); }
  void close() {
    while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    settle();
  }
  /// The right button at a point of the cell, drawn aside by so many pixels before it is let go.
  void rightClick(const dvec3& p_W, double aside = 0.0) {
    close();
    ViewportWidget& viewport = window().viewport();
    const auto pixel =
        viewport.camera().project(p_W, {static_cast<double>(viewport.width()), static_cast<double>(viewport.height())});
    ASSERT_TRUE(pixel.has_value());
    const QPointF place(pixel->x, pixel->y), end = place + QPointF(aside, 0.0);
    const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButtons held) {
      const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::RightButton;
      QMouseEvent event(type, at, viewport.mapToGlobal(at), button, held, Qt::NoModifier);
      QApplication::sendEvent(&viewport, &event);
    };
    send(QEvent::MouseButtonPress, place, Qt::RightButton);
    send(QEvent::MouseMove, end, Qt::RightButton);
    send(QEvent::MouseButtonRelease, end, Qt::NoButton);
    settle();
  }
  QMenu* menu() {
    auto* open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    return open && open->objectName() == "menuScene" ? open : nullptr;
  }
  void choose(const char* name) {
    ASSERT_NE(menu(), nullptr) << name;
    QAction* action = nullptr;
    for (QAction* one : menu()->actions())
      if (one->objectName() == name) action = one;
    ASSERT_NE(action, nullptr) << name;
    ASSERT_TRUE(action->isEnabled()) << name;
    QTest::mouseClick(menu(), Qt::LeftButton, Qt::NoModifier, menu()->actionGeometry(action).center());
    settle();
  }
  workcell::EntityId left = 0, right = 0;
};

constexpr dvec3 kOnLeft{0, 0, 0.05}, kOnRight{0.4, 0, 0.05}, kFloor{0.2, -0.25, 0};

TEST(SceneMenu, AClickOnAPartChoosesItAndOffersWhatTheTreeOffers) {
  MenuPage page;
  page.rightClick(kOnLeft);
  ASSERT_NE(page.menu(), nullptr);
  EXPECT_EQ(page.window().selection().all(), std::vector{page.left});
  QStringList offered;
  for (const QAction* action : page.menu()->actions()) offered << action->objectName();
  for (const char* name : {"treeFit", "treeShow", "treeIsolate", "treeLock", "treeCheck", "treeDetach", "treeRename",
                           "treeDuplicate", "treeRemove", "treeProperties"})
    EXPECT_TRUE(offered.contains(name)) << name;
  page.choose("treeLock");
  EXPECT_TRUE(page.document().find(page.left)->locked);
  page.rightClick(kOnLeft);
  page.choose("treeCheck");
  EXPECT_FALSE(page.document().find(page.left)->checked);
}

TEST(SceneMenu, ADragOfTheRightButtonOpensNone) {
  MenuPage page;
  page.rightClick(kOnLeft, 40.0);
  EXPECT_EQ(page.menu(), nullptr);
}

TEST(SceneMenu, IsAboutAllThatAreChosenWhereOneOfThemIsPointedAt) {
  MenuPage page;
  page.window().selection().setAll({page.left, page.right}, page.left);
  page.rightClick(kOnRight);
  page.choose("treeShow");
  EXPECT_FALSE(page.document().find(page.left)->visible);
  EXPECT_FALSE(page.document().find(page.right)->visible);
}

TEST(SceneMenu, APartIsAttachedAndDetached) {
  MenuPage page;
  page.rightClick(kOnRight);
  auto* carriers = page.menu()->findChild<QMenu*>("treeAttach");
  ASSERT_NE(carriers, nullptr);
  ASSERT_EQ(carriers->actions().size(), 1);
  EXPECT_EQ(carriers->actions().front()->text(), "left");
  carriers->actions().front()->trigger();
  page.settle();
  EXPECT_EQ(page.document().find(page.right)->attachment.to, "left");
  page.rightClick(kOnRight);
  page.choose("treeDetach");
  EXPECT_TRUE(page.document().find(page.right)->attachment.to.empty());
}

TEST(SceneMenu, ThePairsAndSetsOfAPartAreOneEntryAway) {
  MenuPage page;
  page.prepareScene();
  page.find<Segmented>("segmentsCollisions")->setCurrent(2);
  page.rightClick(kOnRight);
  page.choose("treePairs");
  auto* dock = page.find<QDockWidget>("dockCollisions");
  EXPECT_TRUE(dock->isVisible());
  EXPECT_EQ(page.window().selection().current(), page.right);
  EXPECT_EQ(page.find<Segmented>("segmentsCollisions")->current(), 0);
  auto* pairs = page.find<QTableView>("tablePairs");
  ASSERT_TRUE(MenuPage::until([&] { return pairs->model()->rowCount() == 1; }, 20000)) << "against the left one";
  EXPECT_TRUE(pairs->isVisible());
}

TEST(SceneMenu, RenamingIsDoneInTheTree) {
  MenuPage page;
  page.find<QLineEdit>("fieldFilter")->setText("right");
  page.rightClick(kOnLeft);
  page.choose("treeRename");
  page.typeText("wheel");
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Return);
  page.settle();
  EXPECT_EQ(page.document().find(page.left)->name, "wheel");
}

TEST(SceneMenu, TheFloorTakesWhatWasCopied) {
  MenuPage page;
  page.select(page.left);
  page.trigger("actionCopy");
  page.rightClick(kFloor);
  ASSERT_NE(page.menu(), nullptr);
  EXPECT_NE(page.menu()->findChild<QMenu*>("floorInsert"), nullptr);
  page.choose("floorPaste");
  ASSERT_EQ(page.entities(), 3u);
  const workcell::Entity* pasted = page.document().find(page.window().selection().current());
  ASSERT_NE(pasted, nullptr);
  EXPECT_NEAR(pasted->X_WE.p.x, kFloor.x, 0.02);
  EXPECT_NEAR(pasted->X_WE.p.y, kFloor.y, 0.02);
  EXPECT_EQ(pasted->X_WE.p.z, 0.0) << "as high as it stood";
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 2u) << "one step";
  page.trigger("actionRemove");
  page.trigger("actionPaste");
  EXPECT_EQ(page.entities(), 3u) << "what was copied outlives its original";
}

TEST(SceneMenu, EndsAPickInsteadWhileThereIsOne) {
  MenuPage page;
  bool ended = false;
  page.window().viewport().startPick({{}, "Pick", [&](const auto& feature) { ended = !feature; }});
  page.rightClick(kOnLeft);
  EXPECT_TRUE(ended);
  EXPECT_EQ(page.menu(), nullptr);
}

}  // namespace
}  // namespace hapticell::app
