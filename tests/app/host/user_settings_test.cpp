// SPDX-License-Identifier: Apache-2.0
#include "app/host/user_settings.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "app/kit/kept_picture.h"
#include "app/settings/configuration_page.h"
#include "app/settings/key_map.h"
#include "app/settings/toml_edit.h"
#include "app/settings/user_choices.h"
#include "app/start/recent_files.h"
#include "app/views/saved_views.h"
#include "config/configuration.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

TEST(UserSettings, AreThereAgainAtTheNextStart) {
  QTemporaryDir folder;
  const QString file = folder.filePath("deep/window.ini");
  {
    UserSettings settings(file);
    settings.setValue("units/length", 3);
    settings.setValue("keys/actionFit", "Ctrl+J");
    settings.setValue("gone", 1);
    settings.remove("gone");
    EXPECT_TRUE(settings.flush());
  }
  UserSettings again(file);
  EXPECT_EQ(again.value("units/length").toInt(), 3);
  EXPECT_EQ(again.keysBelow("keys"), QStringList{"actionFit"});
  EXPECT_FALSE(again.value("gone").isValid());
}

TEST(UserSettings, OfVersion01AreRead) {
  QTemporaryDir folder;
  const QString file = folder.filePath("window.ini");
  ASSERT_TRUE(QFile::copy(QString::fromStdString(test::sourceFile("tests/samples/0.1/window.ini").string()), file));
  const UserSettings settings(file);
  EXPECT_EQ(languageFrom(settings), "fr");
  EXPECT_EQ(settings.value("theme").toString(), "light");
  EXPECT_EQ(settings.keysBelow("keys"), QStringList{"actionFit"});
  EXPECT_FALSE(settings.value("start/page").toBool());
  const Units units = unitsFrom(settings);
  EXPECT_EQ(units.length, Units::Length::kCentimetre);
  EXPECT_EQ(units.length_decimals, 3);
  EXPECT_EQ(units.angle_decimals, 2);
  EXPECT_TRUE(navigationFrom(settings) == navigationPreset("solidworks"));
  EXPECT_FALSE(navigationFrom(settings) == navigationPreset("hapticell"));
}

TEST(UserSettings, TellOfChangesOnlyWhereTheyAreSome) {
  UserSettings settings;
  int changes = 0;
  QObject::connect(&settings, &UserSettings::changed, [&changes] { ++changes; });
  settings.setValue("a", 1);
  settings.setValue("a", 1);
  settings.remove("b");
  EXPECT_EQ(changes, 1);
}

TEST(UserChoices, DamagedSettingsCountAsNone) {
  UserSettings settings;
  settings.setValue("units/length", 99);
  settings.setValue("units/length_decimals", "many");
  settings.setValue("navigation/preset", "own");
  settings.setValue("navigation/own", "nonsense");
  settings.setValue("language", "tlh");
  EXPECT_LE(static_cast<int>(unitsFrom(settings).length), 3);
  EXPECT_EQ(unitsFrom(settings).length_decimals, 0);
  EXPECT_TRUE(navigationFrom(settings) == navigationPreset("hapticell"));
  EXPECT_TRUE(languageFrom(settings) == "en" || languageFrom(settings) == "fr");
}

TEST(SavedViews, BelongToTheirCellAndComeBackExactly) {
  UserSettings settings;
  SavedViews views(settings);
  views.setCell("/cells/a.hcell");
  Camera camera;
  camera.target_W = {1.25, -3.5, 0.125};
  camera.azimuth = -2.2;
  camera.perspective = false;
  views.keep("Over/the top ä", camera);
  EXPECT_EQ(views.names(), QStringList{"Over/the top ä"});
  const auto read = views.find("Over/the top ä");
  ASSERT_TRUE(read.has_value());
  EXPECT_NEAR(glm::length(read->target_W - camera.target_W), 0.0, 1e-9);
  EXPECT_NEAR(read->azimuth, camera.azimuth, 1e-9);
  EXPECT_FALSE(read->perspective);
  views.setCell("/cells/b.hcell");
  EXPECT_TRUE(views.names().isEmpty());
  views.setCell("/cells/a.hcell");
  views.remove("Over/the top ä");
  EXPECT_TRUE(views.names().isEmpty());
}

TEST(SavedViews, OfACellWithoutAFileGoWithItOrToItsFile) {
  UserSettings settings;
  SavedViews views(settings);
  views.setCell({});
  views.keep("first", Camera());
  views.closeCell();
  views.setCell({});
  EXPECT_TRUE(views.names().isEmpty()) << "of the cell before";
  views.keep("second", Camera());
  views.setCell("/cells/saved.hcell");
  EXPECT_EQ(views.names(), QStringList{"second"}) << "it was saved";
  views.closeCell();
  views.setCell({});
  EXPECT_TRUE(views.names().isEmpty());
}

