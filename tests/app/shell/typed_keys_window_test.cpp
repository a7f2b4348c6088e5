// SPDX-License-Identifier: Apache-2.0
// Letters are commands over the scene and text everywhere else; Escape is heard from everywhere.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QDialog>
#include <QListView>
#include <QMenu>
#include <QPointer>
#include <QTreeView>

#include "app/kit/typed_key.h"
#include "app/kit/switch_list.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

config::Configuration withoutServer() {
  config::Configuration configuration;
  configuration.server.port = 47481;  // No server answers there: forces stay off.
  configuration.server.host = "192.0.2.1";
  return configuration;
}

struct TypingPage : CellPage {
  TypingPage() : CellPage(withoutServer()) {
    window().resize(1380, 860);
    part = addSolid("part", geometry::makeBox(dvec3(0.06)));
    window().loadModules(ModuleLoader::defaultFolders());
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    select(part);
    window().setUpdatesEnabled(false);  // The keys are what is looked at; each would put the whole window together.
    settle();
  }
  /// Everything a misfired key would change.
  QString state() {
    QStringList words;
    words << QString::number(document().state().entities.size()) << QString::fromStdString(document().undoText())
          << QString::fromStdString(document().redoText());
    words << (window().recording().isRecording() ? "records" : "rests");
    for (const char* name : {"actionSelect", "actionMove", "actionRotate", "actionSideDocks", "actionSection"})
      words << QString::number(find<QAction>(name)->isChecked());
    for (const char* axis : {"freeX", "freeY", "freeZ", "freeA", "freeB", "freeC"})
      words << QString::number(find<QAbstractButton>(axis)->isChecked());
    words << QString::number(find<Segmented>("segmentsScale")->current());
    words << QString::number(find<Segmented>("segmentsOnContact")->current());
    words << find<QWidget>("pillForces")->property("checked").toString();
    return words.join(' ');
  }
  bool waitsForText(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || widget->inherits("QTextEdit") ||
           widget->inherits("QAbstractSpinBox") || widget->inherits("QKeySequenceEdit") ||
           widget->inherits("QPlainTextEdit");
  }
  void closePopups() {
    while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    settle();
  }
  workcell::EntityId part = 0;
};

TEST(TypedKeys, ASentenceTypedIntoAnyPanelChangesNothing) {
  TypingPage page;
  for (const char* opens : {"actionAddRobot", "actionTools", "actionMechanism", "actionMeasure", "actionMoveBy",
                            "actionSettings", "actionMarkers", "actionMotionPanel", "actionTraining", "actionHelp"})
    page.trigger(opens);
  page.press("buttonAddSet");
  page.activate();
  const QString before = page.state();
  int panels = 0, typed = 0;
  for (QDockWidget* dock : page.window().findChildren<QDockWidget*>()) {
    dock->setFloating(false);  // One window has the keys.
    page.showDock(dock->objectName().toLatin1());
    ++panels;
    QCursor::setPos(dock->mapToGlobal(dock->rect().center()));
    page.settle();
    QList<QPointer<QWidget>> places{dock->widget()};
    int buttons = 0;
    for (QWidget* child : dock->findChildren<QWidget*>()) {
      const bool takes = child->isVisible() && child->isEnabled() && child->focusPolicy() != Qt::NoFocus;
      if (!takes || page.waitsForText(child)) continue;
      if (qobject_cast<QAbstractButton*>(child) && ++buttons > 2) continue;  // One is as another.
      places << child;
    }
    for (const QPointer<QWidget>& place : places) {
      if (!place || !place->isVisible()) continue;  // The one before may have taken it away.
      const QString name = dock->objectName() + '/' + place->metaObject()->className() + '/' + place->objectName();
      if (place == dock->widget())
        page.window().viewport().setFocus();  // Pointed at, but something else has the focus.
      else
        place->setFocus();
      page.typeText("wer6gdqxckvb");
      if (place != dock->widget() && dock->objectName() != "dockWorkcell")  // In the tree it removes what is chosen.
        QTest::keyClick(page.window().windowHandle(), Qt::Key_Delete);
      page.closePopups();
      for (QLineEdit* field : dock->findChildren<QLineEdit*>())
        if (field->property("search").toBool()) field->clear();
      ++typed;
      ASSERT_EQ(page.state().toStdString(), before.toStdString()) << name.toStdString();
    }
  }
  EXPECT_GT(panels, 20);
  EXPECT_GT(typed, 80);
}

