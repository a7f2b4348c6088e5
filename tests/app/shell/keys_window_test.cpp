// SPDX-License-Identifier: Apache-2.0
// The keys of the left hand, as real key events, with the Virtual Desktop running.
#include <gtest/gtest.h>

#include <QListWidget>
#include <algorithm>
#include <set>

#include "app/kit/command_finder.h"
#include "app/kit/command_list.h"
#include "app/style/dock_title_bar.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

config::Configuration onUnusedPort() {
  config::Configuration configuration;
  configuration.server.port = 47481;  // No server answers there: forces stay off.
  configuration.server.host = "192.0.2.1";
  return configuration;
}

struct KeysPage : CellPage {
  KeysPage() : CellPage(onUnusedPort()) {
    part = addSolid("part", geometry::makeBox(dvec3(0.06)));
    window().loadModules(ModuleLoader::defaultFolders());
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    select(part);
    auto* entity = find<QComboBox>("comboEntity");
    entity->setCurrentIndex(entity->findText("part"));
    emit entity->activated(entity->currentIndex());
    window().activateWindow();
    window().viewport().setFocus();
    settle();
  }
  std::string free() {
    std::string text;
    for (const char* axis : {"freeX", "freeY", "freeZ", "freeA", "freeB", "freeC"})
      if (find<QAbstractButton>(axis)->isChecked()) text += axis[4];
    return text;
  }
  workcell::EntityId part = 0;
};

TEST(Keys, TheScaleIsChosenByOneToFour) {
  KeysPage page;
  auto* scale = page.find<Segmented>("segmentsScale");
  for (const auto& [key, index] : {std::pair{Qt::Key_3, 2}, {Qt::Key_1, 0}, {Qt::Key_4, 3}, {Qt::Key_2, 1}}) {
    page.key(key);
    EXPECT_EQ(scale->current(), index);
  }
}

TEST(Keys, CGoesThroughStopSlidePassAndTheDocumentKnows) {
  KeysPage page;
  auto* on_contact = page.find<Segmented>("segmentsOnContact");
  EXPECT_EQ(on_contact->current(), 1);
  page.key(Qt::Key_C);
  EXPECT_EQ(on_contact->current(), 2);
  EXPECT_EQ(page.document().find(page.part)->contact.on_contact, workcell::OnContact::kPass);
  page.key(Qt::Key_C);
  EXPECT_EQ(on_contact->current(), 0);
  page.trigger("actionUndo");
  EXPECT_EQ(on_contact->current(), 2) << "an undo counts here too";
}

TEST(Keys, XYZFreeOneAxisThenItsTurnThenAll) {
  KeysPage page;
  EXPECT_EQ(page.free(), "XYZABC");
  page.key(Qt::Key_Y);
  EXPECT_EQ(page.free(), "Y");
  page.key(Qt::Key_Y);
  EXPECT_EQ(page.free(), "B");
  page.key(Qt::Key_Y);
  EXPECT_EQ(page.free(), "XYZABC");
  page.key(Qt::Key_X);
  page.key(Qt::Key_Z);
  EXPECT_EQ(page.free(), "Z");
  page.press("freeX");
  EXPECT_EQ(page.free(), "XZ");
}

TEST(Keys, LettersAreTextWhileAFieldHasTheFocus) {
  KeysPage page;
  page.showDock("dockCollisions");
  auto* filter = page.find<QLineEdit>("filterPairs");
  filter->setFocus();
  QTest::keyClicks(filter, "xc1");
  WindowPage::settle();
  EXPECT_EQ(filter->text(), "xc1");
  EXPECT_EQ(page.free(), "XYZABC");
  EXPECT_EQ(page.find<Segmented>("segmentsScale")->current(), 1);
}

TEST(Keys, TheForceClassOfTheEntityIsOneWhereverItIsChosen) {
  KeysPage page;
  page.chooseSegment("segmentsForce", 2);
  EXPECT_EQ(page.document().find(page.part)->contact.force_class, workcell::ForceClass::kDynamics);
  page.window().documentModel().execute(
      workcell::SetProperties{.id = page.part, .force_class = workcell::ForceClass::kConstant});
  WindowPage::settle();
  EXPECT_EQ(page.find<Segmented>("segmentsForce")->current(), 0);
}

TEST(Keys, CtrlKFindsACommandByAFewLettersAndEnterDoesIt) {
  KeysPage page;
  page.activate();
  QTest::keyClick(&page.window(), Qt::Key_K, Qt::ControlModifier);
  WindowPage::settle();
  auto* typed = page.find<QLineEdit>("fieldCommand");
  ASSERT_TRUE(typed->isVisible());
  QTest::keyClicks(typed, "remove fr");
  QTest::keyClick(typed, Qt::Key_Return);
  WindowPage::settle();
  EXPECT_FALSE(typed->isVisible());
  EXPECT_EQ(page.entities(), 0u) << "\"Remove from the cell\" was done";
}

/// What a user sees in a dock and can click, as it is written there.
std::vector<QAbstractButton*> clickable(const QDockWidget& dock) {
  std::vector<QAbstractButton*> found;
  for (QAbstractButton* button : dock.findChildren<QAbstractButton*>())
    if (button->isVisibleTo(&dock) && button->isEnabled() && !button->text().isEmpty() &&
        !qobject_cast<DockTitleBar*>(button->parentWidget()))
      found.push_back(button);
  return found;
}

