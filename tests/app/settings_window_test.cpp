// SPDX-License-Identifier: Apache-2.0
// Settings, layouts, first page, views and help by real events.
#include <gtest/gtest.h>

#include <QAccessible>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QStyleOption>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>

#include "app/help/help_pages.h"
#include "app/help/help_panel.h"
#include "app/host/user_settings.h"
#include "app/panels/dock_front.h"
#include "app/panels/swatch_row.h"
#include "app/settings/configuration_fields.h"
#include "app/settings/gesture_field.h"
#include "app/start/recent_files.h"
#include "app/start/start_page.h"
#include "app/style/units.h"
#include "tests/app/cell_page.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

class SettingsPage : public CellPage {
 public:
  SettingsPage() { trigger("actionSettings"); }
  ~SettingsPage() { setUnitsNow({}); }
  void page(int row) {
    find<QListWidget>("listSettings")->setCurrentRow(row);
    settle();
  }
  /// Chooses in a combo box as the arrow keys do.
  void choose(const char* name, int index) {
    auto* combo = find<QComboBox>(name);
    combo->setFocus();
    while (combo->currentIndex() < index) QTest::keyClick(combo, Qt::Key_Down);
    while (combo->currentIndex() > index) QTest::keyClick(combo, Qt::Key_Up);
    settle();
  }
  UserSettings& settings() { return window().userSettings(); }
};

TEST(FeelAndFiles, EverySettingHasAFieldWithAPlainName) {
  const QStringList on_appearance{"gui.theme", "gui.motion", "gui.original_colors"};
  QStringList named;
  for (const ConfigurationGroup& group : configurationGroups({}))
    for (const ConfigurationField& field : group.fields) {
      named << QString::fromStdString(field.key);
      EXPECT_FALSE(field.name.contains('_') || field.name.contains('.')) << field.name.toStdString();
    }
  SettingsPage page;
  page.page(4);
  for (const config::Setting& setting : config::settings({})) {
    const QString key = QString::fromStdString(setting.key);
    EXPECT_NE(named.count(key) == 1, on_appearance.contains(key)) << setting.key;
    EXPECT_TRUE(on_appearance.contains(key) || page.window().findChild<QWidget*>("setting." + key)) << setting.key;
  }
}

TEST(FeelAndFiles, WhatIsChangedIsInTheUsersFileInItsOwnUnits) {
  QTemporaryDir folder;
  const QByteArray before = qgetenv("XDG_CONFIG_HOME");
  qputenv("XDG_CONFIG_HOME", folder.path().toLocal8Bit());
  SettingsPage page;
  page.page(4);
  auto* near_miss = page.find<ValueField>("setting.manipulation.near_miss");
  EXPECT_NEAR(near_miss->value(), 10.0, 1e-9) << "millimetres";
  near_miss->setFocus();
  near_miss->selectAll();
  QTest::keyClicks(near_miss, "25");
  QTest::keyClick(near_miss, Qt::Key_Return);
  QTest::mouseClick(page.find<QCheckBox>("setting.robot.self_collision"), Qt::LeftButton, Qt::NoModifier, QPoint(8, 8));
  page.choose("setting.manipulation.on_contact", 0);
  EXPECT_EQ(page.find<QComboBox>("setting.manipulation.on_contact")->currentText(), "Stop");
  CellPage::settle();
  const auto read = config::readConfiguration(folder.filePath("hapticell/hapticell.toml").toStdString());
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_NEAR(read->manipulation.near_miss, 0.025, 1e-12);
  EXPECT_FALSE(read->robot.self_collision);
  EXPECT_EQ(read->manipulation.on_contact, "stop");
  EXPECT_TRUE(page.find<QLabel>("labelSettingsNote")->text().contains("next start"));
  QTest::keyClicks(page.find<QLineEdit>("fieldConfigurationFilter"), "foam");
  EXPECT_TRUE(near_miss->isHidden() || !near_miss->isVisible());
  EXPECT_TRUE(page.find<ValueField>("setting.materials.foam.friction")->isVisible());
  before.isNull() ? qunsetenv("XDG_CONFIG_HOME") : qputenv("XDG_CONFIG_HOME", before);
}