TEST(TypedKeys, ALetterIsACommandOverTheSceneOnly) {
  TypingPage page;
  page.showDock("dockMessages");
  auto* dock = page.find<QDockWidget>("dockMessages");
  page.window().viewport().setFocus();
  page.pointAt(*dock);
  QCursor::setPos(dock->mapToGlobal(dock->rect().center()));
  page.typeText("w");
  EXPECT_FALSE(page.find<QAction>("actionMove")->isChecked());
  page.pointAt(page.window().viewport());
  page.typeText("w");
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked());
}

TEST(TypedKeys, ANumberThatWasEnteredLeavesLettersToTheScene) {
  TypingPage page;
  page.showDock("dockMove");
  auto* field = page.find<ValueField>("fieldMoveX");
  page.activate();
  page.type("fieldMoveX", "25");
  page.pointAt(page.window().viewport());
  QTest::keyClicks(field, "1");
  QTest::keyClick(field, Qt::Key_W);
  EXPECT_FALSE(page.find<QAction>("actionMove")->isChecked()) << "half a number is in the field";
  QTest::keyClick(field, Qt::Key_Return);
  QTest::keyClick(field, Qt::Key_W);
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked());
  QTest::keyClicks(field, "40");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(field->value(), 40.0) << "the next number goes into the field";
}

TEST(TypedKeys, WhatCannotBeSeenToHappenNeedsCtrl) {
  TypingPage page;
  for (const char* name : {"actionGoBack", "actionForcesOn"}) {
    const QKeySequence key = page.find<QAction>(name)->shortcut();
    ASSERT_FALSE(key.isEmpty()) << name;
    EXPECT_FALSE(isTypedKey(key[0].key(), key[0].keyboardModifiers())) << name;
  }
}

TEST(TypedKeys, TypingFindsARobotAtOnce) {
  TypingPage page;
  page.window().setUpdatesEnabled(true);  // A list that is never painted is laid out again with every question to it.
  page.trigger("actionAddRobot");
  page.typeText("kr6");
  EXPECT_EQ(page.find<QLineEdit>("searchLibrary")->text(), "kr6");
  page.find<QLineEdit>("searchLibrary")->clear();
  auto* list = page.find<QListView>("listLibrary");
  list->setFocus();
  page.pointAt(*list->viewport());
  page.typeText("kr16");
  EXPECT_EQ(page.find<QLineEdit>("searchLibrary")->text(), "kr16") << "from the list too";
  EXPECT_FALSE(page.window().recording().isRecording());
}

TEST(TypedKeys, TheStylusThatHoldsAPartIsInTheSceneWhereverThePointerIs) {
  TypingPage page;
  page.activate();
  page.showDock("dockVirtualDesktop");
  auto* dock = page.find<QDockWidget>("dockVirtualDesktop");
  QCursor::setPos(dock->mapToGlobal(dock->rect().center()));
  page.settle();
  page.window().viewport().setFocus();
  EXPECT_FALSE(page.window().typedKeysAct());
  manipulation::SceneSnapshot snapshot;
  snapshot.stylus.held = page.part;
  page.window().setSnapshot(snapshot);
  EXPECT_TRUE(page.window().typedKeysAct());
  page.find<QTreeView>("treeWorkcell")->setFocus();
  EXPECT_FALSE(page.window().typedKeysAct()) << "a list searches";
}

TEST(TypedKeys, ADoubleClickOnAPairSetsNameRenamesIt) {
  TypingPage page;
  page.showDock("dockCollisions");
  page.press("buttonAddSet");
  auto* list = page.find<SwitchList>("pairSets");
  QTest::mouseDClick(list, Qt::LeftButton, {}, QPoint(90, 12));
  page.typeText("wer gdr");
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Return);
  page.settle();
  ASSERT_EQ(page.document().state().pair_sets.size(), 1u);
  EXPECT_EQ(page.document().state().pair_sets[0].name, "wer gdr");
  EXPECT_TRUE(page.document().state().pair_sets[0].enabled);
  QTest::keyClick(page.window().windowHandle(), Qt::Key_F2);
  page.typeText("other");
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Escape);
  page.settle();
  EXPECT_EQ(page.document().state().pair_sets[0].name, "wer gdr");
}

TEST(TypedKeys, DeleteRemovesAPartFromTheSceneAndTheTreeOnly) {
  TypingPage page;
  page.pointAt(page.window().viewport());
  page.showDock("dockHistory");
  page.activate();
  page.find<QAbstractItemView>("listHistory")->setFocus();
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Delete);
  page.settle();
  EXPECT_EQ(page.entities(), 1u) << "the list has the focus, though the pointer is over the scene";
  page.find<QTreeView>("treeWorkcell")->setFocus();
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Delete);
  page.settle();
  EXPECT_EQ(page.entities(), 0u);
}

