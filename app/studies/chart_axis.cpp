// SPDX-License-Identifier: Apache-2.0
#include "app/studies/chart_axis.h"

#include <algorithm>
#include <cmath>

#include "app/studies/result_table.h"

namespace hapticell::app {

namespace {

/// Ticks of an axis: half are too few to read values, twice stand on each other in a low dock.
constexpr int kTicks = 5;
/// Share of the range that is left free at each end: half, points touch the frame; twice, the chart shrinks.
constexpr double kFree = 0.04;

}  // namespace

std::vector<double> roundTicks(double least, double greatest, int count) {
  const double step = (greatest - least) / std::max(1, count);
  if (!(step > 0.0) || !std::isfinite(step)) return {least};
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  double round = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= step) round = factor * power;
  std::vector<double> ticks;
  for (double tick = std::ceil(least / round); tick * round <= greatest + 1e-9 * round; tick += 1.0)
    ticks.push_back(tick * round + 0.0);
  return ticks;
}

ChartAxis ChartAxis::over(const ResultTable& table, int column) {
  ChartAxis axis;
  axis.column = column;
  const std::size_t rows = table.rows().size();
  if (!table.isNumber(column) && column != ResultTable::kFeasible) {
    for (std::size_t row = 0; row < rows; ++row) axis.words.push_back(table.word(row, column));
    std::sort(axis.words.begin(), axis.words.end());
    axis.words.erase(std::unique(axis.words.begin(), axis.words.end()), axis.words.end());
    for (std::size_t i = 0; i < axis.words.size(); ++i) axis.ticks.push_back(static_cast<double>(i));
    axis.least = -0.5;
    axis.greatest = std::max(0.5, static_cast<double>(axis.words.size()) - 0.5);
    return axis;
  }
  bool first = true;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto value = table.number(row, column);
    if (!value) continue;
    axis.least = first ? *value : std::min(axis.least, *value);
    axis.greatest = first ? *value : std::max(axis.greatest, *value);
    first = false;
  }
  const double range = axis.greatest - axis.least;
  const double free = range > 0.0 ? kFree * range : std::max(0.5, 0.1 * std::abs(axis.least));
  axis.least -= free;
  axis.greatest += free;
  axis.ticks = roundTicks(axis.least, axis.greatest, kTicks);
  return axis;
}

double ChartAxis::shareOf(const ResultTable& table, std::size_t row) const {
  if (words.empty()) {
    const auto value = table.number(row, column);
    return value ? share(*value) : -1.0;
  }
  const auto found = std::lower_bound(words.begin(), words.end(), table.word(row, column));
  return found == words.end() ? -1.0 : share(static_cast<double>(found - words.begin()));
}

QString ChartAxis::tickText(double tick) const {
  if (words.empty()) return QString::number(tick, 'g', 4);
  const auto at = static_cast<std::size_t>(std::lround(tick));
  return at < words.size() ? words[at] : QString();
}

}  // namespace hapticell::app
