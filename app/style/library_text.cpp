// SPDX-License-Identifier: Apache-2.0
#include "app/style/library_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <string>
#include <vector>

#include "app/style/units.h"
#include "geometry/system/overloaded.h"
#include "geometry/system/plain_text.h"

namespace hapticell::app {
namespace {

QString shownArgument(const Text::Argument& argument) {
  return std::visit(Overloaded{[](const std::string& words) { return QString::fromStdString(words); },
                               [](const Text::Length& length) {
                                 return length.whole ? lengthText(length.metres, 0) : lengthText(length.metres);
                               },
                               [](const Text::Angle& angle) { return angleText(angle.radians); },
                               [](std::int64_t count) { return QString::number(count); },
                               [](const std::vector<Text>& texts) { return shownText(texts); }},
                    argument);
}

}  // namespace

QString shownText(const Text& text) {
  if (text.empty()) return {};
  std::vector<std::string> values;
  for (const Text::Argument& argument : text.arguments()) values.push_back(shownArgument(argument).toStdString());
  const QString form = QCoreApplication::translate("LibraryText", std::string(text.id()).c_str());
  return QString::fromStdString(filled(form.toStdString(), values));
}

QString shownText(std::span<const Text> texts) {
  QStringList shown;
  for (const Text& text : texts) shown << shownText(text);
  return shown.join(QStringLiteral("; "));
}

QString shownText(const Error& error) {
  constexpr std::size_t kLongestPath = 4096;
  const auto line = [](const Text& text, std::size_t longest = kLongestText) {
    return QString::fromStdString(plainText(shownText(text).toStdString(), longest));
  };
  QString shown = QString::fromStdString(plainText(error.file, kLongestPath));
  const auto add = [&](const QString& separator, const QString& part) {
    shown += (shown.isEmpty() ? QString() : separator) + part;
  };
  if (!error.place.empty()) add(QStringLiteral(", "), line(error.place));
  if (!error.found.empty()) add(QCoreApplication::translate("LibraryText", ": "), line(error.found));
  if (!error.expected.empty())
    add(QStringLiteral("; "), QCoreApplication::translate("LibraryText", "expected %1").arg(line(error.expected)));
  if (!error.fix.empty()) add(QStringLiteral(". "), line(error.fix, 2 * kLongestText));
  return shown;
}

QString shownText(const haptic::LinkProblem& problem) {
  return (shownText(problem.what) + QLatin1Char(' ') + shownText(problem.fix)).trimmed();
}

}  // namespace hapticell::app