TEST(PartColor, AnyCanBeChosenAndIsOneStepOfUndo) {
  CellPage page;
  const auto id = page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1}));
  page.select(id);
  page.showDock("dockSolid");
  const auto color = [&] { return page.window().documentModel().document().find(id)->color; };
  const auto drawn = [&] { return page.window().viewport().scene().items({}).front().color; };
  const auto before = color();
  auto* swatches = page.find<SwatchRow>("swatchSolid");
  QTest::keyClick(swatches, Qt::Key_Return);
  CellPage::settle();
  auto* dialog = page.find<QColorDialog>("dialogColor");
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->testOption(QColorDialog::DontUseNativeDialog)) << "in the window's theme";
  dialog->setCurrentColor(QColor("#d02010"));
  QTest::keyClick(dialog, Qt::Key_Return);
  CellPage::settle();
  EXPECT_NEAR(color()[0], 0xd0 / 255.0, 1e-3);
  EXPECT_NEAR(color()[2], 0x10 / 255.0, 1e-3);
  EXPECT_GT(drawn()[2], 0.5F) << "quiet, so that contacts are loud";
  ASSERT_FALSE(page.window().messages().messages().empty());
  EXPECT_TRUE(page.window().messages().messages().back().title.contains("quieter colour"));
  page.window().userSettings().setValue("colors/full", true);
  EXPECT_NEAR(drawn()[2], 0x10 / 255.0, 1e-3);
  page.window().userSettings().setValue("colors/full", false);
  EXPECT_GT(drawn()[2], 0.5F);
  page.trigger("actionUndo");
  EXPECT_EQ(color(), before);
}

TEST(Switches, EveryOnOrOffIsTheSameKind) {
  SettingsPage page;
  page.trigger("actionMeasure");
  int seen = 0;
  for (const QCheckBox* box : page.window().findChildren<QCheckBox*>()) {
    QStyleOptionButton option;
    option.initFrom(box);
    const QRect mark = box->style()->subElementRect(QStyle::SE_CheckBoxIndicator, &option, box);
    EXPECT_GT(mark.width(), mark.height() * 3 / 2) << box->objectName().toStdString() << " is not drawn as a switch";
    ++seen;
  }
  EXPECT_GT(seen, 20);
}

/// Counts the paints of what it watches.
class PaintCount : public QObject {
 public:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return false;
  }
  int paints = 0;
};

TEST(ValueField, SpeedsAreShownInTheUnitOfLength) {
  ValueField field({QStringLiteral("mm/s"), 0, 1.0, 5000.0, 10.0});
  field.setValue(254.0);
  EXPECT_EQ(field.text(), "254");
  Units inches;
  inches.length = Units::Length::kInch;
  setUnitsNow(inches);
  field.unitsChanged();
  EXPECT_EQ(field.text(), "10");
  field.show();
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, "900");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_NEAR(field.value(), 5000.0, 1e-6);
  EXPECT_TRUE(QTest::qWaitFor([] { return QToolTip::text() == "At most 197 in/s. You typed 900 in/s."; }, 2000))
      << QToolTip::text().toStdString();
  setUnitsNow({});
}

TEST(ValueField, ANumberBeyondAnEndBecomesThatEndAndSaysSo) {
  for (const auto& [typed, end, said] : {std::tuple{"200", 170.0, "At most 170.0°. You typed 200.0°."},
                                         std::tuple{"-200", -170.0, "At least -170.0°. You typed -200.0°."},
                                         std::tuple{"4 rad", 170.0, "At most 170.0°. You typed 229.2°."}}) {
    ValueField field({QStringLiteral("°"), 1, -170.0, 170.0});
    field.setValue(10.0);
    field.show();
    std::vector<double> edited;
    QObject::connect(&field, &ValueField::edited, [&](double value) { edited.push_back(value); });
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, typed);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(edited, std::vector<double>{end}) << typed;
    EXPECT_TRUE(QTest::qWaitFor([said = said] { return QToolTip::text() == QString::fromUtf8(said); }, 2000))
        << QToolTip::text().toStdString();
  }
}

