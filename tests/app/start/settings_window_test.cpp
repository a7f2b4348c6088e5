// SPDX-License-Identifier: Apache-2.0
// Settings, colours, first page and views by real events.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>

#include "app/host/user_settings.h"
#include "app/kit/swatch_row.h"
#include "app/settings/configuration_fields.h"
#include "app/settings/gesture_field.h"
#include "app/start/recent_files.h"
#include "app/start/start_page.h"
#include "app/style/units.h"
#include "tests/app/pages/cell_page.h"

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
  const auto saturation = [&] {
    const auto [low, high] = std::minmax({drawn()[0], drawn()[1], drawn()[2]});
    return (high - low) / high;
  };
  EXPECT_LE(saturation(), 0.2501F) << "quiet, so that contacts are loud";
  ASSERT_FALSE(page.window().messages().messages().empty());
  EXPECT_TRUE(page.window().messages().messages().back().title.contains("quieter colour"));
  page.window().userSettings().setValue("colors/full", true);
  EXPECT_NEAR(drawn()[2], 0x10 / 255.0, 1e-3);
  page.window().userSettings().setValue("colors/full", false);
  EXPECT_LE(saturation(), 0.2501F);
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

}  // namespace
}  // namespace hapticell::app
