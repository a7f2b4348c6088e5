// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QDir>
#include <QRegularExpression>

#include "app/help/help_pages.h"
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

QStringList pagesOfContents() {
  QStringList pages;
  for (const HelpChapter& chapter : helpContents()) pages << chapter.pages;
  return pages;
}

TEST(HelpPages, EveryPageIsInTheContentsOnceInBothLanguages) {
  const QStringList pages = pagesOfContents();
  for (const QString& page : pages) {
    EXPECT_EQ(pages.count(page), 1) << page.toStdString();
    EXPECT_TRUE(page == "scene" || helpPage(page, "en") != helpPage("", "en"))
        << page.toStdString() << " has no page of its own";
    EXPECT_NE(helpPage(page, "en"), helpPage(page, "fr")) << page.toStdString();
    for (const char* language : {"en", "fr"}) EXPECT_FALSE(helpTitle(page, language).isEmpty()) << page.toStdString();
  }
  for (const char* language : {"en", "fr"})
    for (const QString& file : QDir(QStringLiteral(":/hapticell/help/") + language).entryList())
      EXPECT_TRUE(pages.contains(file.section('.', 0, 0))) << file.toStdString();
  EXPECT_EQ(helpPage("dockUnknown", "en"), helpPage("", "en")) << "the page about the scene";
}

TEST(HelpPages, EveryLinkLeadsToAPage) {
  const QRegularExpression link(QStringLiteral("\\]\\(([^)]*)\\)"));
  int links = 0;
  for (const QString& page : pagesOfContents())
    for (const char* language : {"en", "fr"}) {
      auto match = link.globalMatch(helpPage(page, language));
      for (; match.hasNext(); ++links) {
        const QString to = match.next().captured(1);
        EXPECT_TRUE(to.endsWith(".md") && pagesOfContents().contains(to.chopped(3)))
            << page.toStdString() << " to " << to.toStdString();
      }
    }
  EXPECT_GT(links, 40);
}

TEST(HelpPages, AreFoundByWordsWithOrWithoutAccents) {
  EXPECT_EQ(helpPagesWith("flange tcp", "en").front(), "dockInsertPart");
  EXPECT_TRUE(helpPagesWith("deplacer", "fr").contains("dockMove")) << "Déplacer";
  EXPECT_EQ(helpPagesWith(" ", "en"), pagesOfContents());
  EXPECT_TRUE(helpPagesWith("xyzzy", "en").isEmpty());
}

}  // namespace
}  // namespace hapticell::app
