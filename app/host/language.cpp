// SPDX-License-Identifier: Apache-2.0
#include "app/host/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace hapticell::app {

bool Translator::loadLanguage(const QString& language) {
  return load(QStringLiteral(":/hapticell/translations/hapticell_%1.qm").arg(language));
}

QString Translator::translate(const char*, const char* text, const char* meaning, int count) const {
  const QString found = QTranslator::translate(kContext, text, meaning, count);
  // A text is not said twice for each meaning that it happens to be marked with.
  return found.isEmpty() && meaning ? QTranslator::translate(kContext, text, nullptr, count) : found;
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
