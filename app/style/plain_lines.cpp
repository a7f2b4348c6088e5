// SPDX-License-Identifier: Apache-2.0
#include "app/style/plain_lines.h"

#include <QStringList>

#include "geometry/system/plain_text.h"

namespace hapticell::app {

QString plainLines(const QString& text, int most_lines) {
  constexpr std::size_t kLongestLine = 2000;
  QStringList lines = most_lines > 1 ? text.split(QLatin1Char('\n')) : QStringList(text);
  if (lines.size() > most_lines) lines = lines.mid(0, most_lines) << QStringLiteral("...");
  for (QString& line : lines) line = QString::fromStdString(plainText(line.toStdString(), kLongestLine));
  return lines.join(QLatin1Char('\n'));
}

}  // namespace hapticell::app