TEST(SavedViews, WhatIsNoCameraIsNone) {
  for (const char* text : {"", "1 2 3", "1 2 3 4 5 -6 0.6 perspective", "nan 2 3 4 5 6 0.6 perspective"})
    EXPECT_FALSE(cameraFromText(text).has_value()) << text;
}

TEST(RecentFiles, KeepTheNewestOnceAndLeaveOutWhatIsGone) {
  QTemporaryDir folder;
  UserSettings settings;
  RecentFiles recent(settings);
  QStringList paths;
  for (int i = 0; i < RecentFiles::kMost + 2; ++i) {
    paths << folder.filePath(QString::number(i) + ".hcell");
    QFile file(paths.back());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    recent.add(paths.back());
  }
  recent.add(paths[5]);
  ASSERT_EQ(recent.files().size(), RecentFiles::kMost);
  EXPECT_EQ(recent.files().front(), paths[5]);
  QFile::remove(paths[5]);
  EXPECT_NE(recent.files().front(), paths[5]);
}

TEST(RecentFiles, HaveTheirPicturesWhereSettingsAreKept) {
  QTemporaryDir folder;
  qputenv("XDG_CACHE_HOME", folder.path().toLocal8Bit());
  QImage picture(92, 52, QImage::Format_RGB32);
  picture.fill(Qt::red);
  UserSettings forgotten, kept(folder.filePath("window.ini"));
  RecentFiles(forgotten).keepPicture("/cells/a.hcell", picture);
  EXPECT_TRUE(keptPicture("/cells/a.hcell").isNull());
  RecentFiles(kept).keepPicture("/cells/a.hcell", picture);
  EXPECT_EQ(keptPicture("/cells/a.hcell").size(), picture.size());
  EXPECT_TRUE(keptPicture("/cells/b.hcell").isNull());
  qunsetenv("XDG_CACHE_HOME");
}

TEST(TomlEdit, ChangesOneLineAndKeepsTheRest) {
  const std::string text =
      "# mine\npreset = \"shipped\"\n\n[haptic]\nrate_hz = 500.0  # slow\n\n[gui]\ntheme = \"dark\"\n";
  EXPECT_EQ(withTomlValue(text, "haptic.rate_hz", "800.0"),
            "# mine\npreset = \"shipped\"\n\n[haptic]\nrate_hz = 800.0\n\n[gui]\ntheme = \"dark\"\n");
  EXPECT_EQ(withTomlValue("[gui]\ntheme = \"dark\"\n", "gui.motion", "false"),
            "[gui]\ntheme = \"dark\"\nmotion = false\n");
  EXPECT_EQ(withTomlValue("", "materials.foam.friction", "0.5"), "[materials.foam]\nfriction = 0.5\n");
  EXPECT_EQ(withTomlValue("[a]\nx = 1\n\n[b]\nx = 2\n", "a.y", "3"), "[a]\nx = 1\ny = 3\n\n[b]\nx = 2\n");
}

TEST(WriteSetting, EverySettingThatIsListedCanBeWrittenAndReadBack) {
  QTemporaryDir folder;
  const QString file = folder.filePath("hapticell.toml");
  for (const config::Setting& setting : config::settings({})) {
    const auto written = writeSetting(file, QString::fromStdString(setting.key), QString::fromStdString(setting.value));
    ASSERT_TRUE(written.has_value()) << setting.key << ": " << written.error().message();
  }
  ASSERT_TRUE(writeSetting(file, "gui.theme", "light").has_value());
  ASSERT_TRUE(writeSetting(file, "manipulation.near_miss", "0.025").has_value());
  const auto read = config::readConfiguration(file.toStdString());
  ASSERT_TRUE(read.has_value()) << read.error().message();
  EXPECT_EQ(read->gui.theme, "light");
  EXPECT_DOUBLE_EQ(read->manipulation.near_miss, 0.025);
}

TEST(WriteSetting, WhatIsRefusedLeavesTheFileAsItWas) {
  QTemporaryDir folder;
  const QString file = folder.filePath("hapticell.toml");
  EXPECT_FALSE(writeSetting(file, "gui.theme", "pink").has_value());
  EXPECT_FALSE(writeSetting(file, "haptic.rate_hz", "fast").has_value());
  EXPECT_FALSE(QFile::exists(file));
}

TEST(KeyMap, OnAzertyTheLeftHandFindsTheKeysWhereTheyWere) {
  EXPECT_EQ(KeyMap::movedTo("azerty", QKeySequence(Qt::Key_Q)), QKeySequence(Qt::Key_A));
  EXPECT_EQ(KeyMap::movedTo("azerty", QKeySequence(Qt::Key_W)), QKeySequence(Qt::Key_Z));
  EXPECT_EQ(KeyMap::movedTo("azerty", QKeySequence(Qt::CTRL | Qt::Key_Z)), QKeySequence(Qt::CTRL | Qt::Key_Z));
  EXPECT_EQ(KeyMap::movedTo("qwertz", QKeySequence(Qt::Key_W)), QKeySequence(Qt::Key_W));
}

}  // namespace
}  // namespace hapticell::app
