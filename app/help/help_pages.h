// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace hapticell::app {

/// Pages of the manual that belong together, in the order in which they are read.
struct HelpChapter {
  QString title;      ///< In the window's language.
  QStringList pages;  ///< Names, see helpPage().
};

/// The manual's contents: every page is in one chapter.
std::vector<HelpChapter> helpContents();

/// A page as Markdown, by its name (a panel's, "dockMove", or "firstSteps") and language ("en"). If no page has that
/// name, the page about the scene; if it is not translated, the English page.
QString helpPage(const QString& name, const QString& language);
/// What the page's heading says.
QString helpTitle(const QString& name, const QString& language);
/// The names of the pages in which each word of `typed` stands, in any order and with or without accents; all where
/// nothing is typed.
QStringList helpPagesWith(const QString& typed, const QString& language);

}  // namespace hapticell::app
