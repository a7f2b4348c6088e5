// SPDX-License-Identifier: Apache-2.0
#include "app/style/library_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <numbers>
#include <vector>

#include "app/style/units.h"

namespace hapticell::app {
namespace {

/// A sentence with places for what differs: {s} is any text, {m} millimetres, {d} degrees; the same without these
/// letters, %1 and so on in their order, is what is translated.
struct Pattern {
  const char* found;
  const char* shown;
};

// The vaguer ones last: a name may hold any words.
constexpr Pattern kPatterns[] = {
    {"{s} is at its upper limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is at its upper limit")},
    {"{s} is at its lower limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is at its lower limit")},
    {"{s} is {d} from its upper limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its upper limit")},
    {"{s} is {d} from its lower limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its lower limit")},
    {"{s} is {m} from its upper limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its upper limit")},
    {"{s} is {m} from its lower limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its lower limit")},
    {"{s} is {d} from its limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its limit")},
    {"{s} is {m} from its limit", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from its limit")},
    {"{s} would be {d} over its upper limit", QT_TRANSLATE_NOOP("LibraryText", "%1 would be %2 over its upper limit")},
    {"{s} would be {d} under its lower limit",
     QT_TRANSLATE_NOOP("LibraryText", "%1 would be %2 under its lower limit")},
    {"{s} would be {m} over its upper limit", QT_TRANSLATE_NOOP("LibraryText", "%1 would be %2 over its upper limit")},
    {"{s} would be {m} under its lower limit",
     QT_TRANSLATE_NOOP("LibraryText", "%1 would be %2 under its lower limit")},
    {"{s} is near a position where nothing holds it",
     QT_TRANSLATE_NOOP("LibraryText", "%1 is near a position where nothing holds it")},
    {"{s} moves as fast as it can", QT_TRANSLATE_NOOP("LibraryText", "%1 moves as fast as it can")},
    {"The arm is near a singularity", QT_TRANSLATE_NOOP("LibraryText", "The arm is near a singularity")},
    {"The left hand is {m} from the end of its reach",
     QT_TRANSLATE_NOOP("LibraryText", "The left hand is %1 from the end of its reach")},
    {"The right hand is {m} from the end of its reach",
     QT_TRANSLATE_NOOP("LibraryText", "The right hand is %1 from the end of its reach")},
    {"The head goes no further: neck and trunk are at their limits",
     QT_TRANSLATE_NOOP("LibraryText", "The head goes no further: neck and trunk are at their limits")},
    {"Connecting to the haptic server at {s}.",
     QT_TRANSLATE_NOOP("LibraryText", "Connecting to the haptic server at %1.")},
    {"No haptic server answers at {s}. Start hapticell-haptic-server.",
     QT_TRANSLATE_NOOP("LibraryText", "No haptic server answers at %1. Start hapticell-haptic-server.")},
    {"The haptic server at {s} does not answer any more.",
     QT_TRANSLATE_NOOP("LibraryText", "The haptic server at %1 does not answer any more.")},
    {"Another program ({s}) controls the stylus. Close it, or connect as a watcher.",
     QT_TRANSLATE_NOOP("LibraryText", "Another program (%1) controls the stylus. Close it, or connect as a watcher.")},
    {"Preparing the contacts was given up: what was changed is not felt yet",
     QT_TRANSLATE_NOOP("LibraryText", "Preparing the contacts was given up: what was changed is not felt yet")},
    {"{s} touches {s} of {s}", QT_TRANSLATE_NOOP("LibraryText", "%1 touches %2 of %3")},
    {"{s} is near {s} of {s}", QT_TRANSLATE_NOOP("LibraryText", "%1 is near %2 of %3")},
    {"{s} is {m} from {s}", QT_TRANSLATE_NOOP("LibraryText", "%1 is %2 from %3")},
    {"{s} touches {s}", QT_TRANSLATE_NOOP("LibraryText", "%1 touches %2")},
    {"{s} is free", QT_TRANSLATE_NOOP("LibraryText", "%1 is free")},
};

struct Known {
  QRegularExpression found;
  QString kinds;  // A letter for each place.
  const char* shown;
};

Known knownOf(const Pattern& pattern) {
  Known known;
  known.shown = pattern.shown;
  QString text = QRegularExpression::escape(QString::fromLatin1(pattern.found));
  static const QRegularExpression place(QStringLiteral("\\\\\\{([smd])\\\\\\}"));
  for (auto match = place.match(text); match.hasMatch(); match = place.match(text)) {
    const QString kind = match.captured(1);
    known.kinds += kind;
    const QString number = QStringLiteral("(-?[0-9.]+) ");
    text.replace(
        match.capturedStart(), match.capturedLength(),
        kind == "s" ? QStringLiteral("(.+)") : number + (kind == "m" ? QStringLiteral("mm") : QStringLiteral("deg")));
  }
  known.found = QRegularExpression(QRegularExpression::anchoredPattern(text));
  return known;
}

/// All places at once: a name may hold "%1".
QString filled(const QString& text, const QStringList& values) {
  switch (values.size()) {
    case 1:
      return text.arg(values[0]);
    case 2:
      return text.arg(values[0], values[1]);
    case 3:
      return text.arg(values[0], values[1], values[2]);
    default:
      return text;
  }
}

QString shownOne(const QString& sentence) {
  static const std::vector<Known> all = [] {
    std::vector<Known> made;
    for (const Pattern& pattern : kPatterns) made.push_back(knownOf(pattern));
    return made;
  }();
  for (const Known& known : all) {
    const auto match = known.found.match(sentence);
    if (!match.hasMatch()) continue;
    QStringList values;
    for (int i = 1; i <= static_cast<int>(known.kinds.size()); ++i) {
      const QString text = match.captured(i);
      const QChar kind = known.kinds[i - 1];
      values << (kind == 'm'   ? lengthText(0.001 * text.toDouble())
                 : kind == 'd' ? angleText(text.toDouble() * std::numbers::pi / 180.0)
                               : text);
    }
    return filled(QCoreApplication::translate("LibraryText", known.shown), values);
  }
  return sentence;
}

}  // namespace

QString shownText(const std::string& sentence) {
  const QString whole = QString::fromStdString(sentence), separator = QStringLiteral("; ");
  QStringList shown;
  for (const QString& part : whole.split(separator)) shown << shownOne(part);
  return shown.join(separator);
}

}  // namespace hapticell::app
