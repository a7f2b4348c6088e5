// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTranslator>

namespace hapticell::app {

/// The window's own texts in another language. All texts stand in one context, so that a text is the same wherever it
/// is written; what is not translated stays English.
class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  static constexpr const char* kContext = "HaptiCell";
  /// False if there is no translation for that language ("en" needs no translation).
  bool loadLanguage(const QString& language);
  bool isEmpty() const override { return QTranslator::isEmpty(); }
  QString translate(const char* context, const char* text, const char* meaning, int count) const override;
};

/// Before the first widget is made: the window's texts and Qt's own in this language, for the life of the application.
/// False where it has none; the window is then English.
bool installLanguage(const QString& language);
/// The language that the window speaks ("en", "fr"), whatever the settings say of the next start.
QString languageNow();

}  // namespace hapticell::app
