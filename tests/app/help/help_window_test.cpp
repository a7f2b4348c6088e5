// SPDX-License-Identifier: Apache-2.0
// Help, and names for screen readers.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

#include "app/help/help_pages.h"
#include "app/help/help_panel.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

TEST(Help, F1IsAboutThePanelThatHasTheFocusAndTheSceneIsToldInWords) {
  CellPage page;
  const auto id = page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1}), Pose::translation({0.25, 0, 0}));
  page.showDock("dockMove");
  page.window().activateWindow();
  EXPECT_TRUE(QTest::qWaitForWindowActive(&page.window(), 20000));
  page.find<ValueField>("fieldMoveX")->setFocus();
  QTest::keyClick(page.find<ValueField>("fieldMoveX"), Qt::Key_F1);
  CellPage::settle();
  auto* browser = page.find<QTextBrowser>("browserHelp");
  ASSERT_NE(browser, nullptr);
  EXPECT_TRUE(browser->toPlainText().contains("gizmo")) << browser->toPlainText().toStdString();
  page.select(id);
  page.trigger("actionSceneText");
  EXPECT_TRUE(browser->toPlainText().contains("Selected: box, at X 250.0 mm")) << browser->toPlainText().toStdString();
}

TEST(Help, IsAManualWithContentsSearchLinksAndTheWayBack) {
  CellPage page;
  page.trigger("actionManual");
  auto* panel = page.find<HelpPanel>("panelHelp");
  ASSERT_NE(panel, nullptr);
  EXPECT_EQ(panel->page(), "firstSteps");
  auto* contents = page.find<QTreeWidget>("treeHelp");
  EXPECT_EQ(contents->topLevelItemCount(), static_cast<int>(helpContents().size()));
  ASSERT_NE(contents->currentItem(), nullptr) << "the page is marked in the contents";

  auto* typed = page.find<QLineEdit>("fieldHelpSearch");
  QTest::keyClicks(typed, "swept cleaned noise");
  EXPECT_TRUE(contents->topLevelItem(0)->isHidden()) << "nothing has these words";
  typed->clear();
  QTest::keyClicks(typed, "hand tremor");
  QTest::keyClick(typed, Qt::Key_Return);
  CellPage::settle();
  EXPECT_EQ(panel->page(), "firstSteps") << "the first page that has the words";
  EXPECT_FALSE(page.find<QTextBrowser>("browserHelp")->extraSelections().isEmpty()) << "the words are marked";
  EXPECT_EQ(helpPagesWith("hand tremor", "en").size(), 2);
  QTest::keyClick(contents, Qt::Key_Down);
  QTest::keyClick(contents, Qt::Key_Down);
  CellPage::settle();
  EXPECT_EQ(panel->page(), "dockMotion");

  auto* back = page.find<QToolButton>("buttonHelpBack");
  ASSERT_TRUE(back->isEnabled());
  QTest::mouseClick(back, Qt::LeftButton);
  EXPECT_EQ(panel->page(), "firstSteps");
  auto* forward = page.find<QToolButton>("buttonHelpForward");
  ASSERT_TRUE(forward->isEnabled());
  QTest::mouseClick(forward, Qt::LeftButton);
  EXPECT_EQ(panel->page(), "dockMotion");
}

TEST(Help, ALinkOpensItsPageAndTheKeysAreTheUsersOwn) {
  CellPage page;
  page.trigger("actionManual");
  auto* panel = page.find<HelpPanel>("panelHelp");
  auto* browser = page.find<QTextBrowser>("browserHelp");
  ASSERT_NE(browser, nullptr);
  const QTextCursor link = browser->document()->find("Add a robot", QTextDocument::FindCaseSensitively);
  QTextCursor last;
  for (QTextCursor at = link; !at.isNull(); at = browser->document()->find("Add a robot", at))
    if (at.charFormat().isAnchor()) last = at;
  ASSERT_FALSE(last.isNull());
  browser->setTextCursor(last);
  browser->ensureCursorVisible();
  QTest::mouseClick(browser->viewport(), Qt::LeftButton, Qt::NoModifier,
                    browser->cursorRect(last).center() - QPoint(8, 0));
  CellPage::settle();
  EXPECT_EQ(panel->page(), "dockAddRobot");
  page.window().findChild<QAction*>("actionSave")->setShortcut(QKeySequence("Ctrl+Alt+9"));
  panel->showPage("keys");
  EXPECT_TRUE(browser->toPlainText().simplified().contains("Ctrl+Alt+9 Save")) << browser->toPlainText().toStdString();
}

TEST(Help, SpeaksTheWindowsLanguage) {
  const QLocale before;
  QLocale::setDefault(QLocale("fr"));  // As the window does that was started in French.
  CellPage page;
  page.trigger("actionManual");
  EXPECT_TRUE(page.find<QTextBrowser>("browserHelp")->toPlainText().startsWith("Premiers pas"));
  QLocale::setDefault(before);
}

/// Fields and buttons of a dock that a screen reader would not name.
QStringList nameless(const QWidget& dock) {
  QStringList found;
  for (QWidget* widget : dock.findChildren<QWidget*>()) {
    const bool told = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                      qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QLineEdit*>(widget) ||
                      qobject_cast<QAbstractItemView*>(widget);
    const bool part_of_another =
        widget->parentWidget() &&
        (qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) || qobject_cast<QComboBox*>(widget->parentWidget()) ||
         qobject_cast<QKeySequenceEdit*>(widget->parentWidget()) || qobject_cast<QLineEdit*>(widget->parentWidget()) ||
         widget->inherits("QComboBoxPrivateContainer") ||
         widget->parentWidget()->inherits("QComboBoxPrivateContainer") ||
         qobject_cast<QAbstractItemView*>(widget->parentWidget()));
    if (!told || part_of_another) continue;
    QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    const auto* line = qobject_cast<QLineEdit*>(widget);
    const bool named =
        (face && !face->text(QAccessible::Name).isEmpty()) || (line && !line->placeholderText().isEmpty());
    if (!named) found << QStringLiteral("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
  }
  return found;
}

TEST(ScreenReader, FindsANameOnEveryFieldOfTheWindowsOwnDocks) {
  CellPage page;
  page.trigger("actionSettings");
  page.select(page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1})));
  for (const char* dock : {"dockMove", "dockMeasure", "dockSolid", "dockProperties", "dockSettings"}) {
    const QStringList found = nameless(*page.find<QDockWidget>(dock));
    EXPECT_TRUE(found.isEmpty()) << dock << ": " << found.join(", ").toStdString();
  }
}

}  // namespace
}  // namespace hapticell::app