TEST(ValueField, TheNumberThatItShowsAlreadyIsNotPaintedAnew) {
  CellPage page;
  ValueField field({QStringLiteral("mm")});
  field.show();
  field.setValue(990.0);
  CellPage::settle();
  PaintCount count;
  field.installEventFilter(&count);
  field.setValue(990.0 + 3e-8);  // As a pose that was worked out anew has it.
  CellPage::settle();
  EXPECT_EQ(count.paints, 0);
  field.setValue(991.0);
  ASSERT_TRUE(CellPage::until([&] { return count.paints > 0; }, 30000));
  EXPECT_EQ(field.text(), "991.0");
}

TEST(Settings, UnitsChangeEveryFieldAndAreRemembered) {
  SettingsPage page;
  const auto id = page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1}), Pose::translation({0.0508, 0, 0}));
  page.select(id);
  page.page(1);
  page.chooseSegment("segmentsLength", 3);
  EXPECT_EQ(lengthText(0.0254), "1.000 in");
  EXPECT_EQ(page.find<ValueField>("field_place_X")->text(), "2.000");
  page.find<QSpinBox>("fieldLengthDecimals")->setValue(2);
  CellPage::settle();
  EXPECT_EQ(page.find<ValueField>("field_place_X")->text(), "2.00");
  page.showDock("dockProperties");
  page.type("field_place_Y", "1");
  EXPECT_NEAR(page.document().find(id)->X_WE.p.y, 0.0254, 1e-9);
  EXPECT_NEAR(page.document().find(id)->X_WE.p.x, 0.0508, 1e-9) << "what is shown rounded is not rounded";
  EXPECT_EQ(page.settings().value("units/length").toInt(), 3);
}

TEST(Settings, ThemeChangesAtOnce) {
  SettingsPage page;
  page.chooseSegment("segmentsTheme", 1);
  EXPECT_FALSE(themeOf(QApplication::palette()).dark);
  page.chooseSegment("segmentsTheme", 0);
  EXPECT_TRUE(themeOf(QApplication::palette()).dark);
}

TEST(Settings, AMotionTakesTheGestureThatIsHeldOverItsField) {
  SettingsPage page;
  page.page(2);
  page.choose("comboNavigation", 5);
  EXPECT_TRUE(page.window().viewport().navigation() == navigationPreset("rviz"));
  auto* field = page.find<GestureField>("fieldGesture1");
  page.click(field, field->rect().center());
  const QPoint place = field->rect().center();
  QTest::mousePress(field, Qt::RightButton, Qt::AltModifier, place);
  QTest::mouseRelease(field, Qt::RightButton, Qt::AltModifier, place);
  CellPage::settle();
  EXPECT_EQ(page.window().viewport().navigation().motionFor(Qt::RightButton, Qt::AltModifier), ViewMotion::kPan);
  EXPECT_EQ(page.settings().value("navigation/preset").toString(), "own");
}

