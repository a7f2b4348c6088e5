// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTranslator>

namespace hapticell::app {

/// Translates the window's own texts. All texts are in one context, so that a text has the same translation wherever it
/// is used; what is not translated stays English.
class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  static constexpr const char* kContext = "HaptiCell";
  /// False if there is no translation for that language ("en" needs no translation).
  bool loadLanguage(const QString& language);
  bool isEmpty() const override { return QTranslator::isEmpty(); }
  QString translate(const char* context, const char* text, const char* meaning, int count) const override;
};

/// Installs the window's texts and Qt's own in this language for the life of the application; call it before the first
/// widget is made. Returns false if there is no translation; the window is then English.
bool installLanguage(const QString& language);
/// The present language of the window ("en", "fr"); the settings may name another one for the next start.
QString languageNow();

}  // namespace hapticell::app