TEST(CommandFinder, FindsEveryButtonOfEveryDockByItsText) {
  KeysPage page;
  page.activate();
  page.window().setUpdatesEnabled(false);  // Texts are what is looked for.
  page.trigger("actionSettings");
  page.trigger("actionManual");
  page.trigger("actionFindCommand");
  auto* typed = page.find<QLineEdit>("fieldCommand");
  auto* list = page.find<QListWidget>("listCommands");
  int looked_for = 0;
  QSet<QString> docks;
  for (QDockWidget* dock : page.window().findChildren<QDockWidget*>()) {
    const std::vector<Command> commands = commandsNow(page.window());
    const auto has = [&](const QObject* target) {
      return std::any_of(commands.begin(), commands.end(), [&](const Command& c) { return c.target == target; });
    };
    EXPECT_TRUE(has(dock)) << dock->objectName().toStdString() << " itself";
    docks << dock->objectName();
    for (QAbstractButton* button : clickable(*dock)) {
      EXPECT_TRUE(has(button)) << dock->objectName().toStdString() << ": " << button->text().toStdString();
      const QString words = QString(button->text()).remove('&').remove(QChar(0x2026)).simplified();
      typed->setText(words);
      EXPECT_FALSE(list->findItems(words + "  ·  ", Qt::MatchStartsWith).isEmpty()) << words.toStdString();
      ++looked_for;
    }
  }
  EXPECT_GT(looked_for, 60);
  for (const char* dock : {"dockSettings", "dockHelp", "dockMotion", "dockVirtualDesktop", "dockCollisions"})
    EXPECT_TRUE(docks.contains(dock)) << dock;
}

TEST(CommandFinder, ShowsAButtonWhereItIsAndClicksIt) {
  KeysPage page;
  page.activate();
  page.find<QDockWidget>("dockSolid")->hide();
  page.trigger("actionFindCommand");
  auto* typed = page.find<QLineEdit>("fieldCommand");
  QTest::keyClicks(typed, "locked solid");
  QTest::keyClick(typed, Qt::Key_Return);
  WindowPage::settle();
  EXPECT_TRUE(page.find<QDockWidget>("dockSolid")->isVisible());
  EXPECT_TRUE(page.document().find(page.part)->locked);
}

TEST(CommandFinder, FindsASettingByItsNameAndAPanelByItsTitle) {
  KeysPage page;
  page.activate();
  page.trigger("actionFindCommand");
  auto* typed = page.find<QLineEdit>("fieldCommand");
  QTest::keyClicks(typed, "foam: friction");
  QTest::keyClick(typed, Qt::Key_Return);
  WindowPage::settle();
  auto* field = page.window().findChild<QWidget*>("setting.materials.foam.friction");
  ASSERT_NE(field, nullptr);
  EXPECT_TRUE(field->isVisible()) << "its page is chosen, its dock is open";
  page.find<QDockWidget>("dockSettings")->hide();
  page.find<QDockWidget>("dockHistory")->hide();
  page.activate();
  page.trigger("actionFindCommand");
  QTest::keyClicks(typed, "history");
  QTest::keyClick(typed, Qt::Key_Return);
  WindowPage::settle();
  EXPECT_TRUE(page.find<QDockWidget>("dockHistory")->isVisible());
}

/// "path" begins a word of the command, of its panel and of a setting alike.
TEST(CommandFinder, CommandsAndPanelsComeBeforeWhatPanelsHold) {
  KeysPage page;
  page.activate();
  page.trigger("actionSettings");
  page.trigger("actionFindCommand");
  page.find<QLineEdit>("fieldCommand")->setText("path");
  auto* list = page.find<QListWidget>("listCommands");
  int of_panels = 0;
  for (int row = 0; row < list->count(); ++row) {
    const QString words = list->item(row)->text();
    const bool is_setting = words.endsWith("  ·  Settings");
    of_panels += is_setting ? 1 : 0;
    EXPECT_FALSE(words.contains("Plan a path") && !words.contains("  ·  Plan a path") && of_panels > 0) << words.toStdString();
    EXPECT_FALSE(words.startsWith("Float  ·  ") || words.startsWith("Close  ·  ")) << "Qt's own title bar";
  }
  EXPECT_GT(of_panels, 0);
  EXPECT_FALSE(list->findItems("Plan a path", Qt::MatchStartsWith).isEmpty());
}

TEST(Keys, LettersApartAreFoundButWholeWordsFirst) {
  EXPECT_GT(CommandFinder::match("fit", "Fit all"), CommandFinder::match("fit", "Best fit"));
  EXPECT_GT(CommandFinder::match("fit", "Best fit"), CommandFinder::match("fit", "Profit"));
  EXPECT_GT(CommandFinder::match("ftal", "Fit all"), 0);
  EXPECT_EQ(CommandFinder::match("xyz", "Fit all"), 0);
}

TEST(Keys, QuestionMarkShowsTheKeysUntilTheNextOne) {
  KeysPage page;
  page.key(Qt::Key_Question, Qt::ShiftModifier);
  auto* overlay = page.find<QWidget>("keyOverlay");
  ASSERT_TRUE(overlay->isVisible());
  page.key(Qt::Key_3);
  EXPECT_FALSE(overlay->isVisible());
  EXPECT_EQ(page.find<Segmented>("segmentsScale")->current(), 2) << "the key did its own work too";
}

TEST(Keys, F6GoesRoundThePanelsAndComesBackToTheScene) {
  KeysPage page;
  std::set<QWidget*> docks;
  int steps = 0;
  do {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
    WindowPage::settle();
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    for (QDockWidget* dock : page.window().findChildren<QDockWidget*>())
      if (dock->isAncestorOf(QApplication::focusWidget())) docks.insert(dock);
  } while (QApplication::focusWidget() != &page.window().viewport() && ++steps < 20);
  EXPECT_LT(steps, 20);
  EXPECT_GE(docks.size(), 3u);
}

}  // namespace
}  // namespace hapticell::app
