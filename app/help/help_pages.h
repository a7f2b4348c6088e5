// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace hapticell::app {

/// Pages of the manual that belong together, in reading order.
struct HelpChapter {
  QString title;      ///< In the window's language.
  QStringList pages;  ///< Names, see helpPage().
};

/// The manual's contents: every page is in one chapter.
std::vector<HelpChapter> helpContents();

/// A page as Markdown, by its name (a panel's, "dockMove", or "firstSteps") and language ("en"). Returns the page about
/// the scene if there is no page of that name, and the English page if it is not translated.
QString helpPage(const QString& name, const QString& language);
/// The heading of a page.
QString helpTitle(const QString& name, const QString& language);
/// The names of the pages that contain each word of `typed`, in any order and with or without accents; all pages if
/// nothing is typed.
QStringList helpPagesWith(const QString& typed, const QString& language);

}  // namespace hapticell::app