TEST(Settings, AKeyIsGivenToAnotherActionAndTakenFromTheFirst) {
  SettingsPage page;
  page.page(3);
  auto* table = page.find<QTableWidget>("tableKeys");
  page.find<QLineEdit>("fieldKeyFilter")->setText("Fit selection");
  CellPage::settle();
  ASSERT_EQ(table->rowCount(), 1);
  table->setCurrentCell(0, 0);
  auto* edit = page.find<QKeySequenceEdit>("fieldKey");
  edit->setKeySequence(QKeySequence(Qt::Key_V));
  EXPECT_TRUE(page.find<QLabel>("labelKey")->text().contains("Section")) << "it says what the key does now";
  page.press("buttonKeySet");
  EXPECT_EQ(page.find<QAction>("actionFit")->shortcut(), QKeySequence(Qt::Key_V));
  EXPECT_TRUE(page.find<QAction>("actionSection")->shortcut().isEmpty());
  page.press("buttonKeysShipped");
  EXPECT_EQ(page.find<QAction>("actionFit")->shortcut(), QKeySequence(Qt::Key_F));
  auto* letters = page.find<QCheckBox>("switchLetters");
  page.click(letters, QPoint(12, letters->height() / 2));
  EXPECT_TRUE(page.find<QAction>("actionFit")->shortcut().isEmpty());
  EXPECT_EQ(page.find<QAction>("actionUndo")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Z));
}

TEST(LayoutsInTheWindow, EachIsAsItWasLeft) {
  CellPage page;
  page.showDock("dockMove");
  page.window().layouts().choose("ergonomics");
  CellPage::settle();
  EXPECT_FALSE(page.find<QDockWidget>("dockWorkcell")->isVisible());
  page.window().layouts().choose("move");
  CellPage::settle();
  EXPECT_TRUE(page.find<QDockWidget>("dockWorkcell")->isVisible());
  EXPECT_FALSE(page.find<QDockWidget>("dockMove")->isHidden()) << "as it was left";
  page.trigger("actionResetLayout");
  EXPECT_TRUE(page.find<QDockWidget>("dockMove")->isHidden()) << "as it is drawn";
}

TEST(LayoutsInTheWindow, ADockThatWasMadeLaterStaysOutOfTheLayoutsBefore) {
  CellPage page;
  page.window().layouts().choose("teach");
  page.window().layouts().choose("move");
  auto* late = new QDockWidget("late", &page.window());
  late->setObjectName("dockLate");
  page.window().addDockWidget(Qt::RightDockWidgetArea, late);
  late->show();
  page.window().layouts().choose("teach");
  CellPage::settle();
  EXPECT_TRUE(late->isHidden());
  EXPECT_TRUE(page.find<QDockWidget>("dockRobot")->toggleViewAction()->isChecked()) << "what it had is there";
  page.window().layouts().choose("move");
  CellPage::settle();
  EXPECT_FALSE(late->isHidden());
}

bool comesToFront(MainWindow& window, const char* name) {
  const auto* dock = window.findChild<QDockWidget*>(name);
  return dock && CellPage::until([dock] { return isInFront(*dock); }, 30000);
}

QStringList shownDocks(MainWindow& window) {
  QStringList shown;
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
    if (!dock->isHidden()) shown << dock->objectName();
  shown.sort();
  return shown;
}

TEST(LayoutsInTheWindow, ErgonomicsShowsTheScoresAndThePageBesideThemWhereThereIsRoom) {
  CellPage page;
  for (const bool wide : {false, true}) {
    page.window().resize(wide ? 1560 : 1000, 800);
    CellPage::settle();
    page.window().layouts().choose("move");
    page.window().layouts().choose("ergonomics");
    page.window().layouts().reset();
    EXPECT_TRUE(comesToFront(page.window(), "dockErgonomics"));
    EXPECT_TRUE(comesToFront(page.window(), "dockErgonomicsTime"));
    const auto* report = page.find<QDockWidget>("dockReport");
    EXPECT_FALSE(report->isHidden());
    if (wide) {
      EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
      EXPECT_FALSE(report->geometry().intersects(page.find<QDockWidget>("dockErgonomics")->geometry()));
    }
    const auto beside = page.window().tabifiedDockWidgets(page.find<QDockWidget>("dockErgonomics"));
    EXPECT_EQ(beside.contains(report), !wide);
  }
  page.window().layouts().choose("teach");
  page.showDock("dockReport");
  EXPECT_TRUE(page.window()
                  .tabifiedDockWidgets(page.find<QDockWidget>("dockReport"))
                  .contains(page.find<QDockWidget>("dockRobot")))
      << "other layouts have it among the tabs";
}

