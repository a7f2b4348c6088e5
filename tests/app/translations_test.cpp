// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/help/help_dock.h"
#include "app/host/language.h"

namespace hapticell::app {
namespace {

TEST(Translations, FrenchHasPluralsAndPlaceholders) {
  Translator french;
  if (!french.loadLanguage("fr")) GTEST_SKIP() << "built without Qt's Linguist tools";
  EXPECT_EQ(french.translate("Anything", "Undo", nullptr, -1), "Annuler");
  EXPECT_TRUE(french.translate("Anything", "%n selected", nullptr, 2).contains("%n") ||
              french.translate("Anything", "%n selected", nullptr, 2).contains("choisi"));
  EXPECT_TRUE(french.translate("Anything", "no such text", nullptr, -1).isEmpty())
      << "the window shows the English text";
}

TEST(Translations, EnglishHasOnePlural) {
  Translator english;
  if (!english.loadLanguage("en")) GTEST_SKIP() << "built without Qt's Linguist tools";
  EXPECT_EQ(english.translate("", "%n solids", nullptr, 1), "%n solid");
  EXPECT_EQ(english.translate("", "%n solids", nullptr, 3), "%n solids");
}

TEST(HelpPages, EveryPageIsThereInBothLanguages) {
  for (const char* dock :
       {"dockWorkcell",  "dockProperties", "dockVirtualDesktop", "dockDeviceCheck",    "dockSolid",
        "dockRobot",     "dockAddRobot",   "dockInsertPart",     "dockTools",          "dockMechanism",
        "dockMannequin", "dockMarkers",    "dockGuides",         "dockMove",           "dockMeasure",
        "dockImport",    "dockMesh",       "dockCollisions",     "dockTrajectory",     "dockMotion",
        "dockTraining",  "dockCurves",     "dockErgonomics",     "dockErgonomicsTime", "dockWorkTask",
        "dockWorkplace", "dockReport",     "dockMessages",       "dockHistory",        "dockSettings"}) {
    EXPECT_NE(helpPage(dock, "en"), helpPage("", "en")) << dock << " has no page of its own";
    EXPECT_FALSE(helpPage(dock, "en").isEmpty());
    EXPECT_NE(helpPage(dock, "en"), helpPage(dock, "fr")) << dock;
  }
  EXPECT_EQ(helpPage("dockUnknown", "en"), helpPage("", "en")) << "the page about the scene";
}

}  // namespace
}  // namespace hapticell::app
