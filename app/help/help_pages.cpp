// SPDX-License-Identifier: Apache-2.0
#include "app/help/help_pages.h"

#include <QFile>
#include <QObject>
#include <algorithm>

namespace hapticell::app {
namespace {

QString readHelp(const QString& language, const QString& page) {
  QFile file(QStringLiteral(":/hapticell/help/%1/%2.md").arg(language, page));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Small letters without accents.
QString plainLetters(const QString& text) {
  QString result;
  for (const QChar letter : text.normalized(QString::NormalizationForm_D))
    if (!letter.isMark()) result += letter.toLower();
  return result;
}

}  // namespace

std::vector<HelpChapter> helpContents() {
  return {
      {QObject::tr("First steps"), {"firstSteps", "window", "terms"}},
      {QObject::tr("The scene"),
       {"scene", "dockWorkcell", "dockProperties", "dockMove", "dockMeasure", "dockHistory", "sceneWords"}},
      {QObject::tr("Parts"), {"dockImport", "dockInsertPart", "dockSolid", "dockMesh", "dockMechanism"}},
      {QObject::tr("Robots"), {"dockAddRobot", "dockRobot", "dockTools"}},
      {QObject::tr("Forces and contacts"),
       {"dockVirtualDesktop", "dockDeviceCheck", "dockCollisions", "dockGuides", "dockCurves"}},
      {QObject::tr("Motions"), {"dockTrajectory", "dockMotion"}},
      {QObject::tr("Training"), {"dockTraining"}},
      {QObject::tr("Mannequin and ergonomics"),
       {"dockMannequin", "dockErgonomics", "dockWorkTask", "dockWorkplace", "dockErgonomicsTime", "dockMarkers",
        "dockReport"}},
      {QObject::tr("Studies"), {"dockStudy", "dockStudyResults"}},
      {QObject::tr("Files"), {"files"}},
      {QObject::tr("Settings and keys"), {"dockSettings", "keys", "dockMessages"}},
  };
}

QString helpPage(const QString& name, const QString& language) {
  for (const QString& page : {name, QStringLiteral("scene")})
    for (const QString& spoken : {language, QStringLiteral("en")})
      if (const QString text = page.isEmpty() ? QString() : readHelp(spoken, page); !text.isEmpty()) return text;
  return {};
}

QString helpTitle(const QString& name, const QString& language) {
  return helpPage(name, language).section('\n', 0, 0).remove('#').trimmed();
}

QStringList helpPagesWith(const QString& typed, const QString& language) {
  const QStringList words = plainLetters(typed).split(' ', Qt::SkipEmptyParts);
  QStringList found;
  for (const HelpChapter& chapter : helpContents())
    for (const QString& page : chapter.pages) {
      const QString text = plainLetters(helpPage(page, language));
      if (std::all_of(words.begin(), words.end(), [&](const QString& word) { return text.contains(word); }))
        found << page;
    }
  return found;
}

}  // namespace hapticell::app