TEST(LayoutsInTheWindow, WhatLayInFrontLiesThereAtTheNextStart) {
  const hapticell::test::TemporaryFolder place;
  const QString file = QString::fromStdString((place.path() / "window.ini").string());
  const char* const fronts[] = {"dockErgonomics", "dockMannequin", "dockReport"};
  for (int start = 0; start <= 3; ++start) {
    MainWindow window({}, file);
    window.resize(1000, 800);
    window.show();
    window.restoreLayout();
    if (start == 0)
      window.layouts().choose("ergonomics");
    else
      EXPECT_TRUE(comesToFront(window, fronts[start - 1])) << fronts[start - 1];
    EXPECT_EQ(window.layouts().current(), "ergonomics");
    if (start == 3) break;
    CellPage::settle();
    window.findChild<QDockWidget*>(fronts[start])->raise();
    EXPECT_TRUE(comesToFront(window, fronts[start]));
    window.layouts().store();
  }
}

TEST(LayoutsInTheWindow, TheSideDocksGoAndComeBackAsTheyWere) {
  CellPage page;
  page.window().layouts().choose("ergonomics");
  EXPECT_TRUE(comesToFront(page.window(), "dockErgonomics"));
  page.find<QDockWidget>("dockReport")->raise();
  EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
  const QStringList before = shownDocks(page.window());
  page.trigger("actionSideDocks");
  EXPECT_TRUE(page.find<QDockWidget>("dockReport")->isHidden());
  page.trigger("actionSideDocks");
  EXPECT_EQ(shownDocks(page.window()), before);
  EXPECT_TRUE(comesToFront(page.window(), "dockReport"));
}

TEST(LayoutsInTheWindow, ASmallWindowHasASceneAndTheForcesSwitch) {
  CellPage page;
  page.window().loadModules(ModuleLoader::defaultFolders());
  ASSERT_TRUE(page.window().startModule("Virtual Desktop"));
  page.window().resize(1366, 768);
  for (const QString& name : Layouts::names()) {
    page.window().layouts().choose(name == "move" ? "teach" : "move");
    page.window().layouts().choose(name);
    page.window().layouts().reset();
    for (int i = 0; i < 4; ++i) CellPage::settle();
    EXPECT_EQ(page.window().width(), 1366) << name.toStdString();
    const QSize scene = page.window().viewport().size();
    EXPECT_GT(scene.width() * scene.height(), 3 * 1366 * 768 / 10) << name.toStdString();
    auto* pill = page.find<QAbstractButton>("pillForces");
    EXPECT_TRUE(pill->isVisible() && !pill->visibleRegion().isEmpty()) << name.toStdString();
  }
  page.window().resize(1100, 700);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_FALSE(page.find<QAbstractButton>("pillForces")->visibleRegion().isEmpty());
}

TEST(LayoutsInTheWindow, ASmallWindowLeavesNoNarrowColumnBehind) {
  CellPage page;
  page.window().resize(1590, 900);
  page.window().layouts().choose("ergonomics");
  page.window().layouts().reset();
  for (int i = 0; i < 4; ++i) CellPage::settle();
  auto* report = page.find<QDockWidget>("dockReport");
  const int wide = report->width();
  EXPECT_GT(wide, 300);
  page.window().resize(1100, 700);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_TRUE(page.window().tabifiedDockWidgets(report).contains(page.find<QDockWidget>("dockErgonomics")))
      << "no column of its own where there is no room";
  page.window().resize(1590, 900);
  for (int i = 0; i < 4; ++i) CellPage::settle();
  EXPECT_NEAR(report->width(), wide, 4);
}