TEST(EscapeKey, EndsAPickWhereverTheFocusIs) {
  TypingPage page;
  page.activate();
  for (const char* focus : {"treeWorkcell", "fieldFilter", "comboEntity"}) {
    bool answered = false;
    page.window().viewport().startPick({{}, "Pick", [&](const auto& feature) { answered = !feature; }});
    page.find<QWidget>(focus)->setFocus();
    QTest::keyClick(page.window().windowHandle(), Qt::Key_Escape);
    page.settle();
    EXPECT_TRUE(answered) << focus;
    EXPECT_FALSE(page.window().viewport().isPicking());
  }
}

TEST(EscapeKey, ClosesWhatIsOnTopOneThingAPress) {
  TypingPage page;
  const auto escape = [&] {
    QWidget* window = QApplication::activeWindow();
    ASSERT_NE(window, nullptr);
    QTest::keyClick(window->windowHandle(), Qt::Key_Escape);
    page.settle();
  };
  page.trigger("actionMove");
  page.trigger("actionManual");
  page.activate();
  auto* help = page.find<QDockWidget>("dockHelp");
  auto* search = page.find<QLineEdit>("fieldHelpSearch");
  auto* finder = page.find<QWidget>("commandFinder");
  auto* start = page.find<QWidget>("startPage");
  page.trigger("actionFirstPage");
  search->setFocus();
  QTest::keyClicks(search, "tcp");
  page.trigger("actionFindCommand");
  ASSERT_TRUE(finder->isVisible());
  escape();
  EXPECT_FALSE(finder->isVisible()) << "the finder is over all";
  EXPECT_EQ(search->text(), "tcp");
  ASSERT_TRUE(search->hasFocus()) << "where it was before";
  escape();
  EXPECT_EQ(search->text(), "") << "then what was typed";
  EXPECT_TRUE(start->isVisible());
  escape();
  EXPECT_FALSE(start->isVisible()) << "then the first page";
  EXPECT_TRUE(help->isVisible());
  escape();
  EXPECT_FALSE(help->isVisible()) << "then the help, which has the focus";
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked());
  escape();
  EXPECT_TRUE(page.find<QAction>("actionSelect")->isChecked()) << "then the tool";
}

TEST(EscapeKey, TakesBackATypedNumber) {
  TypingPage page;
  page.showDock("dockMove");
  page.trigger("actionMove");
  page.activate();
  auto* field = page.find<ValueField>("fieldMoveX");
  const QString before = field->text();
  int edited = 0;
  QObject::connect(field, &ValueField::edited, [&] { ++edited; });
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "123");
  ASSERT_NE(field->text(), before);
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Escape);
  page.settle();
  EXPECT_EQ(field->text(), before);
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked()) << "one thing a press";
  page.window().viewport().setFocus();
  page.settle();
  EXPECT_EQ(edited, 0);
}

TEST(EscapeKey, ClosesMenusDialogsAndFloatingPanels) {
  TypingPage page;
  page.trigger("actionMove");
  page.activate();
  auto* menu = page.find<QMenu>("menuView");
  menu->popup(page.window().mapToGlobal(QPoint(200, 200)));
  page.settle();
  QTest::keyClick(menu, Qt::Key_Escape);
  page.settle();
  EXPECT_FALSE(menu->isVisible());
  page.trigger("actionAbout");
  QPointer<QDialog> about = page.find<QDialog>("dialogAbout");
  ASSERT_TRUE(about && about->isVisible());
  QTest::keyClick(about.data(), Qt::Key_Escape);
  page.settle();
  EXPECT_TRUE(!about || !about->isVisible());
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked()) << "the tool is below them";
  page.trigger("actionSelect");
  page.trigger("actionSettings");
  auto* settings = page.find<QDockWidget>("dockSettings");
  ASSERT_TRUE(WindowPage::until([&] { return settings->isActiveWindow(); }, 30000));
  QTest::keyClick(settings->windowHandle(), Qt::Key_Escape);
  page.settle();
  EXPECT_FALSE(settings->isVisible());
}

TEST(EscapeKey, ClosesWhatIsOnTopWhereverTheFocusIs) {
  TypingPage page;
  page.trigger("actionMove");
  page.trigger("actionFirstPage");
  page.activate();
  page.find<QTreeView>("treeWorkcell")->setFocus();
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Escape);
  page.settle();
  EXPECT_FALSE(page.find<QWidget>("startPage")->isVisible());
  EXPECT_TRUE(page.find<QAction>("actionMove")->isChecked()) << "one thing a press";
  QTest::keyClick(page.window().windowHandle(), Qt::Key_Escape);
  page.settle();
  EXPECT_TRUE(page.find<QAction>("actionSelect")->isChecked());
}

}  // namespace
}  // namespace hapticell::app
