// SPDX-License-Identifier: Apache-2.0
#include "app/guides/detents_text.h"

#include <QRegularExpression>
#include <QStringList>
#include <map>

#include "app/style/units.h"
#include "geometry/shapes/vector.h"

namespace hapticell::app {

namespace {

/// SI of one such unit; 0 for an unknown word.
double unitNamed(const QString& word, bool turns) {
  static const std::map<QString, double> angles{{"°", kDegree}, {"deg", kDegree}, {"rad", 1.0}};
  static const std::map<QString, double> lengths{{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}};
  const auto& names = turns ? angles : lengths;
  const auto found = names.find(word.toLower());
  return found == names.end() ? 0.0 : found->second;
}

}  // namespace

QString detentsText(std::span<const double> places, bool turns) {
  if (places.empty()) return {};
  const Units units = unitsNow();
  QStringList words;
  for (const double place : places) {
    words << (turns ? numberText(place * units.perRadian(), units.angle_decimals)
                    : numberText(place * units.perMetre(), units.length_decimals));
  }
  words << (turns ? units.angleUnit() : units.lengthUnit());
  return words.join(' ');
}

std::vector<double> readDetents(const QString& text, bool turns, const std::vector<double>& before) {
  if (text.simplified() == detentsText(before, turns)) return before;
  const Units units = unitsNow();
  double unit = 1.0 / (turns ? units.perRadian() : units.perMetre());
  std::vector<double> numbers;
  static const QRegularExpression number(QStringLiteral("[-+]?\\d*[.,]?\\d+(?:[eE][-+]?\\d+)?|[^\\s;\\d]+"));
  for (auto each = number.globalMatch(text); each.hasNext();) {
    const QString word = each.next().captured();
    bool good = false;
    const double value = QString(word).replace(',', '.').toDouble(&good);
    if (good) numbers.push_back(value);
    if (const double named = good ? 0.0 : unitNamed(word, turns); named > 0.0) unit = named;
  }
  for (double& value : numbers) value *= unit;
  return numbers;
}

}  // namespace hapticell::app
