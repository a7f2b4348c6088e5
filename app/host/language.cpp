// SPDX-License-Identifier: Apache-2.0
#include "app/host/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace hapticell::app {
namespace {

/// Words of Qt's own dialogs and questions, which the translator finds like the window's: Qt's translations are often
/// not installed.
[[maybe_unused]] constexpr const char* kWordsOfQt[]{
    QT_TRANSLATE_NOOP("QColorDialog", "&Basic colors"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Custom colors"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Add to Custom Colors"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Pick Screen Color"),
    QT_TRANSLATE_NOOP("QColorDialog", "Hu&e:"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Sat:"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Val:"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Red:"),
    QT_TRANSLATE_NOOP("QColorDialog", "&Green:"),
    QT_TRANSLATE_NOOP("QColorDialog", "Bl&ue:"),
    QT_TRANSLATE_NOOP("QFileDialog", "%1 already exists.\nDo you want to replace it?"),
    QT_TRANSLATE_NOOP("QFileSystemModel", "Computer"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&Yes"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "&No"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),
};

}  // namespace

bool Translator::loadLanguage(const QString& language) {
  return load(QStringLiteral(":/hapticell/translations/hapticell_%1.qm").arg(language));
}

QString Translator::translate(const char*, const char* text, const char* meaning, int count) const {
  QString found = QTranslator::translate(kContext, text, meaning, count);
  // What the folder mannequin/ergonomics reports has a context of its own, that of the reports.
  if (found.isEmpty()) found = QTranslator::translate("Ergonomics", text, meaning, count);
  // A text is not said twice for each meaning that it happens to be marked with.
  return found.isEmpty() && meaning ? QTranslator::translate(kContext, text, nullptr, count) : found;
}

QString languageNow() {
  return QLocale().language() == QLocale::French ? QStringLiteral("fr") : QStringLiteral("en");
}

bool installLanguage(const QString& language) {
  QLocale::setDefault(QLocale(language));
  if (language == QLatin1String("en")) {
    // Only for the plurals: "1 entity", "2 entities".
    auto* plurals = new Translator(qApp);
    return plurals->loadLanguage("en") && QCoreApplication::installTranslator(plurals);
  }
  auto* of_qt = new QTranslator(qApp);
  if (of_qt->load(QStringLiteral("qtbase_") + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(of_qt);
  auto* own = new Translator(qApp);
  return own->loadLanguage(language) && QCoreApplication::installTranslator(own);
}

}  // namespace hapticell::app