TEST(ValueFields, GiveTheirUnitAwayBeforeANumberIsCut) {
  ValueField field({"mm", 1, -1e6, 1e6, 1.0});
  field.resize(64, 26);
  field.show();
  for (const double value : {1.0, 1512.0, -123456.7}) {
    field.setValue(value);
    const QLineEdit* line = field.findChild<QLineEdit*>();
    const int room = line->width() - line->textMargins().right();
    EXPECT_LE(line->fontMetrics().horizontalAdvance(line->text()), room) << value;
  }
}

TEST(Tabs, ManyOnTheRightLeaveRoomForTheButtonsAtTheEnd) {
  CellPage page;
  page.window().resize(1366, 768);
  page.window().layouts().reset();
  for (const char* opens : {"actionMechanism", "actionTools", "actionMeasure", "actionMoveBy", "actionMotionPanel"})
    page.trigger(opens);
  page.showDock("dockMechanism");
  for (int i = 0; i < 6; ++i) CellPage::settle();
  const auto* mechanism = page.find<QDockWidget>("dockMechanism");
  int bars = 0;
  for (QTabBar* bar : page.window().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (bar->currentIndex() < 0 || bar->tabText(bar->currentIndex()) != mechanism->windowTitle()) continue;
    ++bars;
    EXPECT_GE(bar->count(), 7);
    constexpr int kButtons = 46;  // Float and close.
    EXPECT_LE(bar->tabRect(bar->count() - 1).right(), bar->width() - kButtons);
  }
  EXPECT_EQ(bars, 1);
}

TEST(Wheel, GivesNoFieldTheFocus) {
  CellPage page;
  int fields = 0;
  for (const QWidget* widget : page.window().findChildren<QWidget*>()) {
    const bool is_field = qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
                          qobject_cast<const QAbstractSlider*>(widget);
    if (!is_field || !widget->testAttribute(Qt::WA_WState_Polished)) continue;
    ++fields;
    EXPECT_NE(widget->focusPolicy(), Qt::WheelFocus) << widget->objectName().toStdString();
  }
  EXPECT_GT(fields, 5);
}

TEST(FirstPage, AClickOnASampleOpensItAndEscapeClosesThePage) {
  CellPage page;
  page.trigger("actionFirstPage");
  auto* start = page.find<StartPage>("startPage");
  ASSERT_TRUE(start->isVisible());
  QTest::keyClick(start, Qt::Key_Escape);
  EXPECT_FALSE(start->isVisible());
  page.trigger("actionFirstPage");
  page.press("sample_demo");
  ASSERT_TRUE(CellPage::until([&] { return page.entities() > 5; }, 60000));
  CellPage::settle();
  EXPECT_FALSE(start->isVisible());
  EXPECT_EQ(page.window().recentFiles().files().size(), 0) << "it is a copy that has no file yet";
}

TEST(Views, AreKeptAndComeBack) {
  CellPage page;
  page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1}));
  page.lookAt({0, 0, 0}, 0.2);
  const Camera kept = page.window().viewport().camera();
  page.trigger("actionKeepView");
  page.trigger("actionBottom");
  EXPECT_NE(page.window().viewport().camera().elevation, kept.elevation);
  auto* menu = page.find<QMenu>("menuSavedViews");
  emit menu->aboutToShow();
  ASSERT_FALSE(menu->actions().isEmpty());
  menu->actions().front()->trigger();
  CellPage::settle();
  EXPECT_NEAR(page.window().viewport().camera().elevation, kept.elevation, 1e-6);
  EXPECT_NEAR(page.window().viewport().camera().distance, kept.distance, 1e-6);
}

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
  SettingsPage page;
  page.select(page.addSolid("box", geometry::makeBox({0.1, 0.1, 0.1})));
  for (const char* dock : {"dockMove", "dockMeasure", "dockSolid", "dockProperties", "dockSettings"}) {
    const QStringList found = nameless(*page.find<QDockWidget>(dock));
    EXPECT_TRUE(found.isEmpty()) << dock << ": " << found.join(", ").toStdString();
  }
}

}  // namespace
}  // namespace hapticell::app
